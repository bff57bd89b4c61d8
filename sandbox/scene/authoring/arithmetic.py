"""The operators and functions of expressions, with the same bits on every machine: nothing asks the C library.

All numbers are floats, as in a spreadsheet. Sums, products, quotients and square roots are rounded as IEEE 754 says;
powers, sines and cosines are worked out exactly and rounded once.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping

from sandbox.geometry.rotation import cos_sin_degrees
from sandbox.scene.splitmix import SplitMix64

MAX_EXPONENT = 1000
"""Largest exponent of a power, either way."""
_KEPT = 70
"""Bits that are enough to round by, the last of which says whether any of those cut off was set."""


class UndefinedError(Exception):
    """An operation has no result; the text says why."""


def divide(a: float, b: float) -> float:
    """The quotient."""
    if b == 0.0:
        raise UndefinedError("division by zero")
    return a / b


def modulo(a: float, b: float) -> float:
    """What is left of `a`, with the sign of `b`, as in Python."""
    if b == 0.0:
        raise UndefinedError("division by zero")
    return a % b


def power(base: float, exponent: float) -> float:
    """`base` to a whole power, rounded once."""
    if exponent == 0.5:
        return square_root(base)
    if not exponent.is_integer() or abs(exponent) > MAX_EXPONENT:
        raise UndefinedError(f"an exponent must be a whole number from -{MAX_EXPONENT} to {MAX_EXPONENT}, or 0.5")
    if base == 0.0 and exponent < 0.0:
        raise UndefinedError("division by zero")
    count = int(exponent)
    digits, twos = _digits(base)
    return _rounded(digits ** abs(count), twos * abs(count), count < 0)


def _digits(value: float) -> tuple[int, int]:
    """An odd number of at most 53 bits and the power of two that it stands for with `value`."""
    part, shift = math.frexp(value)
    digits, twos = int(part * 2.0**53), shift - 53
    zeros = (digits & -digits).bit_length() - 1 if digits else 0
    return digits >> zeros, twos + zeros


def _rounded(digits: int, twos: int, inverse: bool) -> float:
    """The float nearest to digits * 2^twos, or to its inverse."""
    size, kept = abs(digits), digits
    if inverse:
        kept, more = divmod(1 << (size.bit_length() + _KEPT), size)
        kept, twos = kept | (more != 0), -twos - size.bit_length() - _KEPT
        kept = kept if digits > 0 else -kept
    elif size.bit_length() > _KEPT:
        cut = size.bit_length() - _KEPT
        kept, twos = (size >> cut) | (size & ((1 << cut) - 1) != 0), twos + cut
        kept = kept if digits > 0 else -kept
    try:
        return math.ldexp(kept, twos)
    except OverflowError:
        raise UndefinedError("the result is too large") from None


def square_root(x: float) -> float:
    """The square root."""
    if x < 0.0:
        raise UndefinedError("the square root of a negative number")
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
        raise UndefinedError(f"there is no tangent of {degrees:g} degrees")
    return sin / cos


def random(x: float) -> float:
    """A number evenly spread over [0, 1) that depends on `x` alone: the same one for the same number, everywhere."""
    (bits,) = struct.unpack("<Q", struct.pack("<d", x + 0.0))  # 0 and -0 are one number
    return SplitMix64(bits).between(0.0, 1.0)


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
    "random": random,
}
MANY = ("min", "max")
"""Functions that take two numbers or more; all others take one."""

INDICES = ("i", "row", "column")
"""What the copies that a generator makes are counted with."""

CONSTANTS: Mapping[str, float] = {"pi": math.pi}
