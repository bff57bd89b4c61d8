"""The tables of one layout: who sits where in the memory of a batch, and in which order a factor is worked out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count, pairwise

import numpy as np

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import (
    ALONG_X,
    ALONG_Y,
    ANY_AXIS,
    ANY_PRODUCT,
    ENTRY,
    EQUATION,
    FRAME,
    LAYOUT,
    PRODUCT,
    TURN,
)
from sandbox.engine.joints.symbolic import Pattern
from sandbox.tables import Integers32, Records
from sandbox.world.joint_records import (
    DISTANCE,
    FRICTION,
    GEAR,
    MOTOR,
    PRISMATIC,
    PULLEY,
    REVOLUTE,
    TARGET,
    WELD,
    WHEEL,
)

_WEAK = (MOTOR, TARGET, FRICTION)
"""Kinds of which two rows may have a limit together."""
SPRUNG_OR_WEAK = (WELD, *_WEAK)
"""Kinds of which also the rows that keep a place may be springs, or have a limit."""
_SLIDES = (PRISMATIC, WHEEL)
Joint = tuple[int, bool, bool, int, int]
"""Kind, whether it has limits and a motor, and for gears the kinds of the joints it couples."""
Link = tuple[int, int, int, int, int]
"""Two rows that have a body in common, on which of their sides it is, from 1, and the entry of the pair."""


@dataclass(frozen=True)
class DirectLayout:
    """Its tables, all of whose numbers count from its own first seat, frame, equation, entry, product and target."""

    layout: Records
    frames: Records
    equations: Records
    entries: Records
    products: Records
    targets: Integers32


def direct_layout(
    joints: Sequence[Joint],
    sides: Sequence[Sequence[int]],
    rows: Sequence[tuple[int, int]],
    links: Sequence[Link],
    pattern: Pattern,
    bounded: bool,
) -> DirectLayout:
    """The tables of the joints of a part in the order of elimination.

    `sides` are their bodies, less than zero where these are fixed; `rows` (joint, slot) each.
    """
    moving = max((body for each in sides for body in each), default=-1) + 1
    taken = count(moving)
    seats = [[body if body >= 0 else next(taken) for body in each] for each in sides]
    frames = _frames(joints, seats, rows)
    equations = _equations(joints, seats, rows, pattern)
    entries, products = _entries(joints, seats, rows, links, pattern)
    layout = LAYOUT.zeros(1)
    layout.seats, layout.moving = next(taken), moving
    layout.frame_end, layout.row_end, layout.joints = len(frames), len(equations), len(joints)
    layout.bounded = bounded
    layout.hinged = not bounded and all(kind in (REVOLUTE, WELD) for kind, *_ in joints)
    layout.staggers = not any(kind in _WEAK or limit for kind, limit, *_ in joints)
    return DirectLayout(layout, frames, equations, entries, products, np.array(pattern.targets, np.int32) * WIDTH)


def _frames(joints: Sequence[Joint], seats: Sequence[Sequence[int]], rows: Sequence[tuple[int, int]]) -> Records:
    """After a gear come the two joints that it couples, which have no rows here."""
    ends = np.cumsum(np.bincount([j for j, _ in rows], minlength=len(joints))).tolist()
    found: list[tuple[int, ...]] = []
    for j, (kind, limit, motor, kind_1, kind_2) in enumerate(joints):
        each, first, end = seats[j], ends[j - 1] if j else 0, ends[j]
        place = len(found)
        coupled = (place + 1, place + 2) if len(each) == 4 else (place, place)
        found.append((kind, *each[:2], j, 0, *coupled, kind_1, kind_2, limit, motor, first, end))
        if len(each) == 4:
            found.append((kind_1, *each[:2], j, 1, *coupled, 0, 0, 0, 0, end, end))
            found.append((kind_2, *each[2:], j, 2, *coupled, 0, 0, 0, 0, end, end))
    kind, slot_a, slot_b, joint, which, one, two, kind_1, kind_2, limit, motor, first, end = np.array(found).T
    table = FRAME.zeros(len(found))
    table.kind, table.joint, table.coupled, table.limit, table.motor = kind, joint, which, limit, motor
    table.slot_a, table.slot_b = slot_a, slot_b
    table.seat_a, table.seat_b = slot_a * at.SEAT_SIZE, slot_b * at.SEAT_SIZE
    table.place, table.constants = np.arange(len(found)) * at.FRAME_SIZE, np.arange(len(found)) * at.JOINT_SIZE
    table.coordinate_1, table.coordinate_2 = one * at.FRAME_SIZE, two * at.FRAME_SIZE
    table.kind_1, table.kind_2 = kind_1, kind_2
    table.first_row, table.row_end = first, end
    return table


def _equations(
    joints: Sequence[Joint], seats: Sequence[Sequence[int]], rows: Sequence[tuple[int, int]], pattern: Pattern
) -> Records:
    table = EQUATION.zeros(len(rows))
    table.bounded = [slot >= 2 or joints[j][0] in SPRUNG_OR_WEAK for j, slot in rows]
    table.slot = [slot for _, slot in rows]
    table.sides = [len(seats[j]) for j, _ in rows]
    table.axis = [_axis(joints[j][0], slot) for j, slot in rows]
    for k in range(4):
        table[f"seat_{k + 1}"] = [seats[j][k] * at.SEAT_SIZE if k < len(seats[j]) else 0 for j, _ in rows]
    table.place, table.kept = np.arange(len(rows)) * at.ROW_SIZE, np.arange(len(rows)) * at.KEPT_SIZE
    follows = [slot == 4 and (joint, 3) == before for before, (joint, slot) in pairwise([(-1, 0), *rows])]
    own = np.flatnonzero(~np.array(follows, bool))
    ends = np.array([*pattern.starts, len(pattern.row_of)], np.int64)
    table.first_entry[own], table.entry_end[own] = ends[:-1], ends[1:]
    below = np.diff(ends) - 1
    updates = below * (below + 1) // 2
    table.first_target[own] = np.cumsum(updates) - updates
    table.paired[own] = _pairs([rows[r][0] for r in own.tolist()])
    table.shares = [*follows[1:], False]
    return table


def _pairs(joints: Sequence[int]) -> list[bool]:
    """Of rows of these joints, which begin a pair: every other row of a joint that is not its last."""
    found: list[bool] = []
    for joint, after in zip(joints, [*joints[1:], -1], strict=False):
        found.append(joint == after and not (found and found[-1]))
    return found


def _axis(kind: int, slot: int) -> int:
    """What is known of the Jacobian of a row before anything has moved."""
    if kind in (DISTANCE, PULLEY, GEAR) or (kind in _SLIDES and slot not in (1, 2)):
        return ANY_AXIS
    if kind in _SLIDES or slot >= 2:
        return TURN
    return ALONG_X if slot == 0 else ALONG_Y


def _linear(axis: int, side: int, other_axis: int, other_side: int) -> int:
    """The product of what two rows do to the velocity of a body, on those of their sides."""
    if TURN in (axis, other_axis):
        return 0
    if ANY_AXIS in (axis, other_axis):
        return ANY_PRODUCT
    if axis != other_axis:
        return 0
    return 1 if side == other_side else -1


def _entries(
    joints: Sequence[Joint],
    seats: Sequence[Sequence[int]],
    rows: Sequence[tuple[int, int]],
    links: Sequence[Link],
    pattern: Pattern,
) -> tuple[Records, Records]:
    """The entries of the factor and what is added up in each."""
    row, other, side, other_side, place = np.array(links, np.int64).reshape(-1, 5).T
    order = np.argsort(place, kind="stable")
    entries, products = ENTRY.zeros(len(pattern.row_of)), PRODUCT.zeros(len(links))
    products.one = (row * at.ROW_SIZE + at.JACOBIAN + (side - 1) * at.SIDE)[order]
    products.other = (other * at.ROW_SIZE + at.JACOBIAN + (other_side - 1) * at.SIDE)[order]
    axes = [_axis(joints[j][0], slot) for j, slot in rows]
    products.linear = np.array([_linear(axes[r], s, axes[t], u) for r, t, s, u, _ in links], np.int64)[order]
    products.seat = np.array([seats[rows[r][0]][s - 1] * at.SEAT_SIZE for r, _, s, _, _ in links], np.int64)[order]
    entries.place = entries.total = np.arange(len(entries)) * WIDTH
    entries.other = np.array(pattern.row_of, np.int64) * at.ROW_SIZE
    counts = np.bincount(place, minlength=len(entries))
    entries.product_end = np.cumsum(counts)
    entries.first_product = entries.product_end - counts
    return entries, products
