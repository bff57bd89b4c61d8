"""Values set from outside: `--set vars.rows=40` puts 40 for what the file says at that place.

A path goes through keys, and through lists by index or by id, with a point before each part. It is applied to what the
author wrote, before anything is made of that.
"""

from __future__ import annotations

import copy
from collections.abc import Collection, Mapping
from typing import Any

from pydantic import BaseModel

from sandbox.errors import Problem, SceneError
from sandbox.scene.authoring.blame import Expansion
from sandbox.scene.finding import Path, quoted
from sandbox.scene.near_names import nearest
from sandbox.scene.scene_fields import SceneFields
from sandbox.scene.unknown import model_at, names

_SHOWN = 8


class _LostError(Exception):
    """A path leads nowhere."""


def with_changes(data: Any, values: Mapping[str, Any], source: str) -> dict[Path, str]:
    """Set values in parsed data; the paths that were set, each with the words for it. Raises `SceneError`."""
    changed: dict[Path, str] = {}
    problems = []
    prefix = f"{source}: --set "
    for words, value in values.items():
        try:
            changed[_set(data, words, value)] = prefix + words
        except _LostError as lost:
            problems.append(Problem(str(lost.args[0]), hint=lost.args[1], source=prefix + words))
    if problems:
        raise SceneError(source, problems)
    return changed


def check_numbers_set(expansion: Expansion, before: Collection[str]) -> None:
    """A number that is set must be one of `before`, those of the scene itself, or of what it includes.

    Raises `SceneError`.
    """
    known = {*before, *expansion.library.brought}
    problems = []
    for path, words in expansion.main.changed.items():
        name = str(path[-1])
        if len(path) != 2 or path[0] != "vars":
            continue
        if name not in known:
            near = nearest(name, known)
            listed = ", ".join(sorted(known)[:_SHOWN])
            mend = f'did you mean "vars.{near}"?' if near else f"it has {listed}" if known else ""
            problems.append(Problem(f"the scene has no number {quoted(name)}", hint=mend, source=words))
    if problems:
        raise SceneError(expansion.main.source, problems)


def _set(data: Any, words: str, value: Any) -> Path:
    """Put `value` at a path; the path, with indices."""
    parts = words.split(".")
    node, path = data, ()  # type: tuple[Any, Path]
    while parts:
        key, count = _step(node, parts, path)
        parts = parts[count:]
        path = (*path, key)
        if not parts:
            node[key] = copy.deepcopy(value)
        elif isinstance(node, dict) and key not in node:
            node[key] = _default(path)
        node = node[key]
    return path


def _step(node: Any, parts: list[str], path: Path) -> tuple[str | int, int]:
    """The key or index that the first of `parts` mean in `node`, and how many they are: an id may have points."""
    for count in range(len(parts), 0, -1):
        name = ".".join(parts[:count])
        if isinstance(node, dict) and name in node:
            return name, count
        if isinstance(node, list):
            found = [k for k, entry in enumerate(node) if isinstance(entry, dict) and entry.get("id") == name]
            if found:
                return found[0], count
    first = parts[0]
    if isinstance(node, list) and first.isascii() and first.isdigit() and int(first[:9]) < len(node):
        return int(first[:9]), 1
    if isinstance(node, dict) and (len(parts) == 1 or _default((*path, first)) is not None):
        _check_new(node, first, path)
        return first, 1
    raise _LostError(_nothing(node, first, path), _near(node, parts, path))


def _check_new(node: dict[str, Any], name: str, path: Path) -> None:
    """A key that is not there yet must be one that may be."""
    known = _fields(path)
    if known and name not in known:
        raise _LostError(_nothing(node, name, path), _near(node, [name], path))


def _fields(path: Path) -> list[str]:
    if path and path[0] == "vars":
        return []
    return names(model_at(path, SceneFields)) if path else names(SceneFields)


def _default(path: Path) -> Any:
    """What a field holds that is not given, as a file would say it; None if there is no such field, or nothing."""
    model: type[BaseModel] | None = model_at(path[:-1], SceneFields) if len(path) > 1 else SceneFields
    field = model.model_fields.get(str(path[-1])) if model else None
    default = field.default if field else None
    if isinstance(default, BaseModel):
        return {}
    if isinstance(default, tuple):
        return list(default)
    if isinstance(default, dict):
        return {}
    inner = model_at(path, SceneFields)
    return {} if field is not None and default is None and inner is not None else None


def _nothing(node: Any, name: str, path: Path) -> str:
    where = ".".join(map(str, path)) or "the scene"
    if isinstance(node, list):
        has = f"{len(node)} entries" if len(node) != 1 else "one entry"
        return f"{where} has no {quoted(name)}; it has {has}, and no id of that name"
    if isinstance(node, dict) and name in _fields(path):
        return f"{where} has no {quoted(name)} in which something could be set: set all of it"
    if isinstance(node, dict):
        return f"{where} has no {quoted(name)}"
    return f"{where} is a value by itself, and has no {quoted(name)}"


def _near(node: Any, parts: list[str], path: Path) -> str:
    """The nearest names that there are, for as much of the path as an id may take; none where the first is one."""
    if isinstance(node, dict) and parts[0] in _fields(path):
        return ""
    known = [*node, *_fields(path)] if isinstance(node, dict) else []
    if isinstance(node, list):
        known = [str(entry["id"]) for entry in node if isinstance(entry, dict) and isinstance(entry.get("id"), str)]
    found = (nearest(".".join(parts[:count]), known) for count in range(1, len(parts) + 1))
    near = next((name for name in found if name), None)
    return f'did you mean "{near}"?' if near else ""
