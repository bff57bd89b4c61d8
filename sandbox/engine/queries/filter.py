"""Which shapes a query sees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sandbox._jit import kernel
from sandbox.tables import Integers, Records

ALL_BITS = 0xFFFFFFFF


@dataclass(frozen=True)
class Filter:
    """Which shapes a query sees: all of these have to agree. Without a filter it sees every solid shape.

    `mask` is the bit set of categories that are seen. `category` is what the query itself counts as: given, shapes
    whose own mask has none of its bits are passed over; None leaves their masks out of it. As between shapes, a common
    `group` decides in place of both: positive is seen, negative is not. Bodies whose id is in `exclude`, or whose type
    is not in `types`, are passed over. Sensors are seen only with `sensors=True`.
    """

    mask: int = ALL_BITS
    category: int | None = None
    group: int = 0
    exclude: tuple[str, ...] = ()
    types: tuple[Literal["static", "kinematic", "dynamic"], ...] = ("static", "kinematic", "dynamic")
    sensors: bool = False


@kernel
def is_seen(question: Records, shape: Records, body_type: int, hidden: Integers) -> bool:
    """Whether a query sees a shape; `hidden` has a 1 for each excluded body."""
    if shape.sensor > question.sensors:
        return False
    if hidden[shape.body] != 0 or (question.types >> body_type) & 1 == 0:
        return False
    if question.group == shape.group and shape.group != 0:
        return bool(shape.group > 0)
    heard = question.category == 0 or (question.category & shape.mask) != 0
    return bool(heard and (question.mask & shape.category) != 0)
