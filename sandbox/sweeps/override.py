"""Other values in the document of a scene, by paths such as `bodies.crate.position.0`.

The seam between sweeps and the words of a scene file: nothing else here knows how a document is built.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping
from typing import Any

from sandbox.arguments import shown
from sandbox.errors import ArgumentError
from sandbox.scene import Scene
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.scene_fields import SceneFields

SEED = "seed"
"""The path that stands for the seed of every generator which has one."""


def scene_with(data: Mapping[str, Any], values: Mapping[str, Any]) -> Scene:
    """The scene of a document in which each path of `values` has that value; the document stays as it is.

    A path leads through keys, the numbers of entries from 0, and their ids, with dots between. Raises `ArgumentError`
    where a path leads nowhere, `SceneError` where the scene cannot be with such values.
    """
    document = copy.deepcopy(dict(data))
    for path, value in values.items():
        _put(document, path, value)
    return Scene(**document)


def check_paths(data: Mapping[str, Any], paths: Iterable[str]) -> None:
    """Whether each path leads somewhere. Raises `ArgumentError` that names the first which does not."""
    for path in paths:
        _put(copy.deepcopy(dict(data)), path, 0)


def _put(document: dict[str, Any], path: str, value: Any) -> None:
    if path == SEED and SEED not in document.get("vars", {}):
        _put_seeds(document, value)
        return
    *parents, last = _parts(document, path)
    node: Any = document
    for depth, part in enumerate(parents):
        node = _child(node, part, path, depth)
    if isinstance(node, list):
        node[_index(node, last, path)] = value
    elif isinstance(node, dict):
        node[last] = value
    else:
        raise ArgumentError(f"{path}: {'.'.join(parents)} is {shown(node)}, which has nothing inside")


def _parts(document: dict[str, Any], path: str) -> list[str]:
    """The keys of a path. `seed` is short for `vars.seed` where a scene has that variable."""
    parts = path.split(".") if path != SEED else ["vars", SEED]
    if not all(parts):
        raise ArgumentError(f"{path or 'a path'}: a path is keys and ids with dots between, such as gravity.1")
    known = [field.alias or name for name, field in SceneFields.model_fields.items()]
    if parts[0] not in (*known, *document):
        raise ArgumentError(f"{path}: a scene has no {parts[0]!r}; {did_you_mean(parts[0], known) or 'see --help'}")
    return parts


def _child(node: Any, part: str, path: str, depth: int) -> Any:
    """What is behind a key or an id; what the document leaves out is as the scene has it by default."""
    if isinstance(node, list):
        return node[_index(node, part, path)]
    if not isinstance(node, dict):
        raise ArgumentError(f"{path}: {part!r} is looked for in {shown(node)}, which has nothing inside")
    if part not in node:
        if depth > 0 and node and all(isinstance(each, dict) for each in node.values()):  # named entries
            raise ArgumentError(f"{path}: there is no {part!r}; {_instead(part, list(node))}")
        node[part] = _default(part) if depth == 0 else {}
    return node[part]


def _default(field: str) -> Any:
    found = SceneFields.model_fields.get(field)
    value = found.default if found is not None else {}
    return list(value) if isinstance(value, tuple) else {}


def _index(entries: list[Any], part: str, path: str) -> int:
    """The place of an entry: by its number, or by its id."""
    if part.isdecimal() and len(part) < 9:
        if int(part) < len(entries):
            return int(part)
        raise ArgumentError(f"{path}: there is no entry {part}; there are {len(entries)}, counted from 0")
    names = [str(entry.get("id", entry.get("body", ""))) if isinstance(entry, dict) else "" for entry in entries]
    if part not in names:
        raise ArgumentError(f"{path}: there is no entry {part!r}; {_instead(part, [name for name in names if name])}")
    return names.index(part)


def _instead(part: str, names: list[str]) -> str:
    most = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
    return did_you_mean(part, names) or (f"there are {most}" if names else "none has an id; give its number, from 0")


def _put_seeds(document: dict[str, Any], value: Any) -> None:
    seeded = [entry for entry in document.get("generate", ()) if "scatter" in entry]
    if not seeded:
        raise ArgumentError("seed: nothing in this scene is random: it has no scatter generator")
    for entry in seeded:
        entry[SEED] = value
