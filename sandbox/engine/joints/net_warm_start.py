"""Warm starting of nets: what their joints gave in the substep before is applied, but at what then spins.

An impulse points elsewhere after a member has turned, and so adds energy. That is asked when all have been applied:
what a single joint gives turns a light body under a heavy load faster than anything spins, until the next joint's takes
it back.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.hinges import scale_hinge
from sandbox.engine.joints.jacobian import push_row
from sandbox.engine.joints.net_sweeps import warm_start_lanes
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.rods import scale_rod
from sandbox.engine.joints.welds import scale_weld
from sandbox.engine.records.workers import Workers
from sandbox.tables import Records

FAR = 0.5
"""Turn of a member (rad) within a substep after which an impulse of the substep before points elsewhere."""


@kernel
def warm_start_net(work: JointWork, motions: Records, part: Records, seconds: float, workers: Workers) -> None:
    """Apply the impulses of the substep before, but at members that they leave turning by more than `FAR` in this one,
    which takes so many seconds."""
    _apply(work, motions, part, workers)
    if _mark_spinning(work, motions, part, FAR / seconds):
        _scale_impulses(work, part, -1.0, False)
        _apply(work, motions, part, workers)
        _scale_impulses(work, part, -1.0, False)
        _scale_impulses(work, part, 0.0, True)
        _apply(work, motions, part, workers)


@kernel
def _apply(work: JointWork, motions: Records, part: Records, workers: Workers) -> None:
    for r in range(part.first_row, part.row_end if part.swept == 1 else part.first_row):
        row = work.rows[r]
        if row.stiffness == 0.0:
            row.impulse = 0.0
        row.stop = 1 if row.impulse > 0.0 else (-1 if row.impulse < 0.0 else 0)
        if row.impulse != 0.0:
            push_row(work.members, motions, row, row.impulse)
    warm_start_lanes(work, motions, part, workers)


@kernel
def _mark_spinning(work: JointWork, motions: Records, part: Records, fastest: float) -> bool:
    """Note which members turn faster than `fastest` (rad/s); whether there are any."""
    found = False
    for m in range(part.first_member, part.member_end):
        member = work.members[m]
        member.spins = 1 if abs(motions[member.body].angular_velocity) > fastest else 0
        found = found or member.spins == 1
    return found


@kernel
def _scale_impulses(work: JointWork, part: Records, share: float, at_spinning: bool) -> None:
    """Multiply the impulses of all joints of a part, or of those at members that spin."""
    for r in range(part.first_row, part.row_end if part.swept == 1 else part.first_row):
        row = work.rows[r]
        if not at_spinning or work.members[row.member_1].spins + work.members[row.member_2].spins > 0:
            row.impulse *= share
    h = work.side_by_side
    for n in range(part.first_block, part.block_end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        for k in range(block.count):
            each = h.joints[block.first + k]
            if not at_spinning or work.members[each.member_a].spins + work.members[each.member_b].spins > 0:
                if block.kind == nl.RODS:
                    scale_rod(v, k, share)
                elif block.kind == nl.WELDS:
                    scale_weld(v, k, share)
                else:
                    scale_hinge(v, k, share)
