"""The shapes of a body, each told by its own key."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import AfterValidator, Field, Tag, ValidationInfo
from pydantic_core import PydanticCustomError

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import MIN_EDGE, PolygonError
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.effort import effort
from sandbox.scene.limits import ALL_BITS, MAX_OUTLINE
from sandbox.scene.material import Surface
from sandbox.scene.objects import known_as
from sandbox.scene.quantities import (
    Bits,
    ChainPoints,
    Degrees,
    Ends,
    Holes,
    LocalPoint,
    Name,
    Outline,
    Rounding,
    Size,
    Size2,
)
from sandbox.scene.union import TAG, by_key, by_type

Names = Annotated[tuple[Name, ...], Listed('["name", ...]', 0, 32)]
Categories = Annotated[
    Annotated[Bits, Tag(TAG + "number")] | Annotated[Name, Tag(TAG + "text")] | Annotated[Names, Tag(TAG + "list")],
    by_type("a category name, a list of names, or a whole number used as bits"),
]
"""A category name, several, or the bits themselves."""


def _check_ends(ends: Ends) -> Ends:
    (ax, ay), (bx, by) = ends
    if max(abs(bx - ax), abs(by - ay)) < 1e-6:
        raise PydanticCustomError("ends", "the two ends are the same point", {"place": [1]})
    return ends


def _check_polygon(outline: Outline) -> Outline:
    _sound_parts(outline)
    return outline


def _sound_parts(outline: Outline, holes: Holes = ()) -> int:
    """How many convex parts a polygon has; 0 where too many are wrong already to look into one more."""
    if effort().outlines <= 0:
        return 0
    try:
        return len(decompose(outline, holes).parts)
    except PolygonError as error:
        effort().outlines -= 1
        place = _place(error.hole, error.index) if holes else _place(error.index)
        raise PydanticCustomError("polygon", str(error), {"place": place}) from None


def _check_holes(holes: Holes, info: ValidationInfo) -> Holes:
    """Nothing is said about the holes of an outline that is refused."""
    if "polygon" not in info.data:
        return holes
    outline = info.data["polygon"]
    count = len(outline) + sum(map(len, holes))
    if count > MAX_OUTLINE:
        text = f"the polygon and its holes have {count} vertices; {MAX_OUTLINE} is the limit"
        raise PydanticCustomError("polygon", text, {"place": []})
    _sound_parts(outline, holes)
    return holes


def _check_rounding(radius: float, info: ValidationInfo) -> float:
    known = radius > 0.0 and "polygon" in info.data and "holes" in info.data
    if known and _sound_parts(info.data["polygon"], info.data["holes"]) > 1:
        raise PydanticCustomError("rounding", "must be 0 for a polygon that is concave or has holes")
    return radius


def _check_chain(points: ChainPoints) -> ChainPoints:
    for k in range(1, len(points)):
        if math.dist(points[k - 1], points[k]) < MIN_EDGE:
            raise PydanticCustomError("chain", "this point is the same as the one before it", {"place": [k]})
    return points


def _check_closed(closed: bool, info: ValidationInfo) -> bool:
    if not closed or "chain" not in info.data:
        return closed
    points = info.data["chain"]
    if len(points) < 3:
        raise PydanticCustomError("chain", "a closed chain needs 3 points")
    if math.dist(points[0], points[-1]) < MIN_EDGE:
        text = "a closed chain leads back to its first point by itself: leave out the last one, which is the same"
        raise PydanticCustomError("chain", text)
    return closed


def _check_ghosts(ghosts: Ends | None, info: ValidationInfo) -> Ends | None:
    if ghosts is None or "chain" not in info.data:
        return ghosts
    if info.data.get("closed"):
        raise PydanticCustomError("ghosts", "a closed chain has no ends: leave out the ghosts")
    points = info.data["chain"]
    for k, end in enumerate((points[0], points[-1])):
        if math.dist(ghosts[k], end) < MIN_EDGE:
            raise PydanticCustomError("ghosts", "this ghost is the end of the chain itself", {"place": [k]})
    return ghosts


def _check_one_way(way: LocalPoint | None) -> LocalPoint | None:
    if way is not None and math.hypot(*way) < MIN_EDGE:
        raise PydanticCustomError("one_way", "must be a direction such as [0, 1], not zero")
    return way


def _place(*indices: int | None) -> list[int]:
    return [index for index in indices if index is not None]


class AnyShape(Surface):
    """What all shapes have: a place in the body, a surface, a collision filter."""

    at: LocalPoint = Field(default=(0.0, 0.0), description="Offset from the body's position, in the body's frame, m.")
    material: Name | None = Field(default=None, description="Name of a material; default: the body's.")
    category: Categories = Field(default=1, description='What the shape is, for filters; default "default".')
    mask: Categories = Field(default=ALL_BITS, description="What the shape collides with; default: everything.")
    sensor: Annotated[bool, Field(description="true: reports what overlaps it, pushes nothing, weighs nothing.")] = (
        False
    )
    group: Annotated[int, Range(-(2**31), 2**31 - 1)] = Field(
        default=0,
        description="Shapes of the same positive group always collide, of the same negative group never.",
    )
    one_way: Annotated[LocalPoint | None, AfterValidator(_check_one_way)] = Field(
        default=None,
        description="Direction [x, y] in which everything passes; what comes against it lands. Turns with the shape.",
    )


class CircleShape(AnyShape):
    """A disc."""

    circle: Size = Field(description="Radius, m.")


class Turnable(AnyShape):
    """A shape that can be turned about its offset."""

    angle: Degrees = Field(default=0.0, description="Turn about `at`, degrees, counter-clockwise.")


@known_as("a shape")
class BoxShape(Turnable):
    """A rectangle, centred on `at`."""

    box: Size2 = Field(description="Outer width and height, m.")
    radius: Rounding = Field(
        default=0.0,
        description="Rounds the corners inwards, m: the outer size stays; less than half the smaller side.",
    )


class CapsuleShape(Turnable):
    """All points within `radius` of the line between two points."""

    capsule: Annotated[Ends, AfterValidator(_check_ends)] = Field(description="The two centers [[x, y], [x, y]], m.")
    radius: Size = Field(description="Distance of the outline from the line, m.")


class SegmentShape(Turnable):
    """A line between two points, solid from both sides; it has no mass unless it has a radius."""

    segment: Annotated[Ends, AfterValidator(_check_ends)] = Field(description="The two ends [[x, y], [x, y]], m.")
    radius: Rounding = Field(default=0.0, description="Thickness to each side, m.")


class PolygonShape(Turnable):
    """A polygon of 3 to 1000 vertices, in either winding; it may be concave and have holes."""

    polygon: Annotated[Outline, AfterValidator(_check_polygon)] = Field(
        description="Vertices [[x, y], ...], m, or a path in the syntax of SVG; repeated vertices and ones on a "
        "straight side are dropped."
    )
    holes: Annotated[Holes, AfterValidator(_check_holes)] = Field(
        default=(), description="Outlines of holes [[[x, y], ...], ...], m: within the polygon, apart from each other."
    )
    radius: Annotated[Rounding, AfterValidator(_check_rounding)] = Field(
        default=0.0, description="Rounds the corners of a convex polygon outwards, m: the shape grows by it."
    )


class ChainShape(Turnable):
    """Lines from point to point, smooth at the joints; they have no mass unless they have a radius."""

    chain: Annotated[ChainPoints, AfterValidator(_check_chain)] = Field(
        description="The points [[x, y], ...], m, or a path in the syntax of SVG."
    )
    closed: Annotated[bool, AfterValidator(_check_closed)] = Field(
        default=False, description="true: a last line leads from the last point to the first."
    )
    one_sided: bool = Field(
        default=False, description="true: solid only from the left of its direction; what comes from the right passes."
    )
    ghosts: Annotated[Ends | None, AfterValidator(_check_ghosts)] = Field(
        default=None,
        description="The point before the first and the one after the last, m: the ends are smooth as if there were "
        "lines to them.",
    )
    radius: Rounding = Field(default=0.0, description="Thickness to each side, m.")


SHAPES: dict[str, type[AnyShape]] = {
    "circle": CircleShape,
    "box": BoxShape,
    "capsule": CapsuleShape,
    "segment": SegmentShape,
    "polygon": PolygonShape,
    "chain": ChainShape,
}
"""Every kind of shape by its key."""

Shape = Annotated[
    Annotated[CircleShape, Tag(TAG + "circle")]
    | Annotated[BoxShape, Tag(TAG + "box")]
    | Annotated[CapsuleShape, Tag(TAG + "capsule")]
    | Annotated[SegmentShape, Tag(TAG + "segment")]
    | Annotated[PolygonShape, Tag(TAG + "polygon")]
    | Annotated[ChainShape, Tag(TAG + "chain")],
    by_key("shape", SHAPES),
]
"""Any shape; exactly one of the keys of `SHAPES` tells which."""
