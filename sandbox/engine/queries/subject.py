"""What is asked, as the kernels want it: the query shape about its reference point, and the filter."""

from __future__ import annotations

import math
from collections.abc import Callable
from numbers import Integral
from typing import Any, NamedTuple

import numpy as np

from sandbox.arguments import shown
from sandbox.engine.queries.filter import ALL_BITS, Filter
from sandbox.engine.queries.records import SPARE_CORES, Memory
from sandbox.errors import QueryError
from sandbox.geometry.mass import edge_normals
from sandbox.geometry.shapes import Core
from sandbox.tables import Integers, Records

Vec = tuple[float, float]
_SHAPE_FIELDS = ["count", "radius", "extent", "lower_x", "lower_y", "upper_x", "upper_y"]
_FILTER_FIELDS = ["mask", "category", "group", "types", "sensors"]
_TYPES = {"static": 1, "kinematic": 2, "dynamic": 4}


def plain(records: Records) -> Any:
    """The same memory without the attributes of a recarray, which are slow from Python."""
    return records.view(np.ndarray)


class Subject(NamedTuple):
    """The core of a query shape from its reference point, the middle of its bounds, and the radius around it."""

    place: Vec
    core: tuple[Vec, ...]
    radius: float


POINT = Subject((0.0, 0.0), ((0.0, 0.0),), 0.0)


def subject_of(shape: Core) -> Subject:
    """A shape in world coordinates as a subject at its place."""
    try:
        vertices, radius = shape.vertices, float(shape.radius)
    except AttributeError:
        raise QueryError(
            f"a query takes a Circle, Capsule, Segment, Polygon or Box, not {type(shape).__name__}"
        ) from None
    xs, ys = [x for x, _ in vertices], [y for _, y in vertices]
    x, y = min(xs) + (max(xs) - min(xs)) / 2, min(ys) + (max(ys) - min(ys)) / 2
    return Subject((x, y), tuple((u - x, v - y) for u, v in vertices), radius)


def write_subject(memory: Memory, subject: Subject) -> None:
    """Put the mirrored core and the bounds of a subject where the kernels look for them."""
    core, radius = subject.core, subject.radius
    first = len(memory.cores) - SPARE_CORES
    # 0.0 - x instead of -x, which could be -0.0.
    mirrored = [
        (0.0 - x, 0.0 - y, 0.0 - nx, 0.0 - ny) for (x, y), (nx, ny) in zip(core, edge_normals(core), strict=True)
    ]
    plain(memory.cores)[first : first + len(core)] = mirrored
    xs, ys = [x for x, _ in core], [y for _, y in core]
    bounds = (min(xs) - radius, min(ys) - radius, max(xs) + radius, max(ys) + radius)
    extent = max(math.sqrt(x * x + y * y) for x, y in core) + radius
    plain(memory.question)[_SHAPE_FIELDS] = (len(core), radius, extent, *bounds)


def check_filter(seen: Any) -> None:
    """Raise `QueryError` for what is no filter, or has fields of wrong kinds: before filters are compared."""
    if not isinstance(seen, Filter):
        raise QueryError(f"a query is asked with a Filter, or None, not {shown(seen)}")
    for name, value in (("mask", seen.mask), ("category", seen.category)):
        is_bits = isinstance(value, Integral) and 0 <= int(value) <= ALL_BITS
        if not is_bits and not (name == "category" and value is None):
            raise QueryError(f"Filter: {name} is a bit set of 32 categories, a whole number, not {shown(value)}")
    if not isinstance(seen.group, Integral) or abs(int(seen.group)) > ALL_BITS:
        raise QueryError(f"Filter: group is a whole number, not {shown(seen.group)}")
    if not isinstance(seen.sensors, (bool, np.bool_)):
        raise QueryError(f"Filter: sensors is True or False, not {shown(seen.sensors)}")
    if not all(isinstance(each, (str, tuple, list, set, frozenset)) for each in (seen.types, seen.exclude)):
        raise QueryError("Filter: types are a tuple of kinds of bodies, and exclude is one of ids")


def write_filter(memory: Memory, seen: Filter, find: Callable[[str], int], before: Integers) -> Integers:
    """Put a filter that has been checked where the kernels look for it; `find` gives the index of a body id.

    Returns the rows of the bodies that it hides; `before` are those that the last one did.
    """
    if seen.category == 0:
        raise QueryError("Filter: category 0 is heard by nobody; leave it out to pass over the masks of shapes")
    unknown = [name for name in seen.types if name not in _TYPES]
    if unknown or isinstance(seen.exclude, str):
        wrong = f"types has {unknown[0]!r}, not one of {', '.join(_TYPES)}" if unknown else "exclude is a tuple of ids"
        raise QueryError(f"Filter: {wrong}")
    hidden = np.array([find(name) for name in seen.exclude], dtype=np.int64)
    memory.hidden[before] = 0
    memory.hidden[hidden] = 1
    types = sum({_TYPES[name] for name in seen.types})
    plain(memory.question)[_FILTER_FIELDS] = (seen.mask, seen.category or 0, seen.group, types, int(seen.sensors))
    return hidden
