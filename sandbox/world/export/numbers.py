"""Numbers as a scene file can hold them: angles in degrees, no negative zeros, within the limits of their fields."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from math import inf, nextafter
from typing import Any, get_args

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.base import Model
from sandbox.scene.constraints import Range

_DIGITS = 12


def shortest(value: float, wanted: float, read: Callable[[float], float]) -> float:
    """The number with the fewest decimals, among those about `value`, that is `read` as `wanted`; else `value`."""
    rounded = (round(value, digits) for digits in range(_DIGITS))
    beside = (value, nextafter(value, inf), nextafter(value, -inf))
    return next((found for found in (*rounded, *beside) if read(found) == wanted), value) + 0.0


def degrees(radians: float) -> float:
    """The shortest number of degrees that is read as so many radians; the nearest one if there is none."""
    return shortest(radians / RADIANS_PER_DEGREE, radians, lambda found: found * RADIANS_PER_DEGREE)


def pair(x: float, y: float) -> list[float]:
    """A point or vector in a file; 0.0 where a number is -0.0."""
    return [float(x) + 0.0, float(y) + 0.0]


def fitted(model: type[Model], name: str, value: Any) -> Any:
    """A number, or a list of such, within the limits that a field of a model has."""
    if isinstance(value, list):
        return [fitted(model, name, one) for one in value]
    limits = _limits(model, name)
    if limits is None or value is None or isinstance(value, bool):
        return value
    return min(max(value, limits.low), limits.high)


@cache
def _limits(model: type[Model], name: str) -> Range | None:
    field = model.model_fields[name]
    return next((part for part in _parts((field.annotation, *field.metadata)) if isinstance(part, Range)), None)


def _parts(hints: tuple[Any, ...]) -> Iterator[Any]:
    """A type hint with all that is in it."""
    for hint in hints:
        yield hint
        yield from _parts(getattr(hint, "__metadata__", ()))
        yield from _parts(get_args(hint))
