"""The tables of one layout: who sits where in the memory of a batch, and in which order a factor is worked out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.body_rows import Terms, is_augmented, sides_without, terms_of_bodies
from sandbox.engine.joints.direct.records import (
    ALONG_X,
    ALONG_Y,
    ANY_AXIS,
    ANY_PRODUCT,
    BODY,
    ENTRY,
    EQUATION,
    FRAME,
    LAYOUT,
    OF_BODY,
    PRODUCT,
    TURN,
)
from sandbox.engine.joints.elimination import NOBODY, WORLD
from sandbox.engine.joints.symbolic import Pattern, runs
from sandbox.tables import Integers, Integers32, Records
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


class JointRows(NamedTuple):
    """The joints of a part in the order of elimination, bodies that stay in its system among them (`BODY`), and which
    joint and slot each row has.

    `joints` has their kind, whether they have limits and a motor, and for gears the kinds of the joints they couple;
    `sides` up to four bodies, `WORLD` where these are fixed, else `NOBODY`.
    """

    joints: Integers
    sides: Integers
    joint: Integers
    slot: Integers

    @property
    def kind(self) -> Integers:
        """The kind of each joint."""
        return self.joints[:, 0]

    @property
    def side_counts(self) -> Integers:
        """How many sides each joint has."""
        counts: Integers = (self.sides != NOBODY).sum(axis=1)
        return counts


@dataclass(frozen=True)
class DirectLayout:
    """Its tables, all of whose numbers count from its own first seat, frame, equation, entry, product and target."""

    layout: Records
    frames: Records
    equations: Records
    entries: Records
    products: Records
    targets: Integers32


def direct_layout(rows: JointRows, pattern: Pattern, bounded: bool) -> DirectLayout:
    """The tables of the joints of a part, whose factor has that pattern; `bounded` if some row may have bounds."""
    moving = int(rows.sides.max(initial=-1)) + 1
    seats, fixed = rows.sides.copy(), rows.sides == WORLD
    seats[fixed] = moving + np.arange(int(fixed.sum()))
    frames = _frames(rows, seats)
    equations = _equations(rows, seats, pattern)
    entries, products = _entries(rows, seats, pattern)
    layout = LAYOUT.zeros(1)
    layout.seats, layout.moving = moving + int(fixed.sum()), moving
    layout.frame_end, layout.row_end, layout.joints = len(frames), len(equations), int((rows.kind != BODY).sum())
    layout.bounded = bounded
    layout.hinged = not bounded and bool(np.isin(rows.kind, (REVOLUTE, WELD, BODY)).all())
    layout.staggers = not (np.isin(rows.kind, _WEAK) | (rows.joints[:, 1] != 0)).any()
    return DirectLayout(layout, frames, equations, entries, products, (pattern.targets * WIDTH).astype(np.int32))


def _frames(rows: JointRows, seats: Integers) -> Records:
    """After a gear come the two joints that it couples, which have no rows here. Bodies have no frame."""
    gear, body = rows.side_counts == 4, rows.kind == BODY
    counts = np.where(gear, 3, np.where(body, 0, 1))
    first = np.cumsum(counts) - counts
    joint = np.repeat(np.arange(len(counts)), counts)
    which = runs(np.zeros_like(counts), counts)
    own, second = which == 0, which == 2
    slot_a, slot_b = (np.where(second, seats[joint, k + 2], seats[joint, k]) for k in (0, 1))
    one, two = (first[joint] + np.where(gear[joint], k, 0) for k in (1, 2))
    ends = np.cumsum(np.bincount(rows.joint, minlength=len(counts)))
    kind, limit, motor, kind_1, kind_2 = rows.joints[joint].T
    table = FRAME.zeros(len(joint))
    table.kind = np.where(own, kind, np.where(second, kind_2, kind_1))
    table.joint, table.coupled = (np.cumsum(~body) - 1)[joint], which
    table.limit, table.motor = np.where(own, limit, 0), np.where(own, motor, 0)
    table.slot_a, table.slot_b = slot_a, slot_b
    table.seat_a, table.seat_b = slot_a * at.SEAT_SIZE, slot_b * at.SEAT_SIZE
    table.place, table.constants = np.arange(len(joint)) * at.FRAME_SIZE, np.arange(len(joint)) * at.JOINT_SIZE
    table.coordinate_1, table.coordinate_2 = one * at.FRAME_SIZE, two * at.FRAME_SIZE
    table.kind_1, table.kind_2 = np.where(own, kind_1, 0), np.where(own, kind_2, 0)
    table.row_end = ends[joint]
    table.first_row = np.where(own, np.append(0, ends)[joint], ends[joint])
    return table


def _equations(rows: JointRows, seats: Integers, pattern: Pattern) -> Records:
    table = EQUATION.zeros(len(rows.slot))
    kind = rows.kind[rows.joint]
    table.bounded = (kind != BODY) & ((rows.slot >= 2) | np.isin(kind, SPRUNG_OR_WEAK))
    table.slot = rows.slot
    table.sides = rows.side_counts[rows.joint]
    table.axis = _axes(rows)
    for k in range(4):
        seat = seats[rows.joint, k]
        table[f"seat_{k + 1}"] = np.where(seat >= 0, seat * at.SEAT_SIZE, 0)
    table.place, table.kept = np.arange(len(table)) * at.ROW_SIZE, np.arange(len(table)) * at.KEPT_SIZE
    follows = np.zeros(len(table) + 1, np.bool_)
    follows[1:-1] = (rows.slot[1:] == 4) & (rows.slot[:-1] == 3) & (rows.joint[1:] == rows.joint[:-1])
    own = np.flatnonzero(~follows[:-1])
    ends = np.append(pattern.starts, len(pattern.row_of))
    table.first_entry[own], table.entry_end[own] = ends[:-1], ends[1:]
    below = np.diff(ends) - 1
    updates = below * (below + 1) // 2
    table.first_target[own] = np.cumsum(updates) - updates
    table.paired[own] = _pairs(rows.joint[own])
    table.shares = follows[1:]
    table.augmented = np.where(kind == BODY, OF_BODY, is_augmented(rows.kind, rows.sides)[rows.joint])
    return table


def _pairs(joints: Integers) -> NDArray[np.bool_]:
    """Of rows of these joints, which begin a pair: every other row of a joint that is not its last."""
    begins = np.append(True, joints[1:] != joints[:-1])[: len(joints)]
    since = np.arange(len(joints)) - np.flatnonzero(begins)[np.cumsum(begins) - 1]
    pairs: NDArray[np.bool_] = (since % 2 == 0) & ~np.append(begins[1:], True)[: len(joints)]
    return pairs


def _axes(rows: JointRows) -> Integers:
    """What is known of the Jacobian of each row before anything has moved."""
    kind, slot = rows.kind[rows.joint], rows.slot
    slides = np.isin(kind, _SLIDES)
    any_axis = np.isin(kind, (BODY, DISTANCE, PULLEY, GEAR)) | (slides & (slot != 1) & (slot != 2))
    along: Integers = np.where(slot == 0, ALONG_X, ALONG_Y)
    return np.where(any_axis, ANY_AXIS, np.where(slides | (slot >= 2), TURN, along))


def _entries(rows: JointRows, seats: Integers, pattern: Pattern) -> tuple[Records, Records]:
    """The entries of the factor and what is added up in each: of each two rows what they have in common, at each body
    by which they do."""
    column, side, row, other_side = _links(rows, pattern)
    axes = _axes(rows)
    found = Terms(
        pattern.entries(column, row),
        row * at.ROW_SIZE + at.JACOBIAN + other_side * at.SIDE,
        column * at.ROW_SIZE + at.JACOBIAN + side * at.SIDE,
        _linear(axes[row], axes[column], side == other_side),
        seats[rows.joint[row], other_side],
    )
    of_bodies = terms_of_bodies(rows.kind, rows.sides, rows.joint, rows.slot, pattern)
    terms = Terms(*map(np.append, found, of_bodies))
    order = np.lexsort((terms.one, terms.other, terms.entry))  # within an entry by the sides of both rows
    entries, products = ENTRY.zeros(len(pattern.row_of)), PRODUCT.zeros(len(order))
    products.one, products.other, products.linear = terms.one[order], terms.other[order], terms.linear[order]
    products.seat = terms.seat[order] * at.SEAT_SIZE
    entries.place = entries.total = np.arange(len(entries)) * WIDTH
    entries.other = pattern.row_of * at.ROW_SIZE
    counts = np.bincount(terms.entry, minlength=len(entries))
    entries.product_end = np.cumsum(counts)
    entries.first_product = entries.product_end - counts
    return entries, products


def _links(rows: JointRows, pattern: Pattern) -> tuple[Integers, Integers, Integers, Integers]:
    """Columns and rows of the factor, with the sides, from 0, on which they have a body in common that joints move and
    that does not stay in the system."""
    sides = sides_without(rows.kind, rows.sides)
    own = np.zeros(pattern.rows, np.bool_)
    own[pattern.row_of] = True
    row = np.flatnonzero(own)
    at_row, side = np.nonzero(sides[rows.joint[row]] >= 0)
    row = row[at_row]
    body = sides[rows.joint[row], side]
    order = np.argsort(body, kind="stable")
    row, side = row[order], side[order]
    counts = np.bincount(body)
    first = np.cumsum(counts) - counts
    of_body = body[order]
    one = np.repeat(np.arange(len(row)), counts[of_body])
    other = runs(first[of_body], counts[of_body])
    one, other = one[row[other] >= row[one]], other[row[other] >= row[one]]
    return row[one], side[one], row[other], side[other]


def _linear(axis: Integers, other_axis: Integers, same_side: NDArray[np.bool_]) -> Integers:
    """The products of what two rows each do to the velocity of a body, on the same side of both or not."""
    turns = (axis == TURN) | (other_axis == TURN)
    is_any = (axis == ANY_AXIS) | (other_axis == ANY_AXIS)
    sign: Integers = np.where(same_side, 1, -1)
    return np.where(turns, 0, np.where(is_any, ANY_PRODUCT, np.where(axis == other_axis, sign, 0)))
