"""From a file of another program to a scene."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sandbox.arguments import check_kind, check_path, checked_list, checked_number
from sandbox.errors import Problem, SceneError
from sandbox.formats.draft import Draft
from sandbox.formats.open_file import open_source
from sandbox.formats.reading import MisreadError
from sandbox.formats.remarks import Remark, Remarks
from sandbox.formats.source import Options, Source
from sandbox.formats.table import FORMATS, Format
from sandbox.formats.xml_tree import Element
from sandbox.resources import SCENE_SUFFIX
from sandbox.scene.effort import one_effort
from sandbox.scene.load import load_scene, loads_scene
from sandbox.scene.scene import Scene


@dataclass(frozen=True)
class Imported:
    """A `scene` made of a file in `format` ("" for a scene file), and `remarks`: what it does not carry over."""

    scene: Scene
    format: str = ""
    remarks: tuple[Remark, ...] = ()


def import_scene(
    path: str | os.PathLike[str],
    format: str = "",
    units_per_metre: float | None = None,
    tolerance: float = 0.01,
    solid: Sequence[str] = (),
) -> Imported:
    """The scene in a file of another program; `format` is one of `FORMATS`, by default told from its contents.

    `units_per_metre` says how many units of the file (pixels) make a metre, None: as its format has it. `tolerance` is
    how far flat sides may lie from the curve that they stand for, m. `solid` are names of layers of a map of Tiled that
    are solid all over. Raises `SceneError` with the place of what cannot be used, and `ArgumentError`.
    """
    check_path("import_scene", path)
    check_kind("import_scene", "the name of a format", format, str)
    options = _options(units_per_metre, tolerance, solid)
    source = open_source(Path(path))
    kind = _named(source, format) if format else _found(source)
    if kind is None:
        raise SceneError(str(path), [_unknown(source)])
    if options.solid and kind.name != "tiled":
        raise SceneError(
            str(path), [Problem(f"layers can be made solid in a map of Tiled alone; this is {kind.title}")]
        )
    return _import(source, kind, options)


def open_scene(path: str | os.PathLike[str], set: Mapping[str, Any] | None = None) -> Imported:
    """The scene in a file, which is a scene or of another program, as its contents tell.

    `set` as `load_scene` takes it, for scenes alone. Raises `SceneError`.
    """
    check_path("open_scene", path)
    file = Path(path)
    if file.name.endswith(SCENE_SUFFIX):
        return Imported(load_scene(file, set))
    source = open_source(file)
    kind = _found(source)
    if kind is None and (isinstance(source.data, Element) or _part(source.data)):
        raise SceneError(str(path), [_unknown(source)])
    if kind is not None and set:
        mend = "make a scene of it with sandbox import first"
        raise SceneError(str(path), [Problem("values can be set of scenes alone", hint=mend)])
    return Imported(loads_scene(source.text, str(file), set)) if kind is None else _import(source, kind, Options())


def _options(units_per_metre: float | None, tolerance: float, solid: Sequence[str]) -> Options:
    units = units_per_metre
    if units is not None:
        units = checked_number("import_scene", "units_per_metre", units, 1e-6, 1e9)
    layers = [solid] if isinstance(solid, str) else checked_list("import_scene", "a list of layers for solid", solid)
    return Options(units, checked_number("import_scene", "tolerance", tolerance, 1e-5, 1.0), tuple(layers))


_PARTS = {
    "tileset": "this is a tileset of Tiled: import a map that uses it",
    "template": "this is a template of Tiled: import a map that uses it",
    "world": "this is a world of Tiled: import its maps, one by one",
}


def _unknown(source: Source) -> Problem:
    if part := _part(source.data):
        return Problem(_PARTS[part])
    if isinstance(source.data, dict) and {"bodies", "generate"} & source.data.keys():
        return Problem("this is a scene already")
    known = ", ".join(each.name for each in FORMATS)
    return Problem(f"this is in no format that can be imported ({known})")


def _part(data: Any) -> str:
    """What of Tiled it is that is no map; "" for anything else."""
    if isinstance(data, Element):
        return data.tag if data.tag in _PARTS else ""
    if not isinstance(data, dict):
        return ""
    kind = data.get("type") or ("world" if "onlyShowAdjacentMaps" in data else "")
    return kind if isinstance(kind, str) and kind in _PARTS else ""


def _found(source: Source) -> Format | None:
    return next((each for each in FORMATS if each.matches(source.data)), None)


def _named(source: Source, name: str) -> Format:
    kind = next((each for each in FORMATS if each.name == name), None)
    if kind is None:
        raise SceneError(
            f"format {name}", [Problem(f"no such format; known are {', '.join(each.name for each in FORMATS)}")]
        )
    if not kind.matches(source.data):
        raise SceneError(str(source.path), [Problem(f"this is no file of the format {name} ({kind.title})")])
    return kind


@one_effort()
def _import(source: Source, kind: Format, options: Options) -> Imported:
    remarks = Remarks()
    draft = Draft(source.path.name.partition(".")[0], remarks)
    try:
        kind.read(source, draft, options)
    except MisreadError as error:
        raise source.error(error) from None
    scene = draft.scene(str(source.path))
    return Imported(scene, kind.name, tuple(remarks))
