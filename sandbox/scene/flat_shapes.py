"""From the shapes of a body to flat shapes: cores in the body's frame, surfaces and filters looked up."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from sandbox.geometry.polygon import convex_polygon, is_clockwise
from sandbox.geometry.rotation import cos_sin_degrees
from sandbox.scene.flat import FlatShape, Vec
from sandbox.scene.material import Material
from sandbox.scene.shapes import AnyShape, Box, Capsule, Circle, Polygon, Segment, Turnable

Kind = Literal["circle", "box", "capsule", "segment", "polygon"]

_DEFAULT = Material()


def flat_shape(shape: AnyShape, material: Material | None, categories: Sequence[str]) -> FlatShape:
    """One shape; `material` is the one that holds for it, `categories` the scene's names for bits."""
    kind, core, radius = _core(shape)
    base = material or _DEFAULT
    given = {name: getattr(shape, name) for name in Material.model_fields}
    surface = {name: getattr(base, name) if value is None else value for name, value in given.items()}
    return FlatShape(
        kind=kind,
        vertices=_placed(shape, core),
        radius=float(radius),
        category=_bits(shape.category, categories),
        mask=_bits(shape.mask, categories),
        group=shape.group,
        clockwise=isinstance(shape, Polygon) and is_clockwise(shape.polygon),
        **surface,
    )


def _core(shape: AnyShape) -> tuple[Kind, Sequence[Vec], float]:
    """Kind, core about the shape's own origin, and radius."""
    match shape:
        case Circle():
            return "circle", [(0.0, 0.0)], shape.circle
        case Box():
            x, y = shape.box[0] / 2 - shape.radius, shape.box[1] / 2 - shape.radius
            return "box", [(-x, -y), (x, -y), (x, y), (-x, y)], shape.radius
        case Capsule():
            return "capsule", shape.capsule, shape.radius
        case Segment():
            return "segment", shape.segment, shape.radius
        case Polygon():
            return "polygon", convex_polygon(shape.polygon), shape.radius
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
