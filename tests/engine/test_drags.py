"""The drag against implicit Euler of a spring and a damper."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import MoveDrag, StartDrag
from tests.engine.stages import Paused, solve_mouse_joints
from tests.examples import examples
from tests.flat import body, box, circle, world


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(-5, 5), st.floats(0.5, 9.0))
@examples(60)
def test_a_grab_at_the_centre_is_a_damped_spring(x, y, speed, density):
    w = world(body("a", circle(0.5, density=density), velocity=(speed, 0.0)), gravity=(0.0, 0.0))
    w.apply(StartDrag("a", (0.0, 0.0), 1e9))
    w.apply(MoveDrag("a", (x, y)))
    h, omega, zeta = 1.0 / 240, 2 * math.pi * 5.0, 0.7
    place, velocity, target = np.zeros(2), np.array([speed, 0.0]), np.array([x, y])
    for _ in range(15):
        w.step()
        for _ in range(4):
            pulled = velocity - h * omega**2 * (place - target)
            velocity = pulled / (1.0 + 2 * zeta * omega * h + (omega * h) ** 2)
            place = place + h * velocity
        assert w.body("a").velocity == pytest.approx(tuple(velocity), abs=1e-9)
        assert w.body("a").position == pytest.approx(tuple(place), abs=1e-9)


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(-4, 4), st.floats(-0.5, 0.5), st.floats(0.1, 1e4))
@examples(100)
def test_a_grab_off_centre_solves_both_axes_at_once(x, y, spin, arm, limit):
    """Impulse = -scale K^-1 (velocity + rate * error) at the grabbed point, no longer than the force allows."""
    w = world(body("a", box(1.0, 0.6), angle=0.4, velocity=(1.0, 2.0), angular_velocity=spin), gravity=(0.0, 0.0))
    grabbed = (arm * math.cos(0.4) - 0.2 * math.sin(0.4), arm * math.sin(0.4) + 0.2 * math.cos(0.4))
    w.apply(StartDrag("a", grabbed, limit))
    w.apply(MoveDrag("a", (x, y)))
    p = Paused(w)
    p.begin()
    solve_mouse_joints(p.tables, p.scratch.solver, 0, p.substep)
    b, m, h = p.state.bodies[0], p.scratch.solver.motions[0], p.substep
    rx, ry = grabbed
    k = b.inverse_mass * np.eye(2) + b.inverse_inertia * np.array([[ry * ry, -rx * ry], [-rx * ry, rx * rx]])
    omega, zeta = 2 * math.pi * 5.0, 0.7
    a1 = 2 * zeta + h * omega
    a2 = h * omega * a1
    velocity = np.array([1.0 - spin * ry, 2.0 + spin * rx])
    impulse = -a2 / (1 + a2) * np.linalg.solve(k, velocity + omega / a1 * (np.array(grabbed) - [x, y]))
    length = float(np.hypot(*impulse))
    impulse = impulse * min(1.0, h * limit / length) if length > 0.0 else impulse
    assert (m.velocity_x, m.velocity_y) == pytest.approx(tuple([1.0, 2.0] + b.inverse_mass * impulse), abs=1e-9)
    turn = b.inverse_inertia * (rx * impulse[1] - ry * impulse[0])
    assert m.angular_velocity == pytest.approx(spin + turn, abs=1e-9)


def test_a_drag_of_a_body_that_cannot_turn():
    w = world(body("a", box(1.0, 1.0), fixed_rotation=True), gravity=(0.0, 0.0))
    w.apply(StartDrag("a", (0.4, 0.4)))
    w.apply(MoveDrag("a", (2.0, 1.0)))
    w.step(240)
    assert w.body("a").angle == 0.0
    assert w.body("a").position == pytest.approx((1.6, 0.6), abs=1e-3)
