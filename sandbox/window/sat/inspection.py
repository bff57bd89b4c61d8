"""One pair of shapes under the magnifying glass: its table, its curve, its clipping and pymunk's answer, made once."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.geometry.clip_steps import Clipping, clipping
from sandbox.geometry.nearest_pair import nearest_pair
from sandbox.geometry.sat_rows import SatRow, Vec, author_edges
from sandbox.geometry.sat_table import SatTable, sat_table
from sandbox.geometry.shapes import Shape
from sandbox.render.sat_labels import deciding_row
from sandbox.window.sat.overlap_curve import OverlapCurve, overlap_curve
from sandbox.window.sat.second_opinion import Opinion, opinion_on

Numbers = tuple[int, int]
Edge = tuple[Vec, Vec, Vec]
"""Start, end (m) and outward unit normal."""


@dataclass(frozen=True)
class Inspection:
    """Two bodies, which of their shapes are looked at (from 0, of how many), and the table of all axes."""

    names: tuple[str, str]
    numbers: Numbers
    counts: tuple[int, int]
    table: SatTable

    @property
    def a(self) -> Shape:
        """The first shape."""
        return self.table.a

    @property
    def b(self) -> Shape:
        """The second shape."""
        return self.table.b

    @cached_property
    def tested(self) -> int:
        """How many axes the test looks at before it is decided."""
        stopped = self.table.stopped
        return len(self.table.rows) if stopped is None else stopped.number

    @cached_property
    def deciding(self) -> SatRow:
        """The row that parts the shapes, or the one of the shortest way out."""
        return deciding_row(self.table)

    @cached_property
    def curve(self) -> OverlapCurve:
        """Overlap over the axis' angle."""
        return overlap_curve(self.table)

    @cached_property
    def clip(self) -> Clipping | None:
        """How the contact points come about; None where there is no contact or nothing to clip."""
        return None if self.table.contact is None else clipping(self.a, self.b, self.table.contact)

    @cached_property
    def opinion(self) -> Opinion:
        """What pymunk says."""
        return opinion_on(self.a, self.b, self.table.contact)

    @cached_property
    def edges(self) -> dict[tuple[str, int], Edge]:
        """The edges of both shapes by owner and author's number: on the surface, hence moved out by the radius."""
        return {
            (owner, number): surface_edge(shape, start, end)
            for owner, shape in (("a", self.a), ("b", self.b))
            for number, start, end in author_edges(shape)
        }

    def row(self, number: int | None) -> SatRow | None:
        """The row of that number, from 1; None if there is none."""
        return self.table.rows[number - 1] if number is not None and 0 < number <= len(self.table.rows) else None


class Inspector:
    """Keeps the inspection of the pair looked at last, for as long as nothing moves. `trouble` says why there is none.

    `numbers` are the shapes that the user chose; None: the deepest pair, or else the nearest one.
    """

    def __init__(self) -> None:
        self.numbers: Numbers | None = None
        self.trouble = ""
        self._names: tuple[str, str] | None = None
        self._key: object = None
        self._kept: Inspection | None = None
        self._shapes: dict[str, tuple[object, tuple[Shape, ...]]] = {}

    def look(self, world: World, names: tuple[str, str] | None) -> Inspection | None:
        """The pair as it is now; None if no pair is picked, it is not there at this step, or cannot be looked at."""
        if names != self._names:
            self._names, self.numbers = names, None
            self._shapes.clear()
        key = (world, world.changes, names, self.numbers)
        if key != self._key:
            self._key = key
            self._kept, self.trouble = None, ""
            if names is not None and all(map(world.directory.has_body, names)):
                try:
                    self._kept = self._inspect(world, names)
                except SandboxError as error:
                    self.trouble = str(error)
        return self._kept

    def _inspect(self, world: World, names: tuple[str, str]) -> Inspection:
        """Raises `SandboxError` for a pair that is none."""
        if names[0] == names[1]:
            raise SandboxError(f"{names[0]} with itself is no pair: pick two bodies")
        first, second = self._shapes_of(world, names[0]), self._shapes_of(world, names[1])
        i, j = self.numbers or nearest_pair(first, second)
        i, j = min(i, len(first) - 1), min(j, len(second) - 1)
        return Inspection(names, (i, j), (len(first), len(second)), sat_table(first[i], second[j], all_axes=True))

    def _shapes_of(self, world: World, name: str) -> tuple[Shape, ...]:
        """The shapes of a body; those of one that stands still are made once."""
        body = world.body(name)
        serial = world.state.census.bodies.serials[world.directory.body(name)]
        key = world, serial, body.position, body.angle
        kept = self._shapes.get(name)
        if kept is None or kept[0] != key:
            self._shapes[name] = kept = key, body.shapes
        return kept[1]


def surface_edge(shape: Shape, start: Vec, end: Vec) -> Edge:
    """An edge of the core of a shape as it lies on the surface."""
    long = math.dist(start, end)
    nx, ny = (end[1] - start[1]) / long, (start[0] - end[0]) / long
    inner = shape.vertices
    if sum(nx * (x - start[0]) + ny * (y - start[1]) for x, y in inner) > 0.0:
        nx, ny = -nx, -ny
    r = shape.radius
    return (start[0] + nx * r, start[1] + ny * r), (end[0] + nx * r, end[1] + ny * r), (nx, ny)
