"""The layout of one part, in numbers of its own: which rows its joints need, and in which order they are eliminated.

Parts that are built alike have the same layout, wherever they are; it is found once (`PartLayouts`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from itertools import compress, pairwise

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.augmented import ROWS_OF_BODY, augment
from sandbox.engine.joints.direct.layout import DirectLayout, JointRows, direct_layout
from sandbox.engine.joints.direct.records import BODY, Batches
from sandbox.engine.joints.direct.tables import direct_tables
from sandbox.engine.joints.elimination import NOBODY, WORLD, Elimination, minimum_degree
from sandbox.engine.joints.symbolic import symbolic
from sandbox.tables import Integers
from sandbox.world import joint_records as kinds

_BASE_SLOTS = {
    kinds.REVOLUTE: (0, 1), kinds.PRISMATIC: (0, 1), kinds.WELD: (0, 1, 2), kinds.WHEEL: (0,), kinds.GEAR: (0,),
    kinds.PULLEY: (0,), kinds.MOTOR: (0, 1, 2), kinds.TARGET: (0, 1), kinds.FRICTION: (0, 1, 2),
}  # fmt: skip
_SPRUNG = (kinds.DISTANCE, kinds.REVOLUTE, kinds.PRISMATIC, kinds.WHEEL)
UPDATES_A_ROW = 64
"""A part is factorised up to so many multiplications a row, and a few thousand more. What takes more costs ten times as
much as by sweeps; trusses and welded beams of two rows take fewer, however long they are."""
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
    have been asked for since the last change, with working places for so many `workers`. A metre is so many units of
    length.
    """

    workers: int = 1
    units_per_meter: float = 1.0
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
            self.tables = direct_tables(direct, self.workers, self.units_per_meter)
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


def part_layout(key: bytes) -> PartLayout:
    """The layout of a part of those joints: rows of `COLUMNS` 32-bit numbers."""
    joints = np.frombuffer(key, np.int32).reshape(-1, COLUMNS).astype(np.int64)
    slots, shares = _slots(joints)
    sides = joints[:, 4:8]
    weights = (slots >= 0).sum(axis=1) - shares
    anchored = bool((sides == WORLD).any())
    hung = anchored and bool(_keep_place(joints[:, 0], slots).all())
    found, bodies = _elimination(sides, weights)
    order = np.arange(len(joints)) if found is None else found.order
    of_joint = order[order < len(joints)]
    joints, slots, weights = _with_bodies(joints, slots, weights, bodies)
    seats, columns = np.nonzero(slots[order] >= 0)
    of_row = slots[order][seats, columns]
    if found is None:
        return PartLayout(of_joint, seats, of_row, anchored, hung, None)
    counts = (slots[order] >= 0).sum(axis=1)
    pattern = symbolic(found, np.cumsum(counts) - counts, weights[order], len(of_row))
    bounded = _may_be_bounded(joints[order, 0][seats], of_row)
    rows = JointRows(joints[order][:, [0, 2, 3, 8, 9]], joints[order, 4:8], seats, of_row)
    return PartLayout(of_joint, seats, of_row, anchored, hung, direct_layout(rows, pattern, bool(bounded.any())))


def _elimination(sides: Integers, weights: Integers) -> tuple[Elimination | None, Integers]:
    """How a part is factorised, if at all, and the bodies that stay in its system for that."""
    found = minimum_degree(sides, weights, UPDATES_A_ROW)
    if found is not None:
        return found, np.zeros(0, np.int64)
    return augment(sides, weights, UPDATES_A_ROW) or (None, np.zeros(0, np.int64))


def _with_bodies(
    joints: Integers, slots: Integers, weights: Integers, bodies: Integers
) -> tuple[Integers, Integers, Integers]:
    """The joints, their rows and how many columns they have, and behind them the same of bodies."""
    more, rows = np.zeros((len(bodies), COLUMNS), np.int64), np.full((len(bodies), slots.shape[1]), -1)
    more[:, 0], more[:, 4], more[:, 5:8] = BODY, bodies, NOBODY
    rows[:, :ROWS_OF_BODY] = np.arange(ROWS_OF_BODY)
    counts = np.full(len(bodies), ROWS_OF_BODY)
    return np.vstack([joints, more]), np.vstack([slots, rows]), np.append(weights, counts)


def _slots(joints: Integers) -> tuple[Integers, NDArray[np.bool_]]:
    """The rows that each joint needs, then -1; and whether two of them share an equation."""
    kind, spring, limit, motor = joints[:, :4].T
    code = 8 * kind + 4 * (spring != 0) + 2 * (limit != 0) + (motor != 0)
    counts = np.bincount(code)
    table, shares = np.full((len(counts), 5), -1), np.zeros(len(counts), np.bool_)
    for each in np.flatnonzero(counts).tolist():
        slots = slots_of(each // 8, bool(each & 4), bool(each & 2), bool(each & 1))
        table[each, : len(slots)] = slots
        shares[each] = shares_equation(slots)
    return table[code], shares[code]


def _keep_place(kind: Integers, slots: Integers) -> NDArray[np.bool_]:
    """Whether joints keep a point or a length, whatever pulls at them."""
    keeps: NDArray[np.bool_] = np.isin(kind, (kinds.REVOLUTE, kinds.WELD, kinds.DISTANCE)) & (slots == 0).any(axis=1)
    return keeps


def _may_be_bounded(kind: Integers, slot: Integers) -> NDArray[np.bool_]:
    brake = (kind == kinds.WHEEL) & (slot == 2)
    bounded: NDArray[np.bool_] = (slot == 4) | brake | np.isin(kind, (kinds.MOTOR, kinds.TARGET, kinds.FRICTION))
    return bounded
