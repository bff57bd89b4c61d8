"""Cosine and sine of an angle in degrees without libm, so that a scene loads to the same bits everywhere.

Works in whole numbers of 2^-128 and rounds once at the end: the results are the nearest floats, and exact at
multiples of 90 degrees.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

RADIANS_PER_DEGREE = 0.017453292519943295
"""The float nearest pi / 180; a file's degrees times this are the API's radians."""

_ONE = 1 << 128
_PI = 0x3243F6A8885A308D313198A2E03707344A  # pi in units of 2^-132


@lru_cache(maxsize=4096)
def cos_sin_degrees(degrees: float) -> tuple[float, float]:
    """(cos, sin) of a finite angle in degrees."""
    exact = Fraction(degrees)
    quarter = round(exact / 90)
    cos, sin = _series((exact - 90 * quarter) / 180)
    for _ in range(quarter % 4):
        cos, sin = -sin, cos
    return float(Fraction(cos, _ONE)), float(Fraction(sin, _ONE))


def _series(half_turns: Fraction) -> tuple[int, int]:
    """Cosine and sine of `half_turns` * pi in units of 2^-128, for at most a quarter of a half turn."""
    x = round(half_turns * _PI * _ONE / (1 << 132))
    sums = [0, 0, 0, 0]
    term, k = _ONE, 0
    while term:
        sums[k % 4] += term
        k += 1
        term = _nearest(term * x, k * _ONE)
    return sums[0] - sums[2], sums[1] - sums[3]


def _nearest(numerator: int, denominator: int) -> int:
    """The quotient rounded to nearest; towards zero would never let a small negative term end."""
    return (2 * numerator + denominator) // (2 * denominator)
