"""Sine, cosine and arc tangent against arithmetic of 60 digits."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox._jit import entry_point
from sandbox._vectors import WIDTH, load, store
from sandbox.geometry import trig
from sandbox.geometry.trig import PI
from sandbox.tables import Floats
from tests.examples import examples
from tests.kernels import called_from_python

mpmath.mp.dps = 60

arctan2, cos_sin = called_from_python(trig.arctan2), called_from_python(trig.cos_sin)
moderate = st.floats(-1e6, 1e6)
coordinates = st.floats(-1e9, 1e9)


@entry_point
def side_by_side(angles: Floats, found: Floats) -> None:
    cosines, sines = trig.cos_sin_lanes(load(angles, 0))
    store(found, 0, cosines)
    store(found, WIDTH, sines)


def quarters(k: int) -> float:
    """The float nearest k quarter turns."""
    return float(k * mpmath.pi / 2)


@given(moderate | st.integers(-600_000, 600_000).map(quarters) | st.floats(-1.0, 1.0))
@examples(1000)
@example(0.75)
@example(-0.75)
@example(math.pi / 4)
def test_cos_sin_is_within_its_stated_error(angle):
    cosine, sine = cos_sin(angle)
    assert abs(mpmath.mpf(cosine) - mpmath.cos(mpmath.mpf(angle))) < 2e-16
    assert abs(mpmath.mpf(sine) - mpmath.sin(mpmath.mpf(angle))) < 2e-16


@given(st.floats(-1e9, 1e9))
def test_a_rotation_is_one_at_any_angle_a_body_may_have(angle):
    cosine, sine = cos_sin(angle)
    assert math.hypot(cosine, sine) == pytest.approx(1.0, abs=5e-16)
    assert cosine == pytest.approx(math.cos(angle), abs=1e-6)
    assert sine == pytest.approx(math.sin(angle), abs=1e-6)


@given(moderate)
def test_cosine_is_even_and_sine_is_odd(angle):
    cosine, sine = cos_sin(angle)
    assert cos_sin(-angle) == (cosine, -sine)


@given(st.lists(moderate | st.floats(-1.0, 1.0) | st.just(-0.0), min_size=WIDTH, max_size=WIDTH))
@example([0.5, -0.75, 0.75, -0.0])
@example([0.5, 0.76, -1e6, 0.0])
def test_four_angles_have_the_bits_that_each_has_alone(angles):
    found = np.zeros((2, WIDTH))
    side_by_side(np.array(angles), found.reshape(-1))
    assert found.T.tobytes() == np.array([cos_sin(each) for each in angles]).tobytes()


def test_no_turn_is_exactly_no_turn():
    assert cos_sin(0.0) == (1.0, 0.0)


@given(coordinates, coordinates)
@examples(1000)
@example(0.0, -1.0)
@example(-0.0, -1.0)
@example(1e-320, 1.0)
@example(1.0, 1e-320)
@example(-1.0, -1e-320)
@example(1.0, math.sqrt(2.0) - 1.0)
@example(1.0, 1.0 + math.sqrt(2.0))
def test_arctan2_is_within_its_stated_error(y, x):
    got = arctan2(y, x)
    if x == 0.0 and y == 0.0:
        assert got == 0.0
        return
    error = abs(mpmath.mpf(got) - mpmath.atan2(mpmath.mpf(y), mpmath.mpf(x)))
    if y == 0.0 and x < 0.0:
        assert abs(got) == PI
    else:
        assert error < 5e-16


@given(st.floats(-3.14, 3.14), st.floats(1e-6, 1e6))
def test_arctan2_undoes_cos_sin(angle, length):
    cosine, sine = cos_sin(angle)
    assert arctan2(length * sine, length * cosine) == pytest.approx(angle, abs=1e-15)
