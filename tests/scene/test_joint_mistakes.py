"""Mistakes in joints: each is told in one plain line, at its place."""

from __future__ import annotations

import pytest

from tests.scene.scene_helpers import one

BODIES = (
    '{"id": "door", "shapes": [{"circle": 1}]}, {"id": "frame", "type": "static", "shapes": [{"circle": 1}]}, '
    '{"id": "belt", "type": "kinematic", "shapes": [{"circle": 1}]}'
)


def joint(fields: str) -> str:
    return f'{{"bodies": [{BODIES}], "joints": [\n{{"id": "j", {fields}}}\n]}}'


def hinge(fields: str) -> str:
    return joint(f'"type": "revolute", "anchor": [0, 0], {fields}')


def slide(fields: str) -> str:
    return joint(f'"type": "prismatic", "bodies": ["door"], "anchor": [0, 0], {fields}')


def wheel(fields: str) -> str:
    return joint(f'"type": "wheel", "bodies": ["frame", "door"], "anchor": [0, 0], {fields}')


def rope(fields: str) -> str:
    return joint(f'"type": "distance", "bodies": ["door"], "anchors": [[0, 2], [0, 0]], {fields}')


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (hinge('"bodies": ["dor"]'), 'no body has the id "dor": did you mean "door"?'),
        (hinge('"bodies": ["frame", "nobody"]'), 'no body has the id "nobody"'),
        (hinge('"bodies": ["door", "door"]'), '"door" cannot be joined to itself'),
        (hinge('"bodies": []'), "bodies needs at least 1"),
        (hinge('"bodies": [null]'), "a joint needs at least one body"),
        (hinge('"bodies": [null, null]'), "a joint needs at least one body"),
        (hinge('"bodies": ["frame"]'), 'the joint "j" joins nothing that can move'),
        (hinge('"bodies": ["frame", "belt"]'), 'the joint "j" joins nothing that can move'),
        (hinge('"bodies": ["door"], "lower": 30, "upper": -30'), '"lower" must not be greater than "upper"'),
        (slide('"axis": [1, 0], "lower": 2, "upper": 1'), '"lower" must not be greater than "upper"'),
        (rope('"min": 3, "max": 1'), '"min" must not be greater than "max"'),
        (slide('"axis": [0, 0]'), "axis must point somewhere"),
        (wheel('"axis": [0, 0]'), "axis must point somewhere"),
    ],
)
def test_a_mistake_in_a_joint_is_one_line(text, told):
    assert told in one(text)
