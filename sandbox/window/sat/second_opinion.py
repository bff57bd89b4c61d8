"""What pymunk says of a pair, beside what the engine says; and who is right where the two differ."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.geometry.collide import Contact
from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Shape

SAME_NORMAL = 1e-6
"""Radians by which two normals may differ and still be called the same."""

CLOSE = 1e-12
"""Share of a depth by which another may differ without any need to ask how large the shapes are."""


@dataclass(frozen=True)
class Opinion:
    """pymunk's answer: `depth` (m) and `normal` from a to b, None where it finds no contact.

    `same` tells whether it is that of the engine; `remark` says who is right if it is not, or why there is no answer.
    """

    asked: bool
    depth: float | None = None
    normal: Vec | None = None
    same: bool = True
    remark: str = ""


def opinion_on(a: Shape, b: Shape, ours: Contact | None) -> Opinion:
    """Ask pymunk about two shapes where they are; `ours` is what the engine says."""
    try:
        from sandbox.reference.answer import Answer
        from sandbox.reference.arbitration import arbitrate, size_and_reach
        from sandbox.reference.ask_pymunk import ask_pair
        from sandbox.reference.pair import Core, Pair
        from sandbox.reference.tolerance import allowed_error, touch_tolerance
    except ImportError as error:
        return Opinion(False, remark=f"pymunk cannot be asked: {error}")

    def core(shape: Shape, middle: Vec) -> Core:
        return Core(tuple((x - middle[0], y - middle[1]) for x, y in shape.vertices), shape.radius)

    middles = _middle(a), _middle(b)
    pair = Pair(core(a, middles[0]), core(b, middles[1]), *middles)
    theirs = ask_pair(pair)
    depth, normal = (None, None) if theirs is None else theirs
    if _same(ours, theirs, 0.0 if ours is None else CLOSE * ours.depth):
        return Opinion(True, depth, normal)
    size, reach = size_and_reach(pair)
    if _same(ours, theirs, allowed_error(size, reach)):
        return Opinion(True, depth, normal)
    if (theirs is None or abs(theirs[0]) <= touch_tolerance(size, reach)) and (
        ours is None or ours.depth <= touch_tolerance(size, reach)
    ):
        return Opinion(True, depth, normal, same=False, remark="They touch to within rounding: either may be said.")
    answer = Answer(False) if ours is None else Answer(True, -ours.depth, ours.normal)
    ruling = arbitrate(pair, answer, Answer.theirs(theirs))
    return Opinion(
        True, depth, normal, same=False, remark=_remark(bool(ruling.faults), ruling.their_faults, ruling.trap)
    )


def _same(ours: Contact | None, theirs: tuple[float, Vec] | None, allowed: float) -> bool:
    if ours is None or theirs is None:
        return ours is None and theirs is None
    (nx, ny), (mx, my) = ours.normal, theirs[1]
    turn = math.atan2(abs(nx * my - ny * mx), nx * mx + ny * my)
    return abs(ours.depth - theirs[0]) <= allowed and turn <= SAME_NORMAL


def _remark(wrong: bool, theirs: tuple[str, ...], trap: object) -> str:
    """Who is right, by exact arithmetic."""
    if wrong:
        return "Exact arithmetic says that the engine is wrong here: please save this pair and report it."
    if not theirs:
        return "Another axis, just as short: both are right."
    about = getattr(trap, "about", "")
    return f"Exact arithmetic agrees with the engine. pymunk: {about or theirs[0]}."


def _middle(shape: Shape) -> Vec:
    left, bottom, right, top = box_of(shape)
    return left + (right - left) / 2, bottom + (top - bottom) / 2
