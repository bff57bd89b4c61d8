"""Bad numbers freeze the body that has them, say so, and stop there."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox import ApplyForce, SetPose, SetVelocity
from sandbox.errors import CommandError
from tests.flat import body, box, circle, ground, world


def stack():
    """Three crates on the ground."""
    return world(ground(), *(body(f"{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(3)))


def finite(w) -> bool:
    """Whether all numbers of bodies and contacts are finite."""
    return all(np.isfinite(t[n]).all() for t in (w.state.bodies, w.contacts) for n in t.dtype.names)


@pytest.mark.parametrize("force", [(1e300, 0.0), (0.0, -1e300), (1e308, 1e308)])
def test_a_monstrous_force_freezes_the_body_where_it_is(force):
    w = stack()
    w.step(30)
    place = w.body("1").position
    w.apply(ApplyForce("1", force))
    w.step()
    assert w.frozen == [("1", 30)]
    assert w.body("1").type == "static"
    assert w.body("1").position == place
    assert w.body("1").velocity == (0.0, 0.0)
    w.step(120)
    assert finite(w)
    assert w.frozen == [("1", 30)]
    assert w.body("1").position == place
    assert w.body("2").position == pytest.approx((0.0, 2.5), abs=0.02), "neighbours go on as before"
    assert w.body("0").position == pytest.approx((0.0, 0.5), abs=0.02)


def test_a_monstrous_torque_freezes_too():
    w = stack()
    w.apply(ApplyForce("2", (0.0, 0.0), 1e305))
    w.step(10)
    assert w.frozen == [("2", 0)]
    assert finite(w)


@pytest.mark.parametrize("where", [(9.99e8, 0.0), (0.0, -9.99e8)])
def test_a_body_that_leaves_the_world_is_frozen(where):
    w = world(body("a", circle(0.5), position=where, gravity_scale=0.0), body("b", circle(0.5)), gravity=(0.0, 0.0))
    w.apply(SetVelocity("a", (1e6 * np.sign(where[0]), 1e6 * np.sign(where[1])), 0.0))
    w.step(120)
    assert [name for name, _ in w.frozen] == ["a"]
    assert 50 < w.frozen[0][1] < 62
    assert np.abs(w.bodies.position).max() <= 1e9
    assert w.body("b").type == "dynamic"


def test_a_kinematic_body_that_leaves_is_frozen():
    w = world(body("a", circle(0.5), type="kinematic", position=(9.9999e8, 0.0), velocity=(1e6, 0.0)))
    w.step(60)
    assert [name for name, _ in w.frozen] == ["a"]


def test_a_frozen_body_refuses_to_be_pushed_and_can_be_moved():
    w = stack()
    w.apply(ApplyForce("2", (1e300, 0.0)))
    w.step()
    for command in (ApplyForce("2", (1.0, 0.0)), SetVelocity("2", (1.0, 0.0), 0.0)):
        with pytest.raises(CommandError):
            w.apply(command)
    w.apply(SetPose("2", (5.0, 5.0), 0.0))
    w.step(10)
    assert w.body("2").position == (5.0, 5.0)


def test_freezing_survives_snapshot_and_restore():
    w = stack()
    w.apply(ApplyForce("2", (1e300, 0.0)))
    w.step()
    saved = w.snapshot()
    other = stack()
    other.restore(saved)
    assert other.frozen == w.frozen
    w.step(20)
    other.step(20)
    assert other.digest() == w.digest()


def test_a_blow_at_the_highest_speed_leaves_finite_numbers():
    w = world(body("a", circle(0.5, restitution=1.0), position=(-3.0, 0.0)), body("b", circle(0.5)), gravity=(0.0, 0.0))
    w.apply(SetVelocity("a", (1e6, 0.0), 1e6))
    w.step(10)
    assert finite(w)


def test_a_dust_grain_between_giants_stays_finite():
    w = world(
        ground(),
        body("dust", circle(0.001, density=1e-3), position=(0.0, 0.001)),
        body("rock", box(10.0, 10.0, density=1e4), position=(0.0, 5.002)),
    )
    w.step(300)
    assert finite(w)
    assert w.frozen == []


def test_many_bodies_in_one_place_stay_finite_and_part():
    w = world(*(body(f"{i}", circle(0.5) if i % 2 else box(1.0, 1.0)) for i in range(40)), gravity=(0.0, 0.0))
    w.step(300)
    assert finite(w)
    assert w.frozen == []
    spread = w.bodies.position.max(axis=0) - w.bodies.position.min(axis=0)
    assert spread.max() > 3.0
    assert spread.max() < 300.0
