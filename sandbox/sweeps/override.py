"""Other values in the document of a scene, by paths such as `bodies.crate.position.0`.

The seam between sweeps and the words of a scene file: nothing else here knows how a document is built.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping
from typing import Any

from pydantic import BaseModel

from sandbox.arguments import shown
from sandbox.errors import ArgumentError
from sandbox.scene import Scene
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.scene_fields import SceneFields

SEED = "seed"
"""The path that stands for the seed of every generator which has one."""


def scene_with(document: Mapping[str, Any], values: Mapping[str, Any]) -> Scene:
    """The scene of a document that is `prepared` for the paths of `values`, with that value at each of them.

    A path leads through keys, the numbers of entries from 0, and their ids, with dots between. Raises `ArgumentError`
    where a path leads nowhere, `SceneError` where the scene cannot be with such values.
    """
    changed = copy.deepcopy(dict(document))
    for path, value in values.items():
        _put(changed, path, value)
    return Scene(**changed)


def prepared(data: Mapping[str, Any], paths: Iterable[str]) -> dict[str, Any]:
    """The document of a scene with all that `paths` lead through written out, where it was left to its default.

    Raises `ArgumentError` that names the first path which leads nowhere.
    """
    document = copy.deepcopy(dict(data))
    scene = Scene(**document)
    for path in paths:
        if path != SEED:
            _write_out(document, scene, path)
        _put(copy.deepcopy(document), path, 0)
    return document


def _write_out(document: dict[str, Any], scene: Scene, path: str) -> None:
    """Write what a path leads through into the document, where only the `scene` that is made of it has it."""
    node: Any = document
    model: Any = scene
    for part in _parts(path)[:-1]:
        if isinstance(node, dict) and part not in node and isinstance(model, BaseModel):
            default = _plain(getattr(model, part, None))
            if default is not None:
                node[part] = default
        at = _key(node, part, path)
        node = node[at]
        model = getattr(model, str(at), None) if isinstance(model, BaseModel) else model[at]


def _plain(value: Any) -> Any:
    """A value of a model as a document has it; a model is empty there, as what it leaves out is its default."""
    if isinstance(value, BaseModel):
        return {}
    return list(value) if isinstance(value, tuple) else value


def _put(document: dict[str, Any], path: str, value: Any) -> None:
    if path == SEED:
        _put_seeds(document, value)
        return
    *parents, last = _parts(path)
    node: Any = document
    for part in parents:
        node = node[_key(node, part, path)]
    at = last if isinstance(node, dict) else _key(node, last, path)
    node[at] = value


def _parts(path: str) -> list[str]:
    parts = path.split(".")
    if not all(parts):
        raise ArgumentError(f"{path or 'a path'}: a path is keys and ids with dots between, such as gravity.1")
    known = [field.alias or name for name, field in SceneFields.model_fields.items()]
    if parts[0] not in known:
        hint = did_you_mean(parts[0], known) or f"it has {', '.join(known[2:])}"
        raise ArgumentError(f"{path}: a scene has no {parts[0]!r}; {hint}")
    return parts


def _key(node: Any, part: str, path: str) -> str | int:
    """What part of a path leads to in a node: a key, or the place of an entry by its number or its id."""
    if isinstance(node, dict):
        if part in node:
            return part
        raise ArgumentError(f"{path}: there is no {part!r}; {_instead(part, list(node))}")
    if not isinstance(node, list):
        raise ArgumentError(f"{path}: {part!r} is looked for in {shown(node)}, which has nothing inside")
    if part.isdecimal() and len(part) < 9:
        if int(part) < len(node):
            return int(part)
        raise ArgumentError(f"{path}: there is no entry {part}; there are {len(node)}, counted from 0")
    names = [str(entry.get("id", "")) if isinstance(entry, dict) else "" for entry in node]
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
