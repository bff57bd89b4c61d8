"""Without gravity and walls, momentum and angular momentum stay what they were, whatever touches whatever."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.examples import examples
from tests.flat import body, box, capsule, circle, polygon, world

SHAPES = [
    circle(0.4, restitution=0.7),
    box(0.8, 0.5, restitution=0.2),
    capsule(0.3, 0.2, rolling_resistance=0.05),
    polygon((-0.5, -0.3), (0.5, -0.3), (0.0, 0.5)),
    box(0.6, 0.6, radius=0.1, density=4.0, surface_speed=1.0),
]


def momentum(w):
    b = w.state.bodies
    px, py = np.sum(b.mass * b.velocity_x), np.sum(b.mass * b.velocity_y)
    spin = np.sum(b.mass * (b.center_x * b.velocity_y - b.center_y * b.velocity_x) + b.inertia * b.angular_velocity)
    return np.array([px, py, spin])


def crowd(seed: int, count: int = 36):
    """Bodies on a lattice that fly at its middle, spinning."""
    random = np.random.default_rng(seed)
    bodies = []
    for i in range(count):
        place = np.array([1.4 * (i % 6) - 3.5, 1.4 * (i // 6) - 3.5])
        velocity = -place + random.normal(size=2)
        bodies.append(
            body(
                f"{i}", replace(SHAPES[i % 5], friction=random.random()), position=tuple(map(float, place)),
                angle=float(random.normal()), velocity=tuple(map(float, velocity)),
                angular_velocity=float(3.0 * random.normal()),
            )
        )  # fmt: skip
    return world(*bodies, gravity=(0.0, 0.0))


@pytest.mark.parametrize("seed", range(4))
def test_linear_momentum_is_kept(seed):
    w = crowd(seed)
    before = momentum(w)
    touched = 0
    for _ in range(300):
        w.step()
        touched += len(w.contacts)
        assert momentum(w)[:2] == pytest.approx(before[:2], abs=1e-11)
    assert touched > 300


@pytest.mark.parametrize("seed", range(4))
def test_angular_momentum_is_nearly_kept(seed):
    """Anchors stay where they were at the beginning of the step, so a turning pair loses a little."""
    w = crowd(seed)
    before = momentum(w)[2]
    scale = np.sum(w.state.bodies.inertia * np.abs(w.state.bodies.angular_velocity)) + 100.0
    w.step(300)
    assert momentum(w)[2] == pytest.approx(before, abs=0.02 * scale)


@given(st.integers(0, 2**32), st.floats(-5, 5), st.floats(-5, 5), st.floats(-20, 20))
@examples(50)
def test_a_pair_keeps_its_momentum(seed, vx, vy, spin):
    random = np.random.default_rng(seed)
    a, b = random.choice(5, 2)
    place = -0.7, float(random.uniform(-0.4, 0.4))
    w = world(
        body("a", SHAPES[a], position=place, velocity=(vx, vy), angular_velocity=spin),
        body("b", SHAPES[b], position=(0.7, 0.0), angle=float(random.uniform(-3, 3))),
        gravity=(0.0, 0.0),
    )  # fmt: skip
    before = momentum(w)
    w.step(60)
    assert momentum(w)[:2] == pytest.approx(before[:2], abs=1e-10)
