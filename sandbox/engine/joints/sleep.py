"""What joints say about sleep: which bodies rest by them, and which are kept awake."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, Mask, absolute, any_lane, load, select, spread, store
from sandbox.engine.bodies.flags import KEPT_AWAKE, MOVING_KINEMATIC, SUPPORTED
from sandbox.engine.joints import hinge_lanes as hl
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.targets import is_rigid as is_rigid_row
from sandbox.engine.joints.laws import overrun
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.targets import is_rigid
from sandbox.tables import Integers, Records
from sandbox.world.joint_records import MOTOR, TARGET

CORRECTED = 0.02
"""Bodies whose joint is farther off than this (m or rad) are being drawn together, which does not count as speed."""


@kernel
def flag_supported(flags: Integers, joints: JointWork) -> None:
    """What hangs from something that does not move rests as well, and what hangs together rests together."""
    for i in range(1, joints.members.shape[0]):
        member = joints.members[i]
        if member.part >= 0 and (joints.parts[member.part].anchored == 1 or joints.parts[member.part].supported == 1):
            flags[member.body] |= SUPPORTED


@kernel
def keep_awake_at_kinematic(flags: Integers, joints: JointWork) -> None:
    """Bodies that a joint ties to a driven body do not fall asleep."""
    for i in range(joints.ties.shape[0]):
        a = joints.ties[i].low
        b = joints.ties[i].high
        if (flags[a] | flags[b]) & MOVING_KINEMATIC:
            flags[a] |= KEPT_AWAKE
            flags[b] |= KEPT_AWAKE


@kernel
def keep_awake_while_corrected(flags: Integers, joints: JointWork) -> None:
    """Bodies that a rigid joint or a limit is still drawing to where they belong do not fall asleep."""
    d = joints.direct
    for n in range(d.found[0]):
        _keep_corrected_batch_awake(flags, d, n)
    for p in range(joints.parts.shape[0]):
        part = joints.parts[p]
        if part.awake == 0 or part.direct == 1:
            continue
        for n in range(part.first_block, part.block_end):
            _keep_torn_hinges_awake(flags, joints, n)
        for r in range(part.first_row, part.row_end if part.swept == 1 else part.first_row):
            row = joints.rows[r]
            if _is_being_corrected(row, joints.joints[joints.constraints[row.constraint].joint]):
                _keep_awake(flags, joints, row.member_1, row.member_2)


@kernel
def _keep_corrected_batch_awake(flags: Integers, d: Batches, n: int) -> None:
    batch = d.batches[n]
    layout = d.layouts[batch.layout]
    in_use = load(d.memory, batch.lanes + at.IN_USE) == 1.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        joint = batch.joints + frame.constants
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            error = load(d.memory, batch.rows + row.kept + at.ERROR)
            if row.slot == 4 and frame.limit == 1:
                over = overrun(error, load(d.memory, joint + at.LOWER), load(d.memory, joint + at.UPPER))
                found = in_use & (absolute(over) > CORRECTED)
            elif row.slot < 3 and frame.kind != MOTOR and frame.kind != TARGET:
                found = in_use & is_rigid_row(d.memory, batch, frame, row) & (absolute(error) > CORRECTED)
            else:
                continue
            if any_lane(found):
                _keep_lanes_awake(flags, d, batch, frame, found)


@kernel
def _keep_lanes_awake(flags: Integers, d: Batches, batch: Records, frame: Records, found: Mask) -> None:
    store(d.memory, 0, select(found, 1.0, spread(0.0)))  # the working place is free by now
    for k in range(batch.count):
        a = d.bodies[batch.bodies + frame.slot_a * WIDTH + k]
        b = d.bodies[batch.bodies + frame.slot_b * WIDTH + k]
        if d.memory[k] == 1.0:
            if a >= 0:
                flags[a] |= KEPT_AWAKE
            if b >= 0:
                flags[b] |= KEPT_AWAKE


@kernel
def _keep_torn_hinges_awake(flags: Integers, joints: JointWork, n: int) -> None:
    h = joints.side_by_side
    v = h.lanes[n * hl.HINGE_BLOCK_SIZE : (n + 1) * hl.HINGE_BLOCK_SIZE]
    for k in range(h.blocks[n].count):
        if abs(v[hl.GAP_X + k]) > CORRECTED or abs(v[hl.GAP_Y + k]) > CORRECTED:
            hinge = h.hinges[h.blocks[n].first + k]
            _keep_awake(flags, joints, hinge.member_a, hinge.member_b)


@kernel
def _keep_awake(flags: Integers, joints: JointWork, member_a: int, member_b: int) -> None:
    a = joints.members[member_a].body
    b = joints.members[member_b].body
    if a >= 0:
        flags[a] |= KEPT_AWAKE
    if b >= 0:
        flags[b] |= KEPT_AWAKE


@kernel
def _is_being_corrected(row: Records, joint: Records) -> bool:
    if row.slot == 4:
        return bool(joint.limit == 1 and abs(overrun(row.error, joint.lower, joint.upper)) > CORRECTED)
    weak = joint.kind == MOTOR or joint.kind == TARGET
    return bool(not weak and is_rigid(row, joint) and abs(row.error) > CORRECTED)
