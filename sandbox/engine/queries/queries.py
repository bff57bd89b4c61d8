"""`world.query`: read-only questions about where things are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from sandbox._jit import Door, kernel_argument
from sandbox.attributes import FixedAttributes
from sandbox.engine.queries.checks import checked_box, checked_distance, checked_place, checked_ray, checked_rays
from sandbox.engine.queries.filter import Filter
from sandbox.engine.queries.gap import find_gap
from sandbox.engine.queries.proximity import nearest_shape, overlaps
from sandbox.engine.queries.records import HIT
from sandbox.engine.queries.results import BodyDistance, CastHit, Overlap, PointHit, RayHit, RayHits
from sandbox.engine.queries.spatial_index import SpatialIndex
from sandbox.engine.queries.subject import POINT, Subject, check_filter, subject_of, write_filter, write_subject
from sandbox.engine.queries.sweep import all_hits, first_hits
from sandbox.errors import QueryError
from sandbox.geometry.shapes import Core
from sandbox.tables import Integers
from sandbox.world.directory import Directory
from sandbox.world.shape_rows import first_shape
from sandbox.world.state import State

Vec = tuple[float, float]
_EVERYTHING = Filter()
_FIRST_HITS, _ALL_HITS, _OVERLAPS = Door(first_hits), Door(all_hits), Door(overlaps)
_NEAREST, _GAP = Door(nearest_shape), Door(find_gap)


class QueriedWorld(Protocol):
    """As much of a world as queries know."""

    @property
    def state(self) -> State:
        """Its records."""

    @property
    def directory(self) -> Directory:
        """From ids to rows."""

    @property
    def moves(self) -> int:
        """While it stays the same, all is where it was."""


class Queries(FixedAttributes):
    """Questions to one world. They change nothing: no digest, no snapshot, no step.

    Touching counts everywhere: a ray that grazes a corner hits it, and so does whatever the rounding of floats cannot
    tell from a touch (a few units in the last place of the lengths involved). Sleeping, static and frozen bodies are
    seen like any others. Lines are met from both sides.

    The first question after a step, a restore, or a command that does more than push what is awake puts all shapes
    that may have moved into a grid; those that follow use it.
    """

    __slots__ = ("_asked", "_hidden", "_index", "_laid_out", "_many", "_one", "_rays", "_world")

    def __init__(self, world: QueriedWorld) -> None:
        self._world = world
        self._rays = np.zeros((1, 4))
        self._one: Any = kernel_argument(HIT.zeros(2))
        self._many: Any = kernel_argument(HIT.zeros(64))
        self._laid_out = -1
        self._asked: tuple[Subject, Filter] | None = None
        self._hidden: Integers = np.zeros(0, np.int64)
        self._index = SpatialIndex(world.state)

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy asks the same world; a deep or pickled one a copy of it."""
        return getattr, (self._world, "query")

    def ray(
        self,
        origin: Sequence[float],
        translation: Sequence[float] | None = None,
        filter: Filter | None = None,
        *,
        end: Sequence[float] | None = None,
    ) -> RayHit | None:
        """The first hit on the way from `origin` to `origin + translation` (m); the lowest shape if several tie.

        Instead of a translation, the `end` of the way can be given. A ray of length 0 hits what its origin touches.
        Raises `QueryError`.
        """
        hit = self._first(*checked_ray("ray", origin, translation, end), POINT, filter)
        return None if hit is None else RayHit(*hit)

    def ray_all(
        self,
        origin: Sequence[float],
        translation: Sequence[float] | None = None,
        filter: Filter | None = None,
        *,
        end: Sequence[float] | None = None,
    ) -> tuple[RayHit, ...]:
        """Every shape the ray meets, where it enters, sorted by (fraction, shape)."""
        ray = checked_ray("ray_all", origin, translation, end)
        return tuple(RayHit(*hit) for hit in self._all(*ray, POINT, filter))

    def rays(self, origins: ArrayLike, translations: ArrayLike, filter: Filter | None = None) -> RayHits:
        """The first hits of many rays at once: `origins` and `translations` are (n, 2) or one pair for all (m)."""
        rays = checked_rays(origins, translations)
        hits: Any = kernel_argument(HIT.zeros(len(rays)))
        self._ask(POINT, filter)
        self._run(_FIRST_HITS, rays, hits)
        point, normal = (np.stack([hits[x], hits[y]], 1) for x, y in (("x", "y"), ("normal_x", "normal_y")))
        return RayHits(hits["body"], hits["shape_index"], point, normal, hits["fraction"])

    def cast(self, shape: Core, translation: Sequence[float], filter: Filter | None = None) -> CastHit | None:
        """The first hit of a shape that moves by `translation` (m) without turning. Raises `QueryError`."""
        subject = subject_of(shape)
        hit = self._first(subject.place, checked_place("cast", "the translation", translation), subject, filter)
        return None if hit is None else CastHit(*hit)

    def cast_all(self, shape: Core, translation: Sequence[float], filter: Filter | None = None) -> tuple[CastHit, ...]:
        """Every shape that the moving shape meets, sorted by (fraction, shape)."""
        subject = subject_of(shape)
        translation = checked_place("cast_all", "the translation", translation)
        return tuple(CastHit(*hit) for hit in self._all(subject.place, translation, subject, filter))

    def point(self, point: Sequence[float], filter: Filter | None = None) -> tuple[PointHit, ...]:
        """Every shape that holds the point (m), on its outline or inside, sorted by shape."""
        place = checked_place("point", "the point", point)
        return tuple(PointHit(*hit) for hit in self._overlaps(place, POINT, filter))

    def nearest(
        self, point: Sequence[float], within: float = float("inf"), filter: Filter | None = None
    ) -> PointHit | None:
        """The shape with the least signed distance from the point, if that is at most `within` metres.

        Of shapes that hold the point it is the one it lies deepest in.
        """
        x, y = checked_place("nearest", "the point", point)
        reach = checked_distance("nearest", "within", within)
        self._ask(POINT, filter)
        if len(self._world.state.shapes) == 0 or not self._run(_NEAREST, x, y, reach, self._one):
            return None
        return PointHit(*self._answer(self._one.tolist()[0]))

    def overlap_box(
        self, lower: Sequence[float], upper: Sequence[float], filter: Filter | None = None
    ) -> tuple[Overlap, ...]:
        """Every shape that touches the upright box from corner `lower` to corner `upper` (m), sorted by shape.

        The shapes themselves, not their bounds. A box without width or height is a line or a point.
        """
        subject = subject_of(checked_box(lower, upper))
        return tuple(_overlap(hit) for hit in self._overlaps(subject.place, subject, filter))

    def overlap_shape(self, shape: Core, filter: Filter | None = None) -> tuple[Overlap, ...]:
        """Every shape that touches the given one, sorted by shape."""
        subject = subject_of(shape)
        return tuple(_overlap(hit) for hit in self._overlaps(subject.place, subject, filter))

    def distance(self, body_a: str, body_b: str) -> BodyDistance:
        """The closest points of two bodies. Raises `UnknownBodyError`, and `QueryError` for one and the same body."""
        a, b = self._world.directory.body(body_a), self._world.directory.body(body_b)
        if a == b:
            raise QueryError(f"distance: {body_a!r} is given twice")
        self._ask(POINT, None)
        self._asked = None
        self._run(_GAP, self._shapes_of(a), self._shapes_of(b), self._one)
        of_a, of_b = map(self._answer, self._one.tolist())
        return BodyDistance(of_a[4], of_a[2], of_b[2], of_a[3], of_a[1], of_b[1])

    def _shapes_of(self, row: int) -> Integers:
        shapes = self._world.state.shapes
        return np.arange(first_shape(shapes, row), first_shape(shapes, row + 1))

    def _first(self, place: Vec, translation: Vec, subject: Subject, seen: Filter | None) -> tuple[Any, ...] | None:
        self._ask(subject, seen)
        self._rays[0] = (*place, *translation)
        self._run(_FIRST_HITS, self._rays, self._one)
        hit = self._one.tolist()[0]
        return self._answer(hit) if hit[0] >= 0 else None

    def _all(self, place: Vec, translation: Vec, subject: Subject, seen: Filter | None) -> list[tuple[Any, ...]]:
        self._ask(subject, seen)
        self._rays[0] = (*place, *translation)
        hits = self._collect(lambda room: self._run(_ALL_HITS, self._rays, room))
        return [self._answer(hit) for hit in sorted(hits, key=lambda hit: (hit[2], hit[0]))]

    def _overlaps(self, place: Vec, subject: Subject, seen: Filter | None) -> list[tuple[Any, ...]]:
        self._ask(subject, seen)
        hits = self._collect(lambda room: self._run(_OVERLAPS, *place, room))
        return [self._answer(hit) for hit in sorted(hits)]

    def _collect(self, ask: Callable[[Any], int]) -> list[tuple[Any, ...]]:
        """Ask until there is room for all answers."""
        count = ask(self._many)
        if count > len(self._many):
            self._many = kernel_argument(HIT.zeros(count + count // 2))
            count = ask(self._many)
        rows: list[tuple[Any, ...]] = self._many[:count].tolist()
        return rows

    def _run(self, kernel: Door, *more: Any) -> Any:
        return kernel(*self._index.arguments, *more)

    def _answer(self, hit: tuple[Any, ...]) -> tuple[str, int, Vec, Vec, float]:
        shape, body, fraction, x, y, nx, ny = hit
        return self._world.state.census.bodies.names[body], shape, (x, y), (nx, ny), fraction

    def _ask(self, subject: Subject, seen: Filter | None) -> None:
        """Bring the grid up to date and write down what is asked, if it is not what was asked last."""
        moves = self._world.moves
        if self._laid_out != moves:
            if self._index.update():
                self._asked = None
            self._laid_out = moves
        seen = _EVERYTHING if seen is None else seen
        asked, known = self._asked or (None, None)
        if asked is subject and known is seen:
            return
        if known is not seen and seen is not _EVERYTHING:
            check_filter(seen)
        if asked is None or asked[1:] != subject[1:]:  # of discs that are alike only the place is another
            write_subject(self._index.memory, subject)
        if known is None or known != seen:
            self._asked = None
            self._hidden = write_filter(self._index.memory, seen, self._world.directory.body, self._hidden)
        self._asked = (subject, seen)


def _overlap(hit: tuple[Any, ...]) -> Overlap:
    body, shape, point, normal, distance = hit
    return Overlap(body, shape, point, normal, 0.0 - distance)
