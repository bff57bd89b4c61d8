"""Checks on the numbers a shape is made of, each with a message that names the shape and the mend."""

from __future__ import annotations

import math
from typing import Any

from sandbox.arguments import shown
from sandbox.errors import ShapeError
from sandbox.geometry.shape import Shape

Vec = tuple[float, float]

FARTHEST = 1e9
"""Largest coordinate in metres, as in a scene."""
SMALLEST, LARGEST = 1e-6, 1e7
"""Limits of a size in metres, as in a scene."""


def checked_number(kind: str, name: str, value: Any, unit: str, limit: float) -> float:
    """`value` as a float; `kind` and `name` say what it is. Raises `ShapeError` past +-`limit` or if not a number."""
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise ShapeError(f"{kind}: {name} must be a number, not {shown(value)}") from None
    if isinstance(value, str) or not math.isfinite(number):
        raise ShapeError(f"{kind}: {name} must be a finite number, not {shown(value)}")
    if abs(number) > limit:
        raise ShapeError(f"{kind}: {name} must be within +-{limit:g} {unit}, not {number!r}")
    return number + 0.0  # -0.0 becomes 0.0, so that equal shapes have equal bits


def checked_size(kind: str, name: str, value: Any, zero: bool = False) -> float:
    """A length from `SMALLEST` to `LARGEST` metres, or 0 where `zero` allows it. Raises `ShapeError`."""
    size = checked_number(kind, name, value, "m", math.inf)
    if not (SMALLEST <= size <= LARGEST or (zero and size == 0.0)):
        least = "0 or " if zero else ""
        raise ShapeError(f"{kind}: {name} must be {least}{SMALLEST:g} to {LARGEST:g} m, not {size!r}")
    return size


def checked_point(kind: str, name: str, value: Any) -> Vec:
    """A pair (x, y) in metres. Raises `ShapeError`."""
    pair = _listed(kind, f"{name} must be a pair (x, y)", value)
    if len(pair) != 2:
        raise ShapeError(f"{kind}: {name} must be a pair (x, y), not {shown(value)}")
    x = checked_number(kind, f"x of {name}", pair[0], "m", FARTHEST)
    return x, checked_number(kind, f"y of {name}", pair[1], "m", FARTHEST)


def checked_points(kind: str, value: Any) -> tuple[Vec, ...]:
    """A list of vertices in metres. Raises `ShapeError`."""
    points = _listed(kind, "the vertices must be a list of pairs (x, y)", value)
    return tuple(checked_point(kind, f"vertex {i}", point) for i, point in enumerate(points))


def check_shapes(kind: str, *values: Any) -> None:
    """Raise `ShapeError` unless all values are shapes; `kind` is the function that was given them."""
    for value in values:
        if not isinstance(value, Shape):
            raise ShapeError(f"{kind}: takes a Circle, Capsule, Segment, Polygon or Box, not {shown(value)}")


def _listed(kind: str, wanted: str, value: Any) -> list[Any]:
    try:
        if not isinstance(value, str):
            return list(value)
    except TypeError:  # numpy's single numbers say that they could be gone through
        pass
    raise ShapeError(f"{kind}: {wanted}, not {shown(value)}")
