"""The tables of the joint solver, put together from the layouts of the parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.hinge_lanes import lay_hinges
from sandbox.engine.joints.part_layout import COLUMNS, NOBODY, WORLD, PartLayout, PartLayouts
from sandbox.engine.joints.records import CONSTRAINT, LINK, MEMBER, PART, ROW, JointWork
from sandbox.tables import Integers, Records


@dataclass(frozen=True)
class Parts:
    """The joints that hold, part after part up to `ends`: rows of the joint table, the bodies on their four sides (-1
    the world, -2 nobody), and which of these they move."""

    joints: Integers
    sides: Integers
    moves: NDArray[np.bool_]
    ends: Integers

    @property
    def counts(self) -> Integers:
        """How many joints each part has."""
        return np.diff(self.ends, prepend=0)


@dataclass(frozen=True)
class _Offsets:
    """Where the members, rows, links, entries and targets of each part begin, and where those of the last one end."""

    members: Integers
    rows: Integers
    links: Integers
    entries: Integers
    targets: Integers


def joint_work(
    joints: Records, parts: Parts, ties: Records, bodies: int, layouts: PartLayouts, others: bool = False
) -> JointWork:
    """Everything, part after part. `ties` are all pairs of bodies with a joint; whether there are `others` besides."""
    members, seats = _members(parts, bodies)
    moving = np.bincount(members.part[members.part >= 0], minlength=len(parts.ends))
    first_member = int((members.part < 0).sum()) + np.cumsum(moving) - moving
    own = np.where(parts.moves, seats - np.repeat(first_member, parts.counts)[:, None], WORLD)
    own[parts.sides == NOBODY] = NOBODY
    found = layouts.of_parts(_content(joints, parts, own), parts.ends, others)
    offsets = _Offsets(
        np.append(first_member, len(members)),
        *(_starts([getattr(each, name) for each in found]) for name in ("slots", "links", "row_of", "targets")),
    )
    constraints = _constraints(joints, parts, seats, found)
    part_of = np.full(bodies, -1, np.int64)
    part_of[members.body[1:]] = members.part[1:]
    starts = np.append(_all([each.starts for each in found], offsets.entries), offsets.entries[-1])
    row_of = _all([each.row_of for each in found], offsets.rows)
    targets = _all([each.targets for each in found], offsets.entries)
    rows, links, table = _rows(constraints, parts, seats, found), _links(found, offsets), _parts(parts, found, offsets)
    hinges = lay_hinges(joints, members, constraints, table)
    return JointWork(
        joints, ties, part_of, members, constraints, rows, table, links, starts, row_of, targets,
        np.zeros(len(row_of)), hinges,
    )  # fmt: skip


def _starts(columns: Sequence[Integers]) -> Integers:
    """Where each of some columns begins when all are joined, and where the last one ends."""
    return np.cumsum([0, *map(len, columns)])


def _all(columns: Sequence[Integers], offsets: Integers) -> Integers:
    """All columns in one, each with its offset added."""
    joined: Integers = np.concatenate(columns)
    return joined + np.repeat(offsets[: len(columns)], [len(each) for each in columns])


def _members(parts: Parts, bodies: int) -> tuple[Records, Integers]:
    """The world, the bodies that joints cannot move, and those of each part, as they are first met; and the member on
    each side of each joint."""
    order = np.argsort(parts.joints)
    fixed = (parts.sides > WORLD) & ~parts.moves
    still = _as_met(parts.sides[order][fixed[order]])
    moved = _as_met(parts.sides[parts.moves])
    members = MEMBER.zeros(1 + len(still) + len(moved))
    members.body = np.concatenate([[-1], still, moved])
    members.cos = 1.0
    number = np.zeros(bodies + 2, np.int64)
    number[members.body[1:]] = np.arange(1, len(members))
    seats = number[parts.sides]
    part = np.full(len(members), -1)
    for side, moves in zip(seats.T, parts.moves.T, strict=True):
        part[side[moves]] = np.repeat(np.arange(len(parts.ends)), parts.counts)[moves]
    members.part = part
    return members, seats


def _as_met(bodies: Integers) -> Integers:
    """Each body once, in the order in which they are first met."""
    _, first = np.unique(bodies, return_index=True)
    met: Integers = bodies[np.sort(first)]
    return met


def _content(joints: Records, parts: Parts, own: Integers) -> NDArray[np.int32]:
    """What the layouts of parts depend on."""
    content = np.zeros((len(own), COLUMNS), np.int32)
    for k, name in enumerate(("kind", "spring", "limit", "motor")):
        values = joints[name][parts.joints]
        content[:, k] = values if name == "kind" else values != 0
    content[:, 4:] = own
    return content


def _constraints(joints: Records, parts: Parts, seats: Integers, found: Sequence[PartLayout]) -> Records:
    """The joints as they are eliminated."""
    places = _all([each.order for each in found], parts.ends - parts.counts)
    table = CONSTRAINT.zeros(len(places))
    table.joint, table.part = parts.joints[places], np.repeat(np.arange(len(found)), parts.counts)
    table.member_a, table.member_b = seats[places, 0], seats[places, 1]
    constraint_of = np.full(len(joints) + 1, -1)  # none has the last row
    constraint_of[table.joint] = np.arange(len(places))
    table.constraint_1 = constraint_of[joints.joint_1[table.joint]]
    table.constraint_2 = constraint_of[joints.joint_2[table.joint]]
    of_row = _all([each.constraints for each in found], parts.ends - parts.counts)
    table.row_count = np.bincount(of_row, minlength=len(table))
    table.first_row = np.cumsum(table.row_count) - table.row_count
    return table


def _rows(constraints: Records, parts: Parts, seats: Integers, found: Sequence[PartLayout]) -> Records:
    table = ROW.zeros(int(constraints.row_count.sum()))
    table.constraint = np.repeat(np.arange(len(constraints)), constraints.row_count)
    table.slot = np.concatenate([each.slots for each in found])
    place_of = np.zeros(int(parts.joints.max()) + 1, np.int64)
    place_of[parts.joints] = np.arange(len(parts.joints))
    places = place_of[constraints.joint[table.constraint]]
    given = parts.sides[places] != NOBODY
    table.sides = given.sum(axis=1)
    for k in range(4):
        table[f"member_{k + 1}"] = np.where(given[:, k], seats[places, k], 0)
    return table


def _links(found: Sequence[PartLayout], offsets: _Offsets) -> Records:
    columns: Any = np.concatenate([each.links for each in found]).T
    counts = np.diff(offsets.links)
    first_row, first_entry = np.repeat(offsets.rows[:-1], counts), np.repeat(offsets.entries[:-1], counts)
    table = LINK.zeros(columns.shape[1])
    table.row, table.other = columns[0] + first_row, columns[1] + first_row
    table.side, table.other_side, table.entry = columns[2], columns[3], columns[4] + first_entry
    return table


def _parts(parts: Parts, found: Sequence[PartLayout], offsets: _Offsets) -> Records:
    table = PART.zeros(len(found))
    table.first_constraint, table.constraint_end = parts.ends - parts.counts, parts.ends
    table.first_member, table.member_end = offsets.members[:-1], offsets.members[1:]
    table.first_row, table.row_end = offsets.rows[:-1], offsets.rows[1:]
    table.first_link, table.link_end = offsets.links[:-1], offsets.links[1:]
    table.first_target = offsets.targets[:-1]
    for name in ("direct", "anchored", "bounded"):
        table[name] = [getattr(each, name) for each in found]
    return table
