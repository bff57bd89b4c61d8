"""The operators and functions of expressions, with the same bits on every machine: nothing asks the C library.

All numbers are floats, as in a spreadsheet. Sums, products, quotients and square roots are rounded as IEEE 754 says;
powers, sines and cosines are worked out exactly and rounded once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction

from sandbox.geometry.rotation import cos_sin_degrees

MAX_EXPONENT = 1000
"""Largest exponent of a power, either way."""
_FLOAT_BITS = 1024


class ArithmeticError(Exception):
    """An operation has no result; the text says why."""


def divide(a: float, b: float) -> float:
    """The quotient."""
    if b == 0.0:
        raise ArithmeticError("division by zero")
    return a / b


def modulo(a: float, b: float) -> float:
    """What is left of `a`, with the sign of `b`, as in Python."""
    if b == 0.0:
        raise ArithmeticError("division by zero")
    return a % b


def power(base: float, exponent: float) -> float:
    """`base` to a whole power, rounded once."""
    if exponent == 0.5:
        return square_root(base)
    if not exponent.is_integer() or abs(exponent) > MAX_EXPONENT:
        raise ArithmeticError(f"an exponent must be a whole number from -{MAX_EXPONENT} to {MAX_EXPONENT}, or 0.5")
    if base == 0.0 and exponent < 0.0:
        raise ArithmeticError("division by zero")
    count = int(exponent)
    mantissa, shift = _mantissa(base)
    digits, twos = mantissa ** abs(count), shift * abs(count)
    size = (digits.bit_length() + twos) * (1 if count >= 0 else -1)
    if size > _FLOAT_BITS + 2:
        raise ArithmeticError("the result is too large")
    if size < -_FLOAT_BITS - 100:
        return 0.0
    exact = digits * Fraction(2) ** twos
    try:
        return float(exact if count >= 0 else 1 / exact)
    except OverflowError:
        raise ArithmeticError("the result is too large") from None


def _mantissa(value: float) -> tuple[int, int]:
    """A whole number of at most 53 bits and the power of two that it stands for with `value`."""
    part, shift = math.frexp(value)
    return int(part * 2.0**53), shift - 53


def square_root(x: float) -> float:
    """The square root."""
    if x < 0.0:
        raise ArithmeticError("the square root of a negative number")
    return math.sqrt(x)


def sine(degrees: float) -> float:
    """The sine of an angle in degrees, exact at multiples of 90."""
    return cos_sin_degrees(degrees)[1]


def cosine(degrees: float) -> float:
    """The cosine of an angle in degrees, exact at multiples of 90."""
    return cos_sin_degrees(degrees)[0]


def tangent(degrees: float) -> float:
    """The tangent of an angle in degrees."""
    cos, sin = cos_sin_degrees(degrees)
    if cos == 0.0:
        raise ArithmeticError(f"there is no tangent of {degrees:g} degrees")
    return sin / cos


OPERATORS: Mapping[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": divide,
    "%": modulo,
    "**": power,
}

FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sin": sine,
    "cos": cosine,
    "tan": tangent,
    "sqrt": square_root,
    "abs": abs,
    "floor": lambda x: float(math.floor(x)),
    "ceil": lambda x: float(math.ceil(x)),
    "round": lambda x: float(round(x)),
    "min": min,
    "max": max,
}
MANY = ("min", "max")
"""Functions that take two numbers or more; all others take one."""

INDICES = ("i", "row", "column")
"""What the copies that a generator makes are counted with."""

CONSTANTS: Mapping[str, float] = {"pi": math.pi}
