"""Newton's cradle whose balls hang on rods or hinges: joints take nothing of its impacts, however many balls it has."""

from __future__ import annotations

import math

import pytest

from sandbox import Scene
from sandbox.engine.world import World

_LENGTH, _TURN = 4.0, math.radians(40.0)
_RISE = _LENGTH * (1.0 - math.cos(_TURN))


def cradle(count: int, kind: str) -> World:
    bodies, joints = [], []
    for k in range(count):
        turn = _TURN if k == 0 else 0.0
        place = [k - _LENGTH * math.sin(turn), -_LENGTH * math.cos(turn)]
        ball = {"circle": 0.5, "restitution": 1.0, "friction": 0.0}
        bodies.append({"id": f"b{k}", "position": place, "shapes": [ball]})
        if kind == "rod":
            rod = {"type": "distance", "bodies": [None, f"b{k}"], "anchors": [[k, 0], place]}
        else:
            rod = {"type": "revolute", "bodies": [None, f"b{k}"], "anchor": [k, 0]}
        joints.append({"id": f"j{k}", **rod})
    return World(Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))


@pytest.mark.parametrize(
    ("count", "kind"), [(3, "rod"), (5, "rod"), (12, "rod"), (20, "rod"), (3, "hinge"), (5, "hinge")]
)
def test_the_last_ball_rises_as_high_as_the_first_was(count: int, kind: str):
    world = cradle(count, kind)
    highest = [0.0] * count
    for _ in range(130):  # half a swing of each
        world.step()
        for k in range(1, count):
            highest[k] = max(highest[k], world.body(f"b{k}").position[1] + _LENGTH)
    assert highest[-1] == pytest.approx(_RISE, rel=1e-3)
    assert max(highest[:-1]) < 1e-3
