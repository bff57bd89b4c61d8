"""Shapes of a recording as fixtures of a Box2D world."""

from __future__ import annotations

import math

from sandbox.formats.b2rec.made import Made
from sandbox.formats.box2d.world import Fixture, Outline
from sandbox.formats.numbers import Vec
from sandbox.formats.reading import MisreadError
from sandbox.formats.remarks import Remarks

_ALL_BITS = 0xFFFFFFFF
_CORNERS = 8


def fixture_of(made: Made, place: str, remarks: Remarks) -> Fixture:
    """A shape, or a chain, with its surface and filter. Raises `MisreadError`."""
    values, is_chain = made.values, made.kind == "chain"
    surface = values["materials"][0] if is_chain and values["materials"] else values
    if is_chain and any(each != surface for each in values["materials"]):
        remarks.note(place, "a chain of several materials has the first one all along")
    outline = outline_of(made, place)
    filters = values["filter"]
    if filters["categoryBits"] > _ALL_BITS or filters["maskBits"] not in (2**64 - 1, filters["maskBits"] & _ALL_BITS):
        remarks.note(place, "of 64 bits of a filter the lower 32 are kept")
    rolling = surface["rollingResistance"]
    if rolling > 0.0 and outline.radius <= 0.0:
        remarks.note(place, "rolling resistance of a shape that is not round is left out")
    return Fixture(
        place=place,
        outline=outline,
        density=values.get("density", 0.0),
        friction=surface["friction"],
        restitution=surface["restitution"],
        sensor=values.get("isSensor", False),
        category=filters["categoryBits"],
        mask=filters["maskBits"],
        group=filters["groupIndex"],
        everything=_ALL_BITS,
        rolling_resistance=rolling * outline.radius,
        surface_speed=surface["tangentSpeed"],
    )


def outline_of(made: Made, place: str = "") -> Outline:
    """The form of a shape, or a chain. Raises `MisreadError` for a polygon that Box2D does not have."""
    values, shape = made.values, made.values["geometry"]
    if made.kind == "circle":
        return Outline("circle", [shape["center"]], shape["radius"])
    if made.kind == "capsule":
        return Outline("capsule", [shape["center1"], shape["center2"]], shape["radius"])
    if made.kind == "segment":
        return Outline("chain", [shape["point1"], shape["point2"]])
    if made.kind == "chainsegment":
        ends = [shape["point2"], shape["point1"]]
        return Outline("chain", ends, before=shape["ghost2"], after=shape["ghost1"], one_sided=True)
    if made.kind == "chain":
        # There it is solid from the right of it.
        points = values["points"][::-1]
        if values["isLoop"] or len(points) < 4:
            return Outline("chain", points, closed=values["isLoop"], one_sided=True)
        return Outline("chain", points[1:-1], before=points[0], after=points[-1], one_sided=True)
    if not 3 <= shape["count"] <= _CORNERS:
        raise MisreadError((), f"{place} is a polygon of {shape['count']} corners; it can have 3 to {_CORNERS}")
    flat = shape["vertices"]
    return Outline("polygon", [(flat[2 * k], flat[2 * k + 1]) for k in range(shape["count"])], shape["radius"])


def weighed(outline: Outline) -> Outline:
    """What a shape weighs as: `b2ComputePolygonMass` moves rounded corners outwards by root 2 of the radius."""
    if outline.kind != "polygon" or outline.radius <= 0.0:
        return outline
    corners, moved = outline.points, []
    for k, (x, y) in enumerate(corners):
        (ax, ay), (bx, by) = _normal(corners[k - 1], (x, y)), _normal((x, y), corners[(k + 1) % len(corners)])
        length = math.hypot(ax + bx, ay + by) or 1.0
        reach = math.sqrt(2.0) * outline.radius / length
        moved.append((x + reach * (ax + bx), y + reach * (ay + by)))
    return Outline("polygon", moved)


def _normal(a: Vec, b: Vec) -> Vec:
    length = math.dist(a, b) or 1.0
    return (b[1] - a[1]) / length, (a[0] - b[0]) / length
