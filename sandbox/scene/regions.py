"""Regions: areas in which a field pushes what is in them."""

from __future__ import annotations

import math
from abc import abstractmethod
from typing import Annotated, Any

from pydantic import AfterValidator, Field, Tag
from pydantic_core import PydanticCustomError

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import MAX_VERTICES, PolygonError
from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.flat import INFINITE, FlatRegion, Vec
from sandbox.scene.quantities import (
    Acceleration2,
    Coordinate,
    Damping,
    Density,
    Distance,
    Factor,
    Name,
    Point,
    Ratio,
    Rectangle,
    Seconds,
    Size,
    Velocity2,
)
from sandbox.scene.union import TAG, by_key

Edge = tuple[float, float, float]


def _side(start: Vec, end: Vec) -> Edge:
    """The half-plane on the left of a side."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.sqrt(dx * dx + dy * dy)
    nx, ny = dy / length, -dx / length
    return nx, ny, nx * start[0] + ny * start[1]


def _check_convex(outline: tuple[Any, ...]) -> tuple[Any, ...]:
    try:
        parts = decompose(outline).parts
    except PolygonError as error:
        place = [] if error.index is None else [error.index]
        raise PydanticCustomError("polygon", str(error), {"place": place}) from None
    if len(parts) > 1:
        raise PydanticCustomError("polygon", "the area is not convex; use several regions", {"place": []})
    return outline


Disc = Annotated[tuple[Coordinate, Coordinate, Size], Listed("[x, y, radius]", 3, 3)]
Convex = Annotated[
    tuple[Point, ...], Listed("[[x, y], [x, y], [x, y], ...]", 3, MAX_VERTICES), AfterValidator(_check_convex)
]
Strength = Annotated[float, Range(-1e15, 1e15)]
Falloff = Annotated[int, Range(0, 3)]


class Region(Model):
    """What all regions have: an id, an area and a schedule."""

    id: Name | None = Field(default=None, description="A name that no other region has, for commands.")
    inside: Rectangle | None = Field(default=None, description="Its area [left, bottom, right, top], m.")
    disc: Disc | None = Field(default=None, description="Its area is a disc [x, y, radius], m.")
    outline: Convex | None = Field(default=None, description="Its area is a convex polygon [[x, y], ...], m.")
    start: Seconds = Field(default=0.0, description="When it begins to act, s.")
    end: Seconds | None = Field(default=None, description="When it ceases to act, s; default: never.")

    @abstractmethod
    def flat(self) -> FlatRegion:
        """The region in SI units."""

    def shared(self) -> dict[str, Any]:
        """The fields of a flat region that all kinds have."""
        end = INFINITE if self.end is None else self.end
        return {"id": self.id or "", "edges": self._edges(), "disc": self.disc, "start": self.start, "end": end}

    def _edges(self) -> tuple[Edge, ...]:
        if self.inside is not None:
            left, bottom, right, top = self.inside
            return (-1.0, 0.0, -left), (0.0, -1.0, -bottom), (1.0, 0.0, right), (0.0, 1.0, top)
        if self.outline is None:
            return ()
        corners = decompose(self.outline).parts[0].vertices
        return tuple(_side(*ends) for ends in zip(corners, [*corners[1:], corners[0]], strict=True))


class Water(Region):
    """Water: lifts what is in it by the weight of what it displaces, and slows it."""

    water: Density = Field(description="Density, kg/m^2.")
    surface: Coordinate | None = Field(default=None, description="Height of its surface, m; default: the area is full.")
    drag: Damping = Field(default=1.0, description="A body as dense as the water loses speed as v' = -drag v, 1/s.")
    angular_drag: Damping | None = Field(default=None, description="The same for its spin, 1/s; default: drag.")
    flow: Velocity2 = Field(default=(0.0, 0.0), description="Velocity of the water [x, y], m/s.")

    def flat(self) -> FlatRegion:
        """The region in SI units; the surface is one more edge."""
        shared = self.shared()
        if self.surface is not None:
            shared["edges"] = (*shared["edges"], (0.0, 1.0, self.surface))
            shared["surfaced"] = True
        turning = self.drag if self.angular_drag is None else self.angular_drag
        return FlatRegion(
            "water", **shared, density=self.water, drag=self.drag, angular_drag=turning, flow=self.flow
        )  # fmt: skip


class Gravity(Region):
    """Another gravity than the scene's, for bodies whose centre is in the area."""

    gravity: Acceleration2 = Field(description="Instead of the scene's [x, y], m/s^2.")

    def flat(self) -> FlatRegion:
        """The region in SI units."""
        return FlatRegion("gravity", **self.shared(), gravity=self.gravity)


class GravityScale(Region):
    """More or less of the gravity that there is, for bodies whose centre is in the area."""

    gravity_scale: Factor = Field(description="Multiplies gravity.")

    def flat(self) -> FlatRegion:
        """The region in SI units."""
        return FlatRegion("gravity_scale", **self.shared(), scale=self.gravity_scale)


class Attraction(Region):
    """A point that attracts: acceleration of attraction / distance^falloff."""

    attraction: Strength = Field(description="Acceleration at a distance of 1 m, m/s^2; negative repels.")
    at: Point = Field(default=(0.0, 0.0), description="Where to, m.")
    falloff: Falloff = Field(default=2, description="Power of the distance it falls with, 0 to 3; 2 is Newton's.")
    core: Size = Field(default=0.1, description="Nearer than this it falls to nothing, m.")
    range: Distance | None = Field(default=None, description="Farther than this there is none, m; default: everywhere.")

    def flat(self) -> FlatRegion:
        """The region in SI units."""
        return FlatRegion(
            "attraction", **self.shared(), strength=self.attraction, center=self.at, falloff=self.falloff,
            core=self.core, range=INFINITE if self.range is None else self.range,
        )  # fmt: skip


class Wind(Region):
    """Air, still or moving, that presses on every edge that meets it."""

    wind: Velocity2 = Field(description="Velocity of the air [x, y], m/s; [0, 0] is still air that slows.")
    density: Density = Field(default=0.01, description="Of the air, kg/m^2.")
    drag: Ratio = Field(default=2.0, description="Pressure on a face that meets the air squarely, by density v^2 / 2.")

    def flat(self) -> FlatRegion:
        """The region in SI units."""
        return FlatRegion("wind", **self.shared(), density=self.density, drag=self.drag, flow=self.wind)


REGIONS: dict[str, type[Region]] = {
    "water": Water,
    "gravity": Gravity,
    "gravity_scale": GravityScale,
    "attraction": Attraction,
    "wind": Wind,
}
"""Every kind of region by its key."""

AnyRegion = Annotated[
    Annotated[Water, Tag(TAG + "water")]
    | Annotated[Gravity, Tag(TAG + "gravity")]
    | Annotated[GravityScale, Tag(TAG + "gravity_scale")]
    | Annotated[Attraction, Tag(TAG + "attraction")]
    | Annotated[Wind, Tag(TAG + "wind")],
    by_key("region", REGIONS),
]
"""Any region; exactly one of the keys of `REGIONS` tells which."""
