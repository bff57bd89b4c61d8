"""From the shapes of a body to flat shapes: cores in the body's frame, surfaces and filters looked up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Literal

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import is_clockwise
from sandbox.geometry.rotation import cos_sin_degrees
from sandbox.scene.flat import FlatShape, Vec
from sandbox.scene.flat_chain import left_of, links, seams
from sandbox.scene.material import Material
from sandbox.scene.shapes import (
    AnyShape,
    BoxShape,
    CapsuleShape,
    ChainShape,
    CircleShape,
    PolygonShape,
    SegmentShape,
    Turnable,
)

Kind = Literal["circle", "box", "capsule", "segment", "polygon"]

_DEFAULT = Material()
_SURFACE = tuple(name for name in Material.model_fields if name != "bumper")  # which only allows


def flat_shapes(
    shape: AnyShape, material: Material | None, categories: Sequence[str], name: str = ""
) -> Iterator[FlatShape]:
    """One flat shape, or the parts of a concave polygon; `material` is the one that holds for it and `name` what it is
    called, `categories` the scene's names for bits.
    """
    base = material or _DEFAULT
    given = {name: getattr(shape, name) for name in _SURFACE}
    surface: dict[str, Any] = {name: getattr(base, name) if value is None else value for name, value in given.items()}
    surface["category"], surface["mask"] = _bits(shape.category, categories), _bits(shape.mask, categories)
    surface["group"], surface["sensor"], surface["material"] = shape.group, shape.sensor, name
    if shape.one_way is not None:
        surface["one_way"] = _direction(shape, shape.one_way)
    if isinstance(shape, PolygonShape):
        yield from _polygon(shape, surface)
    elif isinstance(shape, ChainShape):
        yield from _chain(shape, surface)
    else:
        kind, core, radius = _core(shape)
        yield FlatShape(kind, _placed(shape, core), float(radius), **surface)


def _polygon(shape: PolygonShape, surface: dict[str, Any]) -> Iterator[FlatShape]:
    """A convex polygon as it is, another one in parts."""
    rings, parts = decompose(shape.polygon, shape.holes)
    if len(parts) == 1:
        surface["clockwise"] = is_clockwise(shape.polygon)
        yield FlatShape("polygon", _placed(shape, parts[0].vertices), float(shape.radius), **surface)
        return
    outline = tuple(_placed(shape, ring) for ring in rings)
    for number, part in enumerate(parts, 1):
        core = _placed(shape, part.vertices)
        yield FlatShape("polygon", core, **surface, part=number, shown=part.shown, outline=outline)


def _chain(shape: ChainShape, surface: dict[str, Any]) -> Iterator[FlatShape]:
    """Its links: segments that are smooth at their joints."""
    points = _placed(shape, shape.chain)
    ghosts = _placed(shape, shape.ghosts) if shape.ghosts else None
    rows = seams(points, shape.closed, shape.one_sided, ghosts)
    for number, (link, seam) in enumerate(zip(links(points, shape.closed), rows, strict=True), 1):
        if shape.one_sided:
            surface["one_way"] = left_of(link)
        yield FlatShape("segment", link, float(shape.radius), **surface, part=number, seam=tuple(seam))


def _direction(shape: AnyShape, way: Vec) -> Vec:
    """A unit direction, turned with the shape."""
    cos, sin = cos_sin_degrees(shape.angle) if isinstance(shape, Turnable) else (1.0, 0.0)
    length = math.hypot(*way)
    x, y = way[0] / length, way[1] / length
    return cos * x - sin * y + 0.0, sin * x + cos * y + 0.0


def _core(shape: AnyShape) -> tuple[Kind, Sequence[Vec], float]:
    """Kind, core about the shape's own origin, and radius; polygons may be several."""
    match shape:
        case CircleShape():
            return "circle", [(0.0, 0.0)], shape.circle
        case BoxShape():
            x, y = shape.box[0] / 2 - shape.radius, shape.box[1] / 2 - shape.radius
            return "box", [(-x, -y), (x, -y), (x, y), (-x, y)], shape.radius
        case CapsuleShape():
            return "capsule", shape.capsule, shape.radius
        case SegmentShape():
            return "segment", shape.segment, shape.radius
    raise TypeError(type(shape).__name__)


def _placed(shape: AnyShape, core: Sequence[Vec]) -> tuple[Vec, ...]:
    """The core turned and moved to its place in the body."""
    cos, sin = cos_sin_degrees(shape.angle) if isinstance(shape, Turnable) else (1.0, 0.0)
    left, up = shape.at
    # Adding 0.0 turns -0.0 into 0.0, so that equal cores have equal bits.
    return tuple((left + (cos * x - sin * y) + 0.0, up + (sin * x + cos * y) + 0.0) for x, y in core)


def _bits(value: int | str | Sequence[str], categories: Sequence[str]) -> int:
    if isinstance(value, int):
        return value
    names = [value] if isinstance(value, str) else value
    return sum(1 << (["default", *categories].index(name)) for name in dict.fromkeys(names))
