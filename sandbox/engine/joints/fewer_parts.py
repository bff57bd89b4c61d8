"""Bodies move to other rows, and parts go as a whole: all that points at them follows, as if all were assembled anew.

But for one thing: members that joints cannot move keep their order, whichever joint now is the first to hold them. No
kernel asks for that order.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.direct.tables import with_room
from sandbox.engine.joints.more_parts import ENDS, MEMBERS
from sandbox.engine.joints.net_lanes import NetLanes, lanes_for
from sandbox.engine.joints.pair_filter import NO_BOND, JointFilter, note_first
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Integers, Records, plain, without
from sandbox.world.new_rows import NewRows
from sandbox.world.rows import Moved

Flags = NDArray[np.bool_]


def going_parts(work: JointWork, joints: NewRows) -> Flags | None:
    """Which parts go as joints do, whose new rows are `joints`; None if some part loses only some of its joints."""
    constraints = plain(work.constraints)
    lost = np.bincount(constraints["part"][joints[constraints["joint"]] < 0], minlength=len(work.parts))
    parts = plain(work.parts)
    whole: Flags = lost == parts["constraint_end"] - parts["first_constraint"]
    return None if (lost[~whole] > 0).any() else whole


def without_parts(
    joint_filter: JointFilter, work: JointWork, layouts: PartLayouts, going: Flags, moved: Moved, joints: Records
) -> tuple[JointFilter, JointWork]:
    """What is left after whole parts are gone; `moved` tells where rows are now, `joints` is the table of now."""
    bonds, ties = (_kept_bonds(rows, work.part_of, going, moved.bodies) for rows in (joint_filter.bonds, work.ties))
    if going.any():
        layouts.drop(going)
        work = _without(work, layouts, _Places(work, going))
    for table in (work.constraints, work.side_by_side.joints):
        plain(table)["joint"] = moved.joints[plain(table)["joint"]]
    members = plain(work.members)[1:]
    members["body"] = moved.bodies[members["body"]]
    fixed = work.direct.fixed
    fixed[fixed >= 0] = moved.bodies[fixed[fixed >= 0]]
    part_of, first = np.full(len(work.part_of), -1), np.full(len(joint_filter.first), NO_BOND)
    part_of[members["body"]] = members["part"]
    return note_first(JointFilter(bonds, first)), work._replace(joints=joints, ties=ties, part_of=part_of)


def _without(work: JointWork, layouts: PartLayouts, places: _Places) -> JointWork:
    parts, (tables, of_part) = _kept_parts(work, places), layouts.factorised(0)
    plain(parts)["layout"] = of_part
    return work._replace(
        parts=parts,
        members=_kept(work.members, "members", places, {"parts": ("part",)}),
        constraints=_kept_constraints(work, places),
        rows=_kept(work.rows, "rows", places, {"constraints": ("constraint",), "members": MEMBERS}),
        side_by_side=_kept_lanes(work, places),
        direct=with_room(tables._replace(fixed=work.direct.fixed[places.left["fixed"]]), of_part, work.direct),
    )


class _Places:
    """What is left of each table, and how many rows before each are."""

    def __init__(self, work: JointWork, going: Flags) -> None:
        constraint_part, row_constraint = plain(work.constraints)["part"], plain(work.rows)["constraint"]
        parts, joints = ~going, plain(work.side_by_side.joints)
        constraints = parts[constraint_part]
        rows = constraints[row_constraint]
        lane_parts = np.maximum(*(plain(work.members)["part"][joints[name]] for name in ("member_a", "member_b")))
        table = plain(work.parts)
        fixed = np.diff(np.append(table["first_fixed"], len(work.direct.fixed)))
        self.left: dict[str, Flags] = {
            "parts": parts,
            "constraints": constraints,
            "rows": rows,
            "members": self._members(work, constraints),
            "lane_joints": parts[lane_parts],
            "blocks": np.repeat(parts, table["block_end"] - table["first_block"]),
            "fixed": np.repeat(parts, fixed),
        }
        self._before = {name: np.append(0, np.cumsum(left)) for name, left in self.left.items()}

    @staticmethod
    def _members(work: JointWork, constraints: Flags) -> Flags:
        """The world, and whoever a joint holds that is left; a gear holds no other than the joints that it couples."""
        held = np.zeros(len(work.members), np.bool_)
        held[0] = True
        for name in ("member_a", "member_b"):
            held[plain(work.constraints)[name][constraints]] = True
        return held

    def of(self, table: str, rows: Integers) -> Integers:
        """The new rows of some that are left, or where runs of them begin and end; -1 stays -1."""
        return np.where(rows >= 0, self._before[table][rows], rows)


def _kept_bonds(bonds: Records, part_of: Integers, going: Flags, bodies: NewRows) -> Records:
    low, high = plain(bonds)["low"], plain(bonds)["high"]
    gone = np.append(going, False)  # -1, no part, is the last one
    bonds = without(bonds, ~(gone[part_of[low]] | gone[part_of[high]]))
    for name in ("low", "high"):
        plain(bonds)[name] = bodies[plain(bonds)[name]]
    return bonds


def _kept(table: Records, name: str, places: _Places, columns: Mapping[str, tuple[str, ...]]) -> Records:
    """What is left of a table; `columns` are those that point at rows of others."""
    rows = without(table, places.left[name])
    for other, names in columns.items():
        for column in names:
            plain(rows)[column] = places.of(other, plain(rows)[column])
    return rows


def _kept_parts(work: JointWork, places: _Places) -> Records:
    tables = ("constraints", "members", "rows", "blocks", "fixed")
    return _kept(work.parts, "parts", places, dict(zip(tables, ENDS, strict=True)))


def _kept_constraints(work: JointWork, places: _Places) -> Records:
    columns: dict[str, tuple[str, ...]] = {
        "parts": ("part",), "members": ("member_a", "member_b"), "constraints": ("constraint_1", "constraint_2"),
        "rows": ("first_row",),
    }  # fmt: skip
    return _kept(work.constraints, "constraints", places, columns)


def _kept_lanes(work: JointWork, places: _Places) -> NetLanes:
    lanes = work.side_by_side
    if len(lanes.joints) == 0:
        return lanes
    joints = _kept(lanes.joints, "lane_joints", places, {"members": ("member_a", "member_b")})
    blocks = _kept(lanes.blocks, "blocks", places, {"lane_joints": ("first",)})
    return NetLanes(joints, blocks, lanes_for(blocks))
