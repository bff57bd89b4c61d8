"""The moment of first touch against exact separations sampled along the way."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox._jit import kernel_argument
from sandbox.geometry import linear_cast as linear_casting
from tests.examples import examples
from tests.geometry.convex_cases import Case, cases
from tests.kernels import called_from_python
from tests.naive import convex


@called_from_python
def cast(cores, a, b, dx, dy, vx, vy, seconds, slop):
    """From the features that they begin with."""
    start = linear_casting.features_apart(cores, a, b, dx, dy)
    return linear_casting.linear_cast(cores, a, b, start, (dx, dy), (vx, vy), seconds, slop)


SLOP = 1e-3
speeds = st.floats(-8.0, 8.0)


def gap(case: Case, way: tuple[float, float]) -> float:
    """Exact gap of the rounded shapes once b has moved by `way`."""
    b = convex.exact(case.b, case.way[0] + way[0], case.way[1] + way[1])
    return convex.separation(convex.exact(case.a), b) - case.radius_a - case.radius_b


def touch(case: Case, velocity: tuple[float, float], seconds: float = 1.0) -> float:
    """The kernel's answer."""
    return cast(kernel_argument(case.table()), *case.cores(), *case.way, *velocity, seconds, SLOP)


@given(cases, st.tuples(speeds, speeds))
@examples(150)
def test_the_first_touch_is_neither_missed_nor_overstepped(case, velocity):
    assume(gap(case, (0.0, 0.0)) > 0.01)
    assume(math.hypot(*velocity) > 0.1)
    t = touch(case, velocity)
    moments = np.linspace(0.0, 1.0, 21)
    gaps = [gap(case, (velocity[0] * s, velocity[1] * s)) for s in moments]
    if t < 0.0:
        assert min(gaps) > 0.0
        return
    assert t <= 1.0
    assert gap(case, (velocity[0] * t, velocity[1] * t)) > -1e-9
    assert all(g > 0.0 for g, s in zip(gaps, moments, strict=True) if s < t)
    if case.radius_a + case.radius_b > 0.0:
        assert gap(case, (velocity[0] * t, velocity[1] * t)) < 0.02


@given(cases)
@examples(50)
def test_shapes_that_touch_already_touch_at_once(case):
    assume(gap(case, (0.0, 0.0)) < -1e-9)
    assert touch(case, (1.0, 2.0)) == 0.0


@given(st.floats(0.1, 5.0), st.floats(0.5, 9.0))
def test_discs_on_a_line(distance, speed):
    case = Case(((0.0, 0.0),), ((0.0, 0.0),), (1.0 + distance, 0.0), 0.5, 0.5)
    t = touch(case, (-speed, 0.0), 10.0)
    assert 0.0 <= distance - speed * t <= SLOP + 1e-9
    assert touch(case, (speed, 0.0)) == -1.0
    assert touch(case, (0.0, speed)) == -1.0
