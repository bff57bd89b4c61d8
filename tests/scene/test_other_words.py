"""Words that authors bring from other engines lead to ours."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest

from sandbox.errors import SceneError
from sandbox.scene import loads_scene, schema
from sandbox.scene.other_words import OURS, meant_by

CRATE = {"id": "crate", "shapes": [{"box": [1, 1]}]}


def joined(**fields: Any) -> dict[str, Any]:
    return {"bodies": [CRATE], "joints": [{"id": "j", "type": "revolute", "bodies": ["crate"], **fields}]}


@pytest.mark.parametrize(
    ("scene", "told"),
    [
        ({"bodies": [{**CRATE, "rotation": 30}]}, 'unknown field "rotation": did you mean "angle"?'),
        ({"bodies": [{**CRATE, "pos": [0, 1]}]}, 'unknown field "pos": did you mean "position"?'),
        ({"bodies": [{**CRATE, "linearVelocity": [0, 1]}]}, 'unknown field "linearVelocity": did you mean "velocity"?'),
        ({"bodies": [{"id": "a", "shapes": [{"rect": [1, 1]}]}]}, 'unknown field "rect": did you mean "box"?'),
        ({"bodies": [{"id": "a", "shapes": [{"circle": 1, "position": [0, 1]}]}]},
         'unknown field "position": did you mean "at"?'),
        ({"bodies": [{"id": "a", "shapes": [{"circle": 1, "isSensor": True}]}]},
         'unknown field "isSensor": did you mean "sensor"?'),
        ({"bodies": [{"name": "a", "shapes": [{"circle": 1}]}]}, 'unknown field "name": did you mean "id"?'),
        ({"bodies": [{**CRATE, "type": "fixed"}]}, 'did you mean "static"?'),
        (joined(type="hinge", anchor=[0, 0]), 'did you mean "revolute"?'),
        (joined(pivot=[0, 0]), 'unknown field "pivot": did you mean "anchor"?'),
        ({"bodies": [CRATE], "expect": [{"at": 9, "position": [0, 0], "of": "crate"}]},
         'unknown field "position": did you mean "near"?'),
        ({"bodies": [CRATE], "expect": [{"step": 9, "rests": "crate"}]}, 'unknown field "step": did you mean "at"?'),
        ({"rules": [{"on": {"time": 1}, "then": [{"win": "x"}]}]}, 'unknown field "then": did you mean "do"?'),
    ],
)  # fmt: skip
def test_a_word_from_elsewhere_is_told_ours(scene: dict[str, Any], told: str) -> None:
    with pytest.raises(SceneError) as caught:
        loads_scene(json.dumps(scene))
    assert told in [f"{p.message}: {p.hint}" if "unknown" in p.message else p.hint for p in caught.value.problems]
    assert all("is missing" not in one.message and "needs a" not in one.message for one in caught.value.problems)


def test_all_of_ours_are_words_of_the_format() -> None:
    assert set(OURS) - set(_words(schema())) == set()


def test_a_name_that_is_there_is_meant_by_itself() -> None:
    assert meant_by("position", ["position", "at"]) is None
    assert meant_by("position", ["at", "angle"]) == "at"
    assert meant_by("ROTATION", ["angle"]) == "angle"
    assert meant_by("rotation", ["velocity"]) is None


def _words(node: Any) -> Iterator[str]:
    """All fields and choices of a schema."""
    if isinstance(node, dict):
        yield from node.get("properties", {})
        yield from (choice for choice in node.get("enum", []) if isinstance(choice, str))
        yield from ([node["const"]] if isinstance(node.get("const"), str) else [])
        for inner in node.values():
            yield from _words(inner)
    elif isinstance(node, list):
        for inner in node:
            yield from _words(inner)
