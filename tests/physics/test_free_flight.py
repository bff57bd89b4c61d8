"""Bodies that nothing touches follow the formulas of a first course in mechanics."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from sandbox import ApplyForce
from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, capsule, circle, polygon, world

SECONDS = 10
STEPS = 600
SHAPES = {
    "disc": circle(0.5),
    "disc off centre": circle(0.5, at=(0.7, 0.2)),
    "box": box(1.0, 0.5),
    "capsule": capsule(0.4, 0.1),
    "wedge": polygon((0.0, 0.0), (2.0, 0.0), (0.0, 1.0)),
}


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_a_throw_follows_the_parabola(shape):
    w = world(body("stone", shape, position=(3.0, 40.0), velocity=(7.0, 31.0), angular_velocity=2.0))
    x, y = w.body("stone").center
    for step in range(1, STEPS + 1):
        w.step()
        t = step / 60
        expected = x + 7.0 * t, y + 31.0 * t - 0.5 * 9.81 * t * t
        assert w.body("stone").center == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert w.body("stone").velocity == pytest.approx((7.0, 31.0 - 9.81 * SECONDS), rel=1e-12)
    assert w.body("stone").angle == pytest.approx(2.0 * SECONDS, rel=1e-12)
    assert w.body("stone").angular_velocity == 2.0


@pytest.mark.parametrize("substeps", [1, 2, 4, 7])
@pytest.mark.parametrize("rate", [30.0, 60.0, 1000.0])
def test_free_fall_does_not_depend_on_the_step(substeps, rate):
    settings = FlatSettings(step_rate=rate, substeps=substeps, sleeping=False)
    w = world(body("stone", circle(0.5)), settings=settings)
    w.step(int(2 * rate))
    assert w.body("stone").position == pytest.approx((0.0, -0.5 * 9.81 * 4.0), rel=1e-11)


def test_gravity_may_point_anywhere_and_be_scaled():
    w = world(
        body("plain", circle(0.5)),
        body("balloon", circle(0.5), position=(5.0, 0.0), gravity_scale=-0.5),
        body("dust", circle(0.5), position=(10.0, 0.0), gravity_scale=0.0),
        gravity=(1.0, -2.0),
    )
    w.step(120)
    assert w.bodies.position[0] == pytest.approx((2.0, -4.0))
    assert w.bodies.position[1] == pytest.approx((4.0, 2.0))
    assert tuple(w.bodies.position[2]) == (10.0, 0.0)


def test_a_force_through_the_centre_accelerates_and_a_torque_spins():
    w = world(body("sled", box(2.0, 1.0, density=3.0)), gravity=(0.0, 0.0))
    sled = w.body("sled")
    assert sled.mass == pytest.approx(6.0)
    assert sled.inertia == pytest.approx(6.0 * (4.0 + 1.0) / 12.0)
    for _ in range(60):
        w.apply(ApplyForce("sled", (12.0, -3.0), torque=5.0))
        w.step()
    assert sled.velocity == pytest.approx((2.0, -0.5))
    assert sled.position == pytest.approx((1.0, -0.25))
    assert sled.angular_velocity == pytest.approx(2.0)
    assert sled.angle == pytest.approx(1.0)
    w.step(60)
    assert sled.velocity == pytest.approx((2.0, -0.5)), "a force lasts for one step"


def test_a_spinning_body_keeps_its_spin_and_its_centre():
    w = world(body("top", polygon((0.0, 0.0), (2.0, 0.0), (0.0, 1.0)), angular_velocity=11.0), gravity=(0.0, 0.0))
    before = w.body("top").center
    w.step(6000)
    assert w.body("top").angular_velocity == 11.0
    assert w.body("top").angle == pytest.approx(1100.0, rel=1e-12)
    assert w.body("top").center == before
    cosine, sine = w.state.bodies[0].rotation_cos, w.state.bodies[0].rotation_sin
    assert math.hypot(cosine, sine) == pytest.approx(1.0, abs=1e-15)


def test_the_origin_circles_the_centre_of_mass():
    w = world(body("top", circle(0.5, at=(1.0, 0.0)), angular_velocity=math.pi), gravity=(0.0, 0.0))
    w.step(60)
    assert w.body("top").center == pytest.approx((1.0, 0.0))
    assert w.body("top").position == pytest.approx((2.0, 0.0))


@pytest.mark.parametrize("damping", [0.1, 1.0, 5.0])
def test_damping_decays_exponentially(damping):
    w = world(
        body("puck", circle(0.5), velocity=(3.0, 4.0), linear_damping=damping),
        body("top", circle(0.5), position=(9.0, 9.0), angular_velocity=6.0, angular_damping=damping),
        gravity=(0.0, 0.0),
    )
    w.step(60)
    # 1 / (1 + x + x^2 / 2) a substep, with x = c h: exp(-c t) to second order in x.
    tolerance = damping**3 / 240**2 / 6 * 1.1 + 1e-12
    assert w.body("puck").velocity[0] == pytest.approx(3.0 * math.exp(-damping), rel=tolerance)
    assert w.body("puck").velocity[1] == pytest.approx(4.0 * math.exp(-damping), rel=tolerance)
    assert w.body("top").angular_velocity == pytest.approx(6.0 * math.exp(-damping), rel=tolerance)


def test_strong_damping_is_stable():
    w = world(body("mud", circle(0.5), velocity=(3.0, 4.0), linear_damping=1e6), gravity=(0.0, 0.0))
    w.step()
    assert 0.0 <= w.body("mud").velocity[0] < 1e-3


def test_bodies_far_apart_do_not_feel_each_other():
    alone = world(body("a", box(1.0, 1.0), velocity=(1.0, 2.0), angular_velocity=1.0))
    pair = world(
        body("a", box(1.0, 1.0), velocity=(1.0, 2.0), angular_velocity=1.0),
        body("b", box(1.0, 1.0), position=(50.0, 0.0), velocity=(-1.0, 2.0)),
    )
    alone.step(100)
    pair.step(100)
    assert np.array_equal(alone.state.bodies[0], pair.state.bodies[0])


def test_time_is_the_step_count_over_the_rate():
    w = world(body("a", circle(1.0)))
    w.step(90)
    assert w.step_count == 90
    assert w.time == pytest.approx(float(Fraction(3, 2)), rel=1e-15)
