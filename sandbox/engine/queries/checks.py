"""Checks on what a query is given, each with a message that names the query and the mend."""

from __future__ import annotations

import math
from collections.abc import Sequence
from numbers import Real
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from sandbox.arguments import shown
from sandbox.errors import QueryError, ShapeError
from sandbox.geometry.checks import FARTHEST, checked_point
from sandbox.tables import Floats

Vec = tuple[float, float]
_NUMBERS = (float, int)
_THIN = 1e-100
"""Sides shorter than this (m) have no length: their squares could underflow."""


class UprightBox(NamedTuple):
    """A box along the axes as a core; without width or height it is a line or a point."""

    vertices: tuple[Vec, ...]
    radius: float = 0.0


def checked_place(query: str, name: str, value: Sequence[float]) -> Vec:
    """A pair (x, y) in metres, within the limits of a world. Raises `QueryError`."""
    if type(value) is tuple and len(value) == 2:  # the common case, in a hurry
        x, y = value
        if type(x) in _NUMBERS and type(y) in _NUMBERS and abs(x) <= FARTHEST and abs(y) <= FARTHEST:
            return float(x), float(y)
    try:
        return checked_point(query, name, value)
    except ShapeError as error:
        raise QueryError(str(error)) from None


def checked_ray(
    query: str, origin: Sequence[float], translation: Sequence[float] | None, end: Sequence[float] | None
) -> tuple[Vec, Vec]:
    """Origin and translation of a ray that is given by a translation or by its end. Raises `QueryError`."""
    x, y = checked_place(query, "the origin", origin)
    if (translation is None) == (end is None):
        raise QueryError(f"{query}: a ray has a translation or an end=, one of the two")
    if translation is not None:
        return (x, y), checked_place(query, "the translation", translation)
    end_x, end_y = checked_place(query, "the end", end or ())
    return (x, y), (end_x - x, end_y - y)


def checked_box(lower: Sequence[float], upper: Sequence[float]) -> UprightBox:
    """The box between two corners. Raises `QueryError`."""
    low_x, low_y = checked_place("overlap_box", "the lower corner", lower)
    high_x, high_y = checked_place("overlap_box", "the upper corner", upper)
    if low_x > high_x or low_y > high_y:
        raise QueryError(f"overlap_box: the lower corner {tuple(lower)} is not below and left of {tuple(upper)}")
    high_x = high_x if high_x - low_x > _THIN else low_x
    high_y = high_y if high_y - low_y > _THIN else low_y
    corners = ((low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y))
    return UprightBox(tuple(dict.fromkeys(corners)))


def checked_distance(call: str, name: str, value: Any) -> float:
    """A distance of 0 m or more, which may be infinite. Raises `QueryError`."""
    distance: Any = value if isinstance(value, Real) else -1
    if distance >= 0:
        try:
            return float(distance)
        except OverflowError:  # a whole number beyond all floats
            return math.inf
    raise QueryError(f"{call}: {name} must be a distance of 0 m or more, not {shown(value)}")


def checked_rays(origins: ArrayLike, translations: ArrayLike) -> Floats:
    """Rows (x, y, translation x, translation y) of many rays. Raises `QueryError`."""
    try:
        starts, rays = (np.asarray(value, dtype=np.float64) for value in (origins, translations))
        both = np.broadcast_arrays(np.atleast_2d(starts), np.atleast_2d(rays))
        rows: Floats = np.ascontiguousarray(np.concatenate(both, axis=1))
    except (TypeError, ValueError, OverflowError):
        raise QueryError("rays: origins and translations must be arrays of pairs, (n, 2)") from None
    if rows.shape[1] != 4 or rows.ndim != 2:
        raise QueryError(f"rays: origins and translations must be arrays of pairs, (n, 2), not {both[0].shape}")
    if not (np.abs(rows) <= FARTHEST).all():
        raise QueryError(f"rays: every coordinate must be a number within +-{FARTHEST:g} m")
    return rows
