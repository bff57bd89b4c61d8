"""A blow in the first step of a world: what touches gains no energy by it, and what rests elsewhere stays put."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, circle, ground, world


def kinetic(w: World) -> float:
    b = w.state.bodies
    return float(0.5 * np.sum(b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2))


@pytest.mark.parametrize("speed", [1.0, 5.0])
@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("count", [5, 20])
def test_a_row_that_is_struck_gains_no_energy(count, rate, speed):
    """Without restitution all end with the same speed, and a share 1 / (n + 1) of the energy, once the blow is passed
    on to the last."""
    shape = circle(0.5, friction=0.0)
    discs = [body(f"{k}", shape, position=(float(k), 0.0)) for k in range(1, count + 1)]
    first = body("first", shape, velocity=(speed, 0.0))
    w = world(first, *discs, gravity=(0.0, 0.0), settings=FlatSettings(step_rate=rate, sleeping=False))
    before = kinetic(w)
    w.step()
    assert kinetic(w) <= before
    w.step(3)
    assert kinetic(w) <= 2.5 * before / (count + 1)


def column(speed: float = 3.0):
    return [body(f"d{k}", circle(0.5), position=(0.0, k + 0.5), velocity=(0.0, -speed)) for k in range(10)]


@pytest.mark.parametrize("rate", [60, 240])
def test_a_column_that_arrives_does_not_fly_up(rate):
    w = world(ground(), *column(), settings=FlatSettings(step_rate=rate, sleeping=False))
    highest = 0.0
    for _ in range(rate // 5):
        w.step()
        highest = max(highest, float(w.state.bodies.velocity_y.max()))
    assert highest <= 1.5


@pytest.mark.parametrize("rate", [60, 240])
def test_what_rests_beside_a_blow_stays_where_it_was_put(rate):
    """Also next to it, on the same ground."""
    stack = [body(f"b{k}", box(1.0, 1.0), position=(3.0, k + 0.5)) for k in range(10)]
    w = world(ground(), *column(), *stack, settings=FlatSettings(step_rate=rate, sleeping=False))
    w.step(rate // 2)
    for k in range(10):
        assert w.body(f"b{k}").position == pytest.approx((3.0, k + 0.5), abs=1e-6)
