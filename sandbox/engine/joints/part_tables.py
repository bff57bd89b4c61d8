"""The tables of the joint solver, put together from the layouts of the parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.direct.tables import direct_tables, with_room
from sandbox.engine.joints.elimination import NOBODY, WORLD
from sandbox.engine.joints.net_lanes import NET_BLOCK, NET_JOINT, NetLanes, lay_lanes
from sandbox.engine.joints.part_layout import COLUMNS, PartLayout, PartLayouts
from sandbox.engine.joints.records import BOND, CONSTRAINT, MEMBER, PART, ROW, JointWork
from sandbox.tables import Integers, Records
from sandbox.world.joint_records import GEAR, JOINT


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
    places = _all([each.order for each in found], parts.ends - parts.counts)
    fixed = (parts.sides > NOBODY) & ~parts.moves
    tables, of_part = layouts.factorised(len(layouts.parts) - len(found))
    direct = with_room(tables._replace(fixed=parts.sides[places][fixed[places]]), of_part)
    constraints = _constraints(joints, parts, seats, places)
    part_of = np.full(bodies, -1, np.int64)
    part_of[members.body[1:]] = members.part[1:]
    table = _parts(parts, found, np.append(first_member, len(members)), of_part)
    before = np.cumsum(np.append(0, fixed[places].sum(axis=1)))
    table.first_fixed = before[parts.ends - parts.counts]
    rows = _rows(constraints, parts, seats, found, table)
    hinges = lay_lanes(joints, members, constraints, table)
    return JointWork(joints, ties, part_of, members, constraints, rows, table, hinges, direct)


@cache
def no_joints() -> JointWork:
    """What kernels are given where no joint holds: tables without rows, which nothing is ever written to."""
    nothing = np.zeros(0, np.int64)
    lanes = NetLanes(NET_JOINT.zeros(0), NET_BLOCK.zeros(0), np.zeros(0))
    direct = with_room(direct_tables(()), nothing)
    tables = (MEMBER.zeros(0), CONSTRAINT.zeros(0), ROW.zeros(0), PART.zeros(0))
    return JointWork(JOINT.zeros(0), BOND.zeros(0), nothing, *tables, lanes, direct)


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
    members.start_cos = members.cos = 1.0  # of the world; others follow in each step
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
    content = np.full((len(own), COLUMNS), -1, np.int32)
    for k, name in enumerate(("kind", "spring", "limit", "motor")):
        values = joints[name][parts.joints]
        content[:, k] = values if name == "kind" else values != 0
    content[:, 4:8] = own
    gears = np.flatnonzero(content[:, 0] == GEAR)
    for k, coupled in ((8, joints.joint_1), (9, joints.joint_2)):
        content[gears, k] = joints.kind[coupled[parts.joints[gears]]]
    return content


def _constraints(joints: Records, parts: Parts, seats: Integers, places: Integers) -> Records:
    """The joints as they are eliminated."""
    table = CONSTRAINT.zeros(len(places))
    table.joint, table.part = parts.joints[places], np.repeat(np.arange(len(parts.ends)), parts.counts)
    table.member_a, table.member_b = seats[places, 0], seats[places, 1]
    constraint_of = np.full(len(joints) + 1, -1)  # none has the last row
    constraint_of[table.joint] = np.arange(len(places))
    table.constraint_1 = constraint_of[joints.joint_1[table.joint]]
    table.constraint_2 = constraint_of[joints.joint_2[table.joint]]
    return table


def _rows(constraints: Records, parts: Parts, seats: Integers, found: Sequence[PartLayout], table: Records) -> Records:
    """The rows of parts that are not factorised; notes in these and in their constraints where they are."""
    swept = [each for each in found if each.direct is None]
    counts = np.array([len(each.slots) if each.direct is None else 0 for each in found])
    table.row_end = np.cumsum(counts)
    table.first_row = table.row_end - counts
    if not swept:
        return ROW.zeros(0)
    first = (parts.ends - parts.counts)[table.direct == 0]
    of_row = _all([each.constraints for each in swept], first)
    constraints.row_count = np.bincount(of_row, minlength=len(constraints))
    constraints.first_row = np.cumsum(constraints.row_count) - constraints.row_count
    rows = ROW.zeros(len(of_row))
    rows.constraint = of_row
    rows.slot = np.concatenate([each.slots for each in swept])
    place_of = np.zeros(int(parts.joints.max()) + 1, np.int64)
    place_of[parts.joints] = np.arange(len(parts.joints))
    places = place_of[constraints.joint[of_row]]
    given = parts.sides != NOBODY
    rows.sides = given.sum(axis=1)[places]
    members = np.where(given, seats, 0)
    for k in range(4):
        rows[f"member_{k + 1}"] = members[places, k]
    return rows


def _parts(parts: Parts, found: Sequence[PartLayout], members: Integers, layouts: Integers) -> Records:
    table = PART.zeros(len(found))
    table.first_constraint, table.constraint_end = parts.ends - parts.counts, parts.ends
    table.first_member, table.member_end = members[:-1], members[1:]
    table.direct, table.layout = layouts >= 0, layouts
    table.anchored = [each.anchored for each in found]
    table.hung = [each.hung for each in found]
    return table
