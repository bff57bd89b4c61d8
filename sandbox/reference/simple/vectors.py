"""Vectors as complex numbers: x + iy.

Turning a vector by an angle is multiplying it by a number of length 1; i times a vector is that vector turned a quarter
to the left.
"""

from __future__ import annotations

Vec = tuple[float, float]


def dot(a: complex, b: complex) -> float:
    """Scalar product."""
    return a.real * b.real + a.imag * b.imag


def cross(a: complex, b: complex) -> float:
    """Scalar cross product: positive where b lies to the left of a."""
    return a.real * b.imag - a.imag * b.real


def clamp(value: float, limit: float) -> float:
    """The value between -limit and limit that is nearest."""
    return max(-limit, min(value, limit))


def vec(value: complex) -> Vec:
    """The two coordinates."""
    return value.real, value.imag
