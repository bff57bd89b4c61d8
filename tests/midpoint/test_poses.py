"""Bodies that are put ahead come back: where they end does not depend on it."""

from __future__ import annotations

import math

import pytest

from sandbox.engine.bodies.flags import AHEAD
from tests.flat import body, box, circle, ground, world

RATE = 60


def on_a_turntable(*others):
    """A drum that turns by itself, with a ball that rolls on it, and whoever else is there."""
    drum = body("drum", circle(1.0, friction=1.0), type="kinematic", position=(0.0, 1.0), angular_velocity=2.0)
    ball = body("ball", circle(0.2, friction=1.0), position=(0.02, 2.2), angular_velocity=-10.0)
    return world(ground(), drum, ball, *others)


def is_ahead(w, name: str) -> bool:
    return bool(w.scratch.solver.flags[list(w.bodies.ids).index(name)] & AHEAD)


@pytest.mark.parametrize("levels", [1, 2])
def test_a_kinematic_body_goes_where_its_velocity_says(levels):
    """Also where islands take substeps of several levels, for each of which it begins anew."""
    heavy = [
        body("light", box(0.5, 0.5, density=1.0), position=(8.0, 0.25)),
        body("heavy", box(0.5, 0.5, density=1000.0), position=(8.0, 0.75)),
    ]
    w = on_a_turntable(*(heavy if levels == 2 else []))
    ahead = False
    for step in range(1, 31):
        w.step()
        ahead = ahead or is_ahead(w, "drum")
        assert w.body("drum").angle == pytest.approx(2.0 * step / RATE, abs=1e-13)
        assert w.body("drum").position == pytest.approx((0.0, 1.0), abs=1e-15)
    assert ahead
    assert len(set(w.scratch.solver.free_motions.substep_level[2:])) == levels


def test_a_disc_rolls_as_far_as_its_velocity_says():
    """On level ground nothing wanders over the disc, and being put ahead must not show."""
    w = world(
        ground(friction=0.5),
        body("disc", circle(0.5, friction=0.5), position=(0.0, 0.5), velocity=(3.0, 0.0), angular_velocity=-6.0),
    )
    w.step()
    for step in range(2, 121):
        w.step()
        assert is_ahead(w, "disc")
        assert w.body("disc").position[0] == pytest.approx(3.0 * step / RATE, abs=1e-9)
        assert w.body("disc").angle == pytest.approx(-6.0 * step / RATE, abs=1e-9)


def test_who_lies_still_is_not_put_ahead():
    w = world(ground(), *(body(f"b{k}", box(1.0, 1.0), position=(0.0, 0.5 + k)) for k in range(5)))
    w.step(30)
    assert not any(is_ahead(w, f"b{k}") for k in range(5))
    assert math.hypot(*w.body("b4").velocity) < 1e-3
