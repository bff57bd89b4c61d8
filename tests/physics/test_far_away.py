"""A hundred kilometres from the origin things go as they do at it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.flat import body, box, capsule, circle, ground, world

SCENES = {
    "throw": [body("a", box(1.0, 0.5), position=(0.0, 90.0), velocity=(3.0, 4.0), angular_velocity=2.0)],
    "bounce": [body("a", circle(0.5, restitution=0.9), position=(0.3, 4.0))],
    "slide": [body("a", box(1.0, 0.5), position=(0.0, 0.25), velocity=(6.0, 0.0))],
    "roll": [body("a", circle(0.5), position=(0.0, 0.5), velocity=(3.0, 0.0))],
    "stack": [body(f"{i}", box(1.0, 1.0), position=(0.125 * (i % 2), 0.5 + i)) for i in range(5)],
    "row": [body(f"{i}", circle(0.5, restitution=1.0), position=(1.25 * i, 0.5)) for i in range(4)]
    + [body("cue", capsule(0.5, 0.25), position=(-4.0, 0.5), velocity=(5.0, 0.0))],
}
"""Ones in which rounding stays small: in a tumbling heap every blow multiplies it."""


@pytest.mark.parametrize("place", [(1e5, 0.0), (-1e5, 1e5), (0.0, -1e5)])
@pytest.mark.parametrize("name", SCENES)
def test_a_hundred_kilometres_away(name, place):

    bodies = [ground(), *SCENES[name]]
    moved = [replace(b, position=(b.position[0] + place[0], b.position[1] + place[1])) for b in bodies]
    near, away = world(*bodies), world(*moved)
    for _ in range(240):
        near.step()
        away.step()
        assert np.abs(away.bodies.position - place - near.bodies.position).max() < 1e-6
        assert np.abs(away.bodies.angle - near.bodies.angle).max() < 1e-6


def test_a_box_rests_a_million_kilometres_away():
    w = world(
        body("ground", box(10.0, 2.0), type="static", position=(9e8, -9e8)),
        body("crate", box(1.0, 1.0), position=(9e8, -9e8 + 1.5)),
    )
    w.step(600)
    assert w.body("crate").position == pytest.approx((9e8, -9e8 + 1.5), abs=1e-3)
    assert w.frozen == []
