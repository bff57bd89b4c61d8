"""Sweeps over the joints of nets that are solved side by side: colour after colour, four joints of a kind at once."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import absolute
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.direct.reports import finish_report
from sandbox.engine.joints.hinges import accumulate_hinge_block, load_hinge, report_hinge, swept_hinges, warm_hinges
from sandbox.engine.joints.net_blocks import SoftJoint, gather_block, scatter_block
from sandbox.engine.joints.net_lanes import NetLanes
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.rods import accumulate_rod_block, load_rod, report_rod, swept_rods, warm_rods
from sandbox.engine.joints.welds import accumulate_weld_block, load_weld, report_weld, swept_welds, warm_welds
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FASTEST, GIVE, MOST, PUSH, SECONDS, SWEEP_NETS, WARM_START_NETS
from sandbox.tables import Records


@kernel
def load_nets(work: JointWork) -> None:
    """Fill the lanes for a step: anchors, masses, and the impulses to start from."""
    h = work.side_by_side
    for n in range(h.blocks.shape[0]):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        for k in range(block.count):
            each = h.joints[block.first + k]
            joint = work.joints[each.joint]
            a = work.members[each.member_a]
            b = work.members[each.member_b]
            v[nl.ANCHOR_AX + k] = joint.anchor_ax
            v[nl.ANCHOR_AY + k] = joint.anchor_ay
            v[nl.ANCHOR_BX + k] = joint.anchor_bx
            v[nl.ANCHOR_BY + k] = joint.anchor_by
            v[nl.CENTER_X + k] = b.center_x - a.center_x
            v[nl.CENTER_Y + k] = b.center_y - a.center_y
            v[nl.INVERSE_MASS_A + k] = a.inverse_mass
            v[nl.INVERSE_INERTIA_A + k] = a.inverse_inertia
            v[nl.INVERSE_MASS_B + k] = b.inverse_mass
            v[nl.INVERSE_INERTIA_B + k] = b.inverse_inertia
            v[nl.TOTAL_X + k] = 0.0
            v[nl.TOTAL_Y + k] = 0.0
            if block.kind == nl.RODS:
                load_rod(v, k, joint)
            elif block.kind == nl.WELDS:
                load_weld(v, k, joint)
            else:
                load_hinge(v, k, joint)


@kernel
def warm_start_nets(work: JointWork, part: Records, seconds: float, far: float, workers: Workers) -> None:
    """Apply the impulses of the substep before, but at what turns by more than `far` rad in this one."""
    workers.numbers[FASTEST] = far / seconds
    h = work.side_by_side
    at = part.first_block
    while at < part.block_end:
        stop = at + h.blocks[at].left
        first, end = first_part(workers, WARM_START_NETS, at, stop)
        while first < end:
            warm_start_net_blocks(h, work.members, first, end, far / seconds)
            first, end = next_part(workers, first, end)
        at = stop


@kernel
def warm_start_net_blocks(h: NetLanes, members: Records, first: int, end: int, fastest: float) -> None:
    """The same for blocks of one colour and kind, but at what turns faster than `fastest` rad/s."""
    kind = h.blocks[first].kind
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(members, h, block)
        spins = (absolute(of.velocity.aw) > fastest) | (absolute(of.velocity.bw) > fastest)
        if kind == nl.RODS:
            velocity = warm_rods(v, of, spins)
        elif kind == nl.WELDS:
            velocity = warm_welds(v, of, spins)
        else:
            velocity = warm_hinges(v, of, spins)
        scatter_block(members, of, velocity, block.count)


@kernel
def sweep_nets(work: JointWork, part: Records, soft: SoftJoint, backwards: bool, workers: Workers) -> None:
    """One sweep over the joints of a part that lie in lanes: colour after colour, or from the last colour on."""
    n = workers.numbers
    n[PUSH] = soft.push
    n[MOST] = soft.most
    n[GIVE] = soft.give
    n[SECONDS] = soft.seconds
    h = work.side_by_side
    done = part.first_block
    while done < part.block_end:
        last = part.first_block + part.block_end - 1 - done
        at = last - h.blocks[last].before if backwards else done
        stop = last + 1 if backwards else done + h.blocks[done].left
        first, end = first_part(workers, SWEEP_NETS, at, stop)
        while first < end:
            sweep_net_blocks(h, work.members, first, end, soft)
            first, end = next_part(workers, first, end)
        done += stop - at


@kernel
def sweep_net_blocks(h: NetLanes, members: Records, first: int, end: int, soft: SoftJoint) -> None:
    """The same for blocks of one colour and kind."""
    kind = h.blocks[first].kind  # told apart once: within the loop it costs hinges 7 %
    if kind == nl.RODS:
        _sweep_rods(h, members, first, end, soft)
    elif kind == nl.WELDS:
        _sweep_welds(h, members, first, end, soft)
    else:
        _sweep_hinges(h, members, first, end, soft)


@kernel
def _sweep_hinges(h: NetLanes, members: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(members, h, block)
        scatter_block(members, of, swept_hinges(v, of, soft), block.count)


@kernel
def _sweep_rods(h: NetLanes, members: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(members, h, block)
        scatter_block(members, of, swept_rods(v, of, soft), block.count)


@kernel
def _sweep_welds(h: NetLanes, members: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(members, h, block)
        scatter_block(members, of, swept_welds(members, v, of, soft), block.count)


@kernel
def accumulate_nets(work: JointWork, part: Records) -> None:
    """Add the impulses of a substep to those of the step."""
    h = work.side_by_side
    for n in range(part.first_block, part.block_end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        if block.kind == nl.RODS:
            accumulate_rod_block(v)
        elif block.kind == nl.WELDS:
            accumulate_weld_block(v)
        else:
            accumulate_hinge_block(v)


@kernel
def report_nets(work: JointWork, part: Records, seconds: float, counter: Records) -> None:
    """Write impulses, mean forces on b over the step and breakage into the joint table."""
    h = work.side_by_side
    for n in range(part.first_block, part.block_end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        for k in range(block.count):
            joint = work.joints[h.joints[block.first + k].joint]
            turning = 0.0
            if block.kind == nl.RODS:
                report_rod(v, k, joint)
            elif block.kind == nl.WELDS:
                turning = report_weld(v, k, joint)
            else:
                report_hinge(v, k, joint)
            force_x = v[nl.TOTAL_X + k] / seconds
            force_y = v[nl.TOTAL_Y + k] / seconds
            finish_report(joint, force_x, force_y, turning / seconds, counter)
