"""Parts that come: their tables are put behind those of the others, as if everything had been assembled anew."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.joints.direct.tables import with_room
from sandbox.engine.joints.net_lanes import NetLanes, lanes_for
from sandbox.engine.joints.pair_filter import JointFilter, note_first
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Integers, Records, extended, longer, plain

ENDS = (
    ("first_constraint", "constraint_end"), ("first_member", "member_end"), ("first_row", "row_end"),
    ("first_block", "block_end"), ("first_fixed",),
)  # fmt: skip
"""Columns of the part table: where a part's constraints, members, rows and blocks of lanes begin and end, and where
its bodies on fixed sides begin."""
MEMBERS = ("member_1", "member_2", "member_3", "member_4")
"""Columns of the row table that name members."""


def with_more_parts(work: JointWork, more: JointWork, joints: Records) -> JointWork:
    """`work` with the parts of `more` behind its own. They hold none of its bodies, and their joints come later.

    `joints` is the table that has the joints of both. All members of `more` are moved by its joints, and its layouts
    are those of both.
    """
    members, constraints, rows = len(work.members) - 1, len(work.constraints), len(work.rows)
    shifts: dict[str, dict[str, int]] = {
        "members": {"part": len(work.parts)},
        "constraints": {"part": len(work.parts), "member_a": members, "member_b": members, "first_row": rows}
        | {"constraint_1": constraints, "constraint_2": constraints},
        "rows": {"constraint": constraints} | dict.fromkeys(MEMBERS, members),
    }
    tables: dict[str, Any] = {"joints": joints, "ties": with_more_bonds(work.ties, more.ties)}
    for name, columns in shifts.items():
        fresh = plain(getattr(more, name))
        for column, shift in columns.items():
            fresh[column] = _shifted(fresh[column], shift, column.startswith("member"))
        tables[name] = extended(getattr(work, name), fresh[1:] if name == "members" else fresh)
    counts = (constraints, members, rows, len(work.side_by_side.blocks), len(work.direct.fixed))
    fresh = plain(more.parts)
    for ends, count in zip(ENDS, counts, strict=True):
        for column in ends:
            fresh[column] += count
    tables["parts"] = extended(work.parts, fresh)
    bodies = plain(more.members)["body"][1:]
    work.part_of[bodies] = plain(more.members)["part"][1:]
    return work._replace(
        **tables,
        side_by_side=_with_more_lanes(work.side_by_side, more.side_by_side, members),
        direct=with_room(
            more.direct._replace(fixed=longer(work.direct.fixed, more.direct.fixed)),
            plain(tables["parts"])["layout"],
            work.direct,
        ),
    )


def with_more_pairs(joint_filter: JointFilter, more: Records) -> JointFilter:
    """The pairs that are kept from colliding and others that come, of bodies that had none."""
    if not len(more):
        return joint_filter
    known = joint_filter.bonds
    start = int(np.searchsorted(plain(known)["low"], plain(more)["low"][0]))
    return note_first(JointFilter(with_more_bonds(known, more), joint_filter.first), start)


def with_more_bonds(bonds: Records, more: Records) -> Records:
    """Bonds and others that come, sorted by (low, high) as both are."""
    last, bonds = len(bonds) - 1, extended(bonds, plain(more))
    rows = plain(bonds)
    if last >= 0 and len(more) and rows["low"][last] >= rows["low"][last + 1]:
        rows[:] = rows[np.lexsort((rows["high"], rows["low"]))]
    return bonds


def _shifted(values: Integers, shift: int, are_members: bool) -> Integers:
    """-1 is nothing, and member 0 the world."""
    return np.where(values >= (1 if are_members else 0), values + shift, values)


def _with_more_lanes(lanes: NetLanes, more: NetLanes, members: int) -> NetLanes:
    if len(more.joints) == 0:
        return lanes
    joints, blocks = plain(more.joints), plain(more.blocks)
    for column in ("member_a", "member_b"):
        joints[column] = _shifted(joints[column], members, True)
    blocks["first"] += len(lanes.joints)
    found = extended(lanes.blocks, blocks)
    return NetLanes(extended(lanes.joints, joints), found, lanes_for(found))
