"""Cosine and sine in degrees without libm."""

from __future__ import annotations

import math
from decimal import Decimal, getcontext

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.rotation import RADIANS_PER_DEGREE, cos_sin_degrees

getcontext().prec = 60
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")


def exact(degrees: float) -> tuple[Decimal, Decimal]:
    """The naive twin: the two series, in sixty decimals."""
    x = Decimal(degrees) % 360 * PI / 180
    term, cos, sin = Decimal(1), Decimal(0), Decimal(0)
    for k in range(200):
        if k % 2 == 0:
            cos += term if k % 4 == 0 else -term
        else:
            sin += term if k % 4 == 1 else -term
        term = term * x / (k + 1)
    return cos, sin


@given(st.floats(-1e6, 1e6))
def test_it_is_the_nearest_float(degrees):
    for got, wanted in zip(cos_sin_degrees(degrees), exact(degrees), strict=True):
        # Two fixed 2^-128 of slack beside half an ulp: only a sine next to zero can show them.
        assert abs(Decimal(got) - wanted) <= Decimal(math.ulp(got)) / 2 + Decimal(2) ** -126


@pytest.mark.parametrize("turns", [-400, -3, 0, 1, 2, 7, 1000])
def test_quarters_are_exact(turns):
    for quarter, wanted in enumerate([(1, 0), (0, 1), (-1, 0), (0, -1)]):
        assert cos_sin_degrees(360.0 * turns + 90 * quarter) == wanted


def test_half_is_half():
    assert cos_sin_degrees(60)[0] == 0.5
    assert cos_sin_degrees(30)[1] == 0.5


def test_a_degree_in_radians_is_the_nearest_float():
    assert math.radians(1) == RADIANS_PER_DEGREE
