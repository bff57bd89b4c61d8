"""Bodies of files that know shapes but no places: side by side on y = 0, in the order of the file."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from sandbox.formats.draft import Draft
from sandbox.formats.numbers import Vec, tidy_point
from sandbox.formats.outlines import Words

_GAP = 0.25
"""Between two bodies, as a share of the wider one."""


@dataclass
class Item:
    """A body without a place: its fields, its shapes, and points (m) that show how far they reach."""

    name: str
    place: str
    words: Words = field(default_factory=dict)
    shapes: list[Words] = field(default_factory=list)
    reach: list[Vec] = field(default_factory=list)


def put_on_shelf(items: Iterable[Item], draft: Draft) -> None:
    """Bring the items into the draft; what has no shapes is left out with a remark."""
    right, before = 0.0, 0.0
    for item in items:
        if not item.shapes:
            draft.remarks.note(item.place, "a body without shapes is left out")
            continue
        left, low = (min(point[axis] for point in item.reach) for axis in (0, 1))
        width = max(point[0] for point in item.reach) - left
        start = right + _GAP * max(width, before) if before else 0.0
        place = tidy_point((start - left, -low))
        draft.add_body(item.name, {**item.words, "position": place, "shapes": item.shapes})
        right, before = start + width, width
    if before:
        draft.remarks.note("", "the file has no places: bodies stand side by side")
