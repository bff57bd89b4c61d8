"""Sweeps over the joints of nets that are solved side by side: colour after colour, four joints of a kind at once."""

from __future__ import annotations

from sandbox._atomics import atomic_add
from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.gather import PairRows, note_rows
from sandbox.engine.contact_solver.soft_constraint import substep_share
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.direct.reports import finish_report
from sandbox.engine.joints.hinges import load_hinge, report_hinge, swept_hinges, warm_hinges
from sandbox.engine.joints.laws import turned
from sandbox.engine.joints.net_blocks import SoftJoint, gather_block, scatter_block
from sandbox.engine.joints.net_lanes import NetLanes
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.rods import load_rod, report_rod, swept_rods, warm_rods
from sandbox.engine.joints.welds import load_weld, report_weld, swept_welds, warm_welds
from sandbox.engine.records.workers import BROKEN, Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import (
    GIVE,
    LOAD_NETS,
    MOST,
    PUSH,
    REPORT_NETS,
    SECONDS,
    SWEEP_NETS,
    WARM_START_NETS,
)
from sandbox.tables import Records


@kernel
def load_nets(work: JointWork, workers: Workers) -> None:
    """Fill the blocks for a step: bodies, anchors, masses, and the impulses to start from."""
    first, end = first_part(workers, LOAD_NETS, 0, work.side_by_side.blocks.shape[0])
    while first < end:
        load_net_blocks(work, first, end)
        first, end = next_part(workers, first, end)


@kernel
def load_net_blocks(work: JointWork, first: int, end: int) -> None:
    """The same for the blocks first..end-1."""
    h = work.side_by_side
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        share = substep_share(work.parts[_part_of(work, h.joints[block.first])].level)
        _note_bodies(work, block)
        for k in range(block.count):
            each = h.joints[block.first + k]
            joint = work.joints[each.joint]
            a = work.members[each.member_a]
            b = work.members[each.member_b]
            ax, ay = turned(a.start_cos, a.start_sin, joint.anchor_ax, joint.anchor_ay)
            bx, by = turned(b.start_cos, b.start_sin, joint.anchor_bx, joint.anchor_by)
            v[nl.ANCHOR_AX + k] = ax
            v[nl.ANCHOR_AY + k] = ay
            v[nl.ANCHOR_BX + k] = bx
            v[nl.ANCHOR_BY + k] = by
            v[nl.CENTER_X + k] = b.center_x - a.center_x
            v[nl.CENTER_Y + k] = b.center_y - a.center_y
            v[nl.INVERSE_MASS_A + k] = a.inverse_mass
            v[nl.INVERSE_INERTIA_A + k] = a.inverse_inertia
            v[nl.INVERSE_MASS_B + k] = b.inverse_mass
            v[nl.INVERSE_INERTIA_B + k] = b.inverse_inertia
            if block.kind == nl.RODS:
                load_rod(v, k, joint, share)
            elif block.kind == nl.WELDS:
                load_weld(v, k, joint, a, b, share)
            else:
                load_hinge(v, k, joint, share)


@inlined_kernel
def _note_bodies(work: JointWork, block: Records) -> None:
    """Note the bodies of the lanes of a block."""
    joints = work.side_by_side.joints
    one = joints[block.first]
    two = joints[block.first + 1] if block.count > 1 else one
    three = joints[block.first + 2] if block.count > 2 else one
    four = joints[block.first + 3] if block.count > 3 else one
    m = work.members
    a = (m[one.member_a].body, m[two.member_a].body, m[three.member_a].body, m[four.member_a].body)
    b = (m[one.member_b].body, m[two.member_b].body, m[three.member_b].body, m[four.member_b].body)
    note_rows(block, PairRows(a, b))


@kernel
def warm_start_lanes(work: JointWork, motions: Records, part: Records, workers: Workers) -> None:
    """Apply the impulses that the joints of a part in lanes have from the substep before."""
    h = work.side_by_side
    at = part.first_block
    while at < part.block_end:
        stop = at + h.blocks[at].left
        first, end = first_part(workers, WARM_START_NETS, at, stop)
        while first < end:
            warm_start_net_blocks(h, motions, first, end)
            first, end = next_part(workers, first, end)
        at = stop


@inlined_kernel
def warm_start_net_blocks(h: NetLanes, motions: Records, first: int, end: int) -> None:
    """The same for blocks of one colour and kind."""
    kind = h.blocks[first].kind
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(motions, block)
        if kind == nl.RODS:
            velocity = warm_rods(v, of)
        elif kind == nl.WELDS:
            velocity = warm_welds(v, of)
        else:
            velocity = warm_hinges(v, of)
        scatter_block(motions, of, velocity, block.count)


@kernel
def sweep_nets(
    work: JointWork, motions: Records, part: Records, soft: SoftJoint, backwards: bool, workers: Workers
) -> None:
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
            sweep_net_blocks(h, motions, first, end, soft)
            first, end = next_part(workers, first, end)
        done += stop - at


@inlined_kernel
def sweep_net_blocks(h: NetLanes, motions: Records, first: int, end: int, soft: SoftJoint) -> None:
    """The same for blocks of one colour and kind. Colours are short, so this and what it calls is always inlined."""
    kind = h.blocks[first].kind  # told apart once: within the loop it costs hinges 7 %
    if kind == nl.RODS:
        _sweep_rods(h, motions, first, end, soft)
    elif kind == nl.WELDS:
        _sweep_welds(h, motions, first, end, soft)
    else:
        _sweep_hinges(h, motions, first, end, soft)


@inlined_kernel
def _sweep_hinges(h: NetLanes, motions: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(motions, block)
        scatter_block(motions, of, swept_hinges(v, of, soft), block.count)


@inlined_kernel
def _sweep_rods(h: NetLanes, motions: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(motions, block)
        scatter_block(motions, of, swept_rods(v, of, soft), block.count)


@inlined_kernel
def _sweep_welds(h: NetLanes, motions: Records, first: int, end: int, soft: SoftJoint) -> None:
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[block.place :]
        of = gather_block(motions, block)
        scatter_block(motions, of, swept_welds(v, of, soft), block.count)


@kernel
def report_nets(work: JointWork, seconds: float, counter: Records, workers: Workers) -> None:
    """Write impulses, mean forces on b over the step and breakage of what is awake into the joint table."""
    workers.numbers[SECONDS] = seconds
    workers.words[BROKEN] = 0
    first, end = first_part(workers, REPORT_NETS, 0, work.side_by_side.blocks.shape[0])
    while first < end:
        report_net_blocks(work, seconds, counter.step_count, workers, first, end)
        first, end = next_part(workers, first, end)
    counter.broken_count += workers.words[BROKEN]


@kernel
def report_net_blocks(work: JointWork, seconds: float, step_count: int, workers: Workers, first: int, end: int) -> None:
    """The same for the blocks first..end-1; counts in `workers.words` how many joints broke."""
    h = work.side_by_side
    broken = 0
    for n in range(first, end):
        block = h.blocks[n]
        part = work.parts[_part_of(work, h.joints[block.first])]
        if part.awake == 0:
            continue
        share = substep_share(part.level)
        v = h.lanes[block.place :]
        for k in range(block.count):
            joint = work.joints[h.joints[block.first + k].joint]
            turning = 0.0
            if block.kind == nl.RODS:
                force_x, force_y = report_rod(v, k, joint, share)
            elif block.kind == nl.WELDS:
                force_x, force_y, turning = report_weld(v, k, joint, share)
            else:
                force_x, force_y = report_hinge(v, k, joint, share)
            broken += finish_report(joint, force_x / seconds, force_y / seconds, turning / seconds, step_count)
    if broken > 0:
        atomic_add(workers.words, BROKEN, broken)


@inlined_kernel
def _part_of(work: JointWork, joint: Records) -> int:
    """The part of a joint: that of the body that it moves, or of both."""
    a = work.members[joint.member_a].part
    b = work.members[joint.member_b].part
    return int(a if a >= 0 else b)
