"""pymunk's traps by name: where its answer must not be taken at its word.

Three are avoided in how `ask_pymunk` asks, one is a matter of convention, and two falsify answers whatever one does:
those are recognised, but only after exact arithmetic has found pymunk wrong. Measured on 7.3.1; `tests/reference`
proves each and says when a newer pymunk has mended it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sandbox.reference.exact_referee import nearest_line
from sandbox.reference.pair import Pair, Point

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

TRAPS = (ASSERTS_WHEN_APART, STALE_TRANSFORMS, SIGN_OF_ORDER, TOUCHING_BOXES, NO_AXIS, IN_LINE)


def recognise(pair: Pair, normal: Point | None, tolerance: float) -> Trap | None:
    """The trap behind a wrong answer of pymunk, given its `normal` (None when it saw no contact), if it is known.

    `tolerance` (m) is how far rounding may have moved the shapes: pymunk turns them with its own sines.
    """
    if normal == (0.0, 0.0):
        return NO_AXIS
    return IN_LINE if nearest_line(pair) <= tolerance else None
