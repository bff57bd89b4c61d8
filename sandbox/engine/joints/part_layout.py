"""The layout of one part, in numbers of its own: which rows its joints need, and in which order they are eliminated.

Parts that are built alike have the same layout, wherever they are; it is found once (`PartLayouts`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from itertools import compress, pairwise

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.direct.layout import DirectLayout, Link, direct_layout
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.tables import direct_tables
from sandbox.engine.joints.symbolic import Pattern, minimum_degree, symbolic
from sandbox.tables import Integers
from sandbox.world import joint_records as kinds

_BASE_SLOTS = {
    kinds.REVOLUTE: (0, 1), kinds.PRISMATIC: (0, 1), kinds.WELD: (0, 1, 2), kinds.WHEEL: (0,), kinds.GEAR: (0,),
    kinds.PULLEY: (0,), kinds.MOTOR: (0, 1, 2), kinds.TARGET: (0, 1), kinds.FRICTION: (0, 1, 2),
}  # fmt: skip
_SPRUNG = (kinds.DISTANCE, kinds.REVOLUTE, kinds.PRISMATIC, kinds.WHEEL)
UPDATES_A_ROW = 200
"""A part is factorised up to so many multiplications a row, and a few thousand more."""
WORLD = -1
"""In the place of a member: something that joints cannot move."""
NOBODY = -2
"""In the place of a member: the joint has no such side."""
COLUMNS = 10
"""Columns of what a layout depends on, for each joint: kind, spring, limit, motor, the members of up to 4 sides, and
for gears the kinds of the two joints that they couple."""


@dataclass(frozen=True)
class PartLayout:
    """All numbers count from the part's first joint, constraint or row.

    `order` are its joints as they are eliminated: constraint by constraint. Each row has a constraint and a slot.
    `anchored` if one of them holds it at something that does not move, `hung` if besides all keep a point or a length.
    `direct` is None in a part that is too dense to be factorised.
    """

    order: Integers
    constraints: Integers
    slots: Integers
    anchored: bool
    hung: bool
    direct: DirectLayout | None


@dataclass
class PartLayouts:
    """The layouts of the parts of a world, by what they depend on; and that of each part, in their order.

    Those that are factorised are numbered in the order in which parts first have them; `tables` are theirs, if they
    have been asked for since the last change, with working places for so many `workers`.
    """

    workers: int = 1
    known: dict[bytes, PartLayout] = field(default_factory=dict)
    parts: list[bytes] = field(default_factory=list)
    numbers: dict[bytes, int] = field(default_factory=dict)
    tables: Batches | None = None

    def of_parts(self, joints: NDArray[np.int32], ends: Integers, others: bool = False) -> list[PartLayout]:
        """The layout of each part; `joints` has `COLUMNS` for each joint, part after part, up to `ends`.

        Where there are `others`, they come behind those; else layouts that none of them has are forgotten.
        """
        keys = [joints[first:end].tobytes() for first, end in pairwise([0, *ends.tolist()])]
        kept = {key: self.known.get(key) or part_layout(key) for key in dict.fromkeys(keys)}
        self._know(self.known | kept if others else kept)
        if not others:
            self.parts = []
        self.parts += keys
        return [kept[key] for key in keys]

    def drop(self, going: NDArray[np.bool_]) -> None:
        """Forget parts, and the layouts that no other one has."""
        self.parts = list(compress(self.parts, (~going).tolist()))
        self._know({key: self.known[key] for key in dict.fromkeys(self.parts)})

    def factorised(self, first: int) -> tuple[Batches, Integers]:
        """The tables of the layouts that are factorised, and which of them each part has, from part `first` on; -1 is
        none."""
        if self.tables is None:
            direct = [each.direct for each in self.known.values() if each.direct is not None]
            self.tables = direct_tables(direct, self.workers)
        return self.tables, np.array([self.numbers.get(key, -1) for key in self.parts[first:]], np.int64)

    def _know(self, layouts: dict[bytes, PartLayout]) -> None:
        if list(layouts) != list(self.known):
            self.numbers = {key: n for n, key in enumerate(key for key, each in layouts.items() if each.direct)}
            self.tables = None
        self.known = layouts


@cache
def slots_of(kind: int, spring: bool, limit: bool, motor: bool) -> tuple[int, ...]:
    """The rows a joint needs; see `records.ROW`."""
    if kind == kinds.DISTANCE:
        base: tuple[int, ...] = () if spring or limit else (0,)
        driven = limit
    elif kind == kinds.WHEEL:
        base = (0, 2) if motor else (0,)
        driven = limit
    else:
        base = _BASE_SLOTS[kind]
        driven = kind in (kinds.REVOLUTE, kinds.PRISMATIC) and (limit or motor)
    return base + ((3,) if spring and kind in _SPRUNG else ()) + ((4,) if driven else ())


def shares_equation(slots: tuple[int, ...]) -> bool:
    """Whether the last row of a joint, its limit and motor, acts on the same coordinate as its spring before it."""
    return slots[-2:] == (3, 4)


def _keeps_place(kind: int, slots: tuple[int, ...]) -> bool:
    """Whether a joint keeps a point or a length, whatever pulls at it."""
    return kind in (kinds.REVOLUTE, kinds.WELD, kinds.DISTANCE) and 0 in slots


def _may_be_bounded(kind: int, slot: int) -> bool:
    brake = kind == kinds.WHEEL and slot == 2
    return slot == 4 or brake or kind in (kinds.MOTOR, kinds.TARGET, kinds.FRICTION)


def part_layout(key: bytes) -> PartLayout:
    """The layout of a part of those joints: rows of `COLUMNS` 32-bit numbers."""
    joints: list[list[int]] = np.frombuffer(key, np.int32).reshape(-1, COLUMNS).tolist()
    slots = [slots_of(kind, bool(spring), bool(limit), bool(motor)) for kind, spring, limit, motor, *_ in joints]
    sides = [[member for member in joint[4:8] if member != NOBODY] for joint in joints]
    neighbours = _neighbours(sides)
    weights = {j: len(each) - (1 if shares_equation(each) else 0) for j, each in enumerate(slots)}
    order, direct = minimum_degree(range(len(joints)), neighbours, weights, UPDATES_A_ROW)
    seats = [(seat, slot) for seat, j in enumerate(order) for slot in slots[j]]
    anchored = any(WORLD in each for each in sides)
    hung = anchored and all(_keeps_place(joint[0], each) for joint, each in zip(joints, slots, strict=True))
    columns = _column(order), _column([seat for seat, _ in seats]), _column([slot for _, slot in seats])
    if not direct:
        return PartLayout(*columns, anchored, hung, None)
    pattern, links = _eliminate(order, slots, sides, neighbours)
    bounded = any(_may_be_bounded(joint[0], slot) for joint, each in zip(joints, slots, strict=True) for slot in each)
    kinds_of = [(joints[j][0], joints[j][2] != 0, joints[j][3] != 0, joints[j][8], joints[j][9]) for j in order]
    found = direct_layout(kinds_of, [sides[j] for j in order], seats, links, pattern, bounded)
    return PartLayout(*columns, anchored, hung, found)


def _column(numbers: list[int]) -> Integers:
    return np.array(numbers, np.int64)


def _neighbours(sides: list[list[int]]) -> dict[int, list[int]]:
    """For each joint the others that share a member with it, in ascending order."""
    of_member: dict[int, list[int]] = {}
    for j, members in enumerate(sides):
        for member in dict.fromkeys(members):
            of_member.setdefault(member, []).append(j)
    of_member[WORLD] = []
    return {j: sorted({k for member in each for k in of_member[member]} - {j}) for j, each in enumerate(sides)}


def _eliminate(
    order: list[int],
    slots: list[tuple[int, ...]],
    sides: list[list[int]],
    neighbours: dict[int, list[int]],
) -> tuple[Pattern, list[Link]]:
    """Columns of the factor and the pairs of rows that add to it; what shares an equation has no column of its own."""
    rows: dict[int, list[int]] = {}
    count = 0
    for j in order:
        end = count + len(slots[j])
        rows[j] = list(range(count, end - 1 if shares_equation(slots[j]) else end))
        count = end
    place = {j: k for k, j in enumerate(order)}
    later = {j: [k for k in neighbours[j] if place[k] > place[j]] for j in order}
    pattern = Pattern()
    entry = symbolic([rows[j] for j in order], [[rows[k] for k in later[j]] for j in order], pattern)
    links: list[Link] = []
    for j in order:
        for r in rows[j]:
            for k in (j, *later[j]):
                shared = _shared_sides(sides[j], sides[k])
                links += [(s, r, b, a, entry[r, s]) for s in rows[k] if s >= r for a, b in shared]
    return pattern, links


def _shared_sides(one: list[int], two: list[int]) -> list[tuple[int, int]]:
    """Sides, from 1, at which two joints have the same member that they move."""
    return [
        (a, b) for a, member in enumerate(one, 1) for b, other in enumerate(two, 1) if member == other and member >= 0
    ]
