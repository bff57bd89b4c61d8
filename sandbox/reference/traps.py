"""pymunk's traps by name: where its answer must not be taken at its word.

Three are avoided in how `ask_pymunk` asks, one is a matter of convention, and the others falsify answers whatever one
does: those are recognised, but only after exact arithmetic has found pymunk wrong. Measured on 7.3.1; `tests/reference`
proves each and says when a newer pymunk has mended it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sandbox.reference.answer import Answer
from sandbox.reference.exact_referee import Truth, nearest_line, overlap_along
from sandbox.reference.pair import Pair
from sandbox.reference.tolerance import ROUNDING, allowed_error, touch_tolerance

Handling = Literal["avoided", "convention", "recognised"]


@dataclass(frozen=True)
class Trap:
    """`name` is what reports say; `about` what pymunk does; `handling` what is done about it."""

    name: str
    about: str
    handling: Handling


ASSERTS_WHEN_APART = Trap(
    "asserts-when-apart", "shapes_collide raises AssertionError for shapes that are apart", "avoided"
)
STALE_TRANSFORMS = Trap(
    "stale-transforms", "a moved shape is judged at the pose it had when cache_bb() last ran", "avoided"
)
SIGN_OF_ORDER = Trap(
    "sign-of-order",
    "asked with the kinds in falling order (polygon, segment, circle) the distances have the wrong sign",
    "avoided",
)
TOUCHING_BOXES = Trap(
    "touching-boxes", "polygons that touch exactly collide with depth 0, while touching circles do not", "convention"
)
NO_AXIS = Trap(
    "no-axis",
    "cores whose middles coincide, and segments in one line, get the normal (0, 0) and the depth 0",
    "recognised",
)
IN_LINE = Trap(
    "in-line",
    "when a corner of one core lies exactly on the line through an edge of the other, shapes at any distance may be "
    "said to collide, and touching ones get a wrong depth, a wrong normal or no contact",
    "recognised",
)

CLIPPED_DEPTH = Trap(
    "clipped-depth",
    "the deepest point of a manifold is the deepest of two clipped edges; where the deepest corner lies beside both, "
    "the depth falls short of what parts the shapes along the same normal",
    "recognised",
)
BLURRED_NORMAL = Trap(
    "blurred-normal",
    "the normal of a circle and a segment is the way between two points in world coordinates, which says little where "
    "the circle's centre lies on the segment but for rounding",
    "recognised",
)

TRAPS = (
    ASSERTS_WHEN_APART, STALE_TRANSFORMS, SIGN_OF_ORDER, TOUCHING_BOXES, NO_AXIS, IN_LINE, CLIPPED_DEPTH,
    BLURRED_NORMAL,
)  # fmt: skip


def recognise(pair: Pair, wrong: Answer, truth: Truth, size: float, reach: float) -> Trap | None:
    """The trap behind a wrong answer of pymunk, if it is a known one; `size` and `reach` as in `tolerance`."""
    if wrong.normal == (0.0, 0.0):
        return NO_AXIS
    # pymunk turns shapes with its own sines, so what it sees exactly in line is so here but for rounding.
    if nearest_line(pair) <= touch_tolerance(size, reach):
        return IN_LINE
    if wrong.normal is None or wrong.separation is None or not truth.overlap:
        return None
    error, excess = allowed_error(size, reach), overlap_along(pair, wrong.normal) - truth.depth
    if excess <= error and -wrong.separation < truth.depth:
        return CLIPPED_DEPTH
    same_depth = abs(wrong.separation - truth.separation) <= error
    if pair.kinds == "circle-segment" and same_depth and excess <= _blur(pair, truth, size, reach):
        return BLURRED_NORMAL
    return None


def _blur(pair: Pair, truth: Truth, size: float, reach: float) -> float:
    """How much deeper (m) an axis may be that rounding has turned, given how near the cores come to each other."""
    way = truth.separation + pair.a.radius + pair.b.radius
    return size * min(1.0, 4.0 * ROUNDING * reach / way) if way > 0.0 else size
