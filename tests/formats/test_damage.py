"""Small files of every format with each value missing, or replaced by what it cannot be: a scene, or one message."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from typing import Any

import pytest

from sandbox.errors import SceneError
from tests.formats.conftest import Read

SQUARE = {"x": [-1, 1, 1, -1], "y": [-1, -1, 1, 1]}
SHAPES = [
    {"polygon": {"vertices": SQUARE}, "density": 1},
    {"circle": {"center": {"x": 0, "y": 2}, "radius": 1}, "filter-maskBits": 3},
    {"chain": {"vertices": SQUARE, "hasPrevVertex": True, "prevVertex": 0}},
]
PIN = {"type": "revolute", "bodyA": 0, "bodyB": 1, "anchorA": {"x": 0, "y": 5}, "anchorB": 0, "enableLimit": True,
       "lowerLimit": -1, "upperLimit": 1}  # fmt: skip
HERO = {"name": "hero", "type": 2, "position": {"x": 0, "y": 5}, "massData-mass": 2, "massData-I": 9}
RUBE = {"gravity": {"x": 0, "y": -10}, "body": [{"type": 0, "fixture": SHAPES[2:]}, {**HERO, "fixture": SHAPES[:2]}],
        "joint": [PIN]}  # fmt: skip
DRAWN = {"vertices": SQUARE, "shapes": [{"type": "polygon"}, {"type": "circle", "radius": 1}]}
SAVED = {"metaworld": {"gravity": 0, "metabody": [{**HERO, "id": 4, "type": "dynamic", "fixture": [DRAWN]}]}}
PLANCK = [
    {"gravity": {"x": 0, "y": -10}, "bodies": [{"refIndex": 1, "refType": "Body"}], "joints": []},
    {"type": "dynamic", "position": {"x": 0, "y": 1}, "fixtures": [{"refIndex": 2, "refType": "Fixture"}]},
    {"density": 1, "shape": {"refIndex": 3, "refType": "Shape"}},
    {"type": "polygon", "vertices": [{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]},
]
TILES = {"firstgid": 1, "tilewidth": 16, "tileheight": 16, "tiles": [
    {"id": 0, "imagewidth": 16, "imageheight": 16, "objectgroup": {"objects": [{"x": 0, "y": 0, "width": 16,
     "height": 16, "rotation": 45}]}}]}  # fmt: skip
TILED = {
    "width": 2, "height": 1, "tilewidth": 16, "tileheight": 16, "orientation": "hexagonal", "hexsidelength": 8,
    "tilesets": [TILES],
    "layers": [
        {"type": "tilelayer", "name": "a", "width": 2, "height": 1, "data": [1, 1610612737]},
        {"type": "objectgroup", "offsetx": 2, "objects": [
            {"gid": 1, "x": 0, "y": 0, "width": 8, "height": 8, "properties": [{"name": "density", "value": 2}]},
            {"x": 1, "y": 1, "polygon": [{"x": 0, "y": 0}, {"x": 9, "y": 9}, {"x": 9, "y": 0}, {"x": 0, "y": 9}]}]},
    ],
}  # fmt: skip
EDITOR = {"rigidBodies": [{"name": "rock", "origin": {"x": 0, "y": 0}, "polygons": [PLANCK[3]["vertices"]],
                           "circles": [{"cx": 0, "cy": 0, "r": 1}], "shapes": []}]}  # fmt: skip
MATTER = {"star": {"type": "fromPhysicsEditor", "density": 1, "fixtures": [
    {"vertices": [PLANCK[3]["vertices"]]}, {"circle": {"x": 0, "y": 0, "radius": 3}}]}}  # fmt: skip
FILES = {"rube": RUBE, "saved": SAVED, "planck": PLANCK, "tiled": TILED, "editor": EDITOR, "matter": MATTER}
OTHERS = (None, "", "x", -1, 1e18, float("nan"), [], {}, [{}], {"x": 1})
MISSING = object()


def paths(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    if path:
        yield path
    keys = data if isinstance(data, dict) else range(len(data)) if isinstance(data, list) else ()
    for key in keys:
        yield from paths(data[key], (*path, key))


def damaged(data: Any) -> Iterator[str]:
    """Each value missing, and as two others, in turn."""
    for k, path in enumerate(paths(data)):
        for value in (MISSING, OTHERS[k % len(OTHERS)], OTHERS[(3 * k + 1) % len(OTHERS)]):
            changed = copy.deepcopy(data)
            holder = changed
            for key in path[:-1]:
                holder = holder[key]
            if value is MISSING:
                del holder[path[-1]]
            else:
                holder[path[-1]] = value
            yield json.dumps(changed)


def told(read: Read, text: str) -> int:
    """How many messages there are."""
    try:
        read(text)
    except SceneError as error:
        return 1 if "unknown field" in str(error) else len(error.problems)  # unknown: it was taken for a scene
    return 0


@pytest.mark.parametrize("name", FILES)
def test_it_is_a_scene_or_one_message(read: Read, name: str) -> None:
    assert read(FILES[name]).scene.bodies
    assert [text for text in damaged(FILES[name]) if told(read, text) > 1] == []


DRAWING = """<svg width="64" height="64" viewBox="0 0 32 32"><style>.a{fill:red}</style><defs><g id="g"><rect class="a"
 width="9" height="9" rx="2" transform="rotate(9)"/></g></defs><use href="#g" x="3"/><path fill-rule="evenodd"
 d="M0 0h9v9h-9z M2 2l4 4h-4l4-4z"/><polyline points="0,0 9,9 3,4" stroke-width="2" stroke="red" fill="none"/></svg>"""


def test_drawings_are_scenes_or_one_message(read: Read) -> None:
    for at in range(5, len(DRAWING), 5):
        before, after = DRAWING[:at], DRAWING[at + 2 :]
        assert [text for text in (before, before + after, before + "9e9" + after) if told(read, text) > 1] == []
