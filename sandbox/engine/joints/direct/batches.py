"""Batches are put together anew in each step, of the parts that are awake: sleepers take up no lanes.

What a part comes to does not depend on who else is in its batch. Lanes without a part repeat the first one; nothing is
ever read from them.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import LEVELS, Batches
from sandbox.engine.joints.joint_bodies import part_level
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Floats, Records


@kernel
def fill_batches(work: JointWork, bodies: Records, free_motions: Records, new: bool) -> None:
    """Lay all factorised parts that are awake into lanes: masses, poses, joints, and the impulses of the last step.

    In the first step of a world all are `new`.
    """
    d = work.direct
    _empty(d)
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.direct == 1 and part.awake == 1:
            _join(d, p, part.layout, part_level(work, part, free_motions))
    v = d.memory
    for n in range(d.found[0]):
        batch = d.batches[n]
        for k in range(WIDTH):
            part = work.parts[d.parts[n * WIDTH + (k if k < batch.count else 0)]]
            v[batch.lanes + at.IN_USE + k] = 1.0 if k < batch.count else 0.0
            v[batch.lanes + at.HALVES + k] = float(part.halves)
            v[batch.lanes + at.SEPARATED + k] = 0.0
            v[batch.lanes + at.NEW + k] = 1.0 if new else 0.0
            _load_bodies(work, bodies, part, batch, k)
            _load_joints(work, part, batch, k)
            _load_rows(work, part, batch, k)


@kernel
def _empty(d: Batches) -> None:
    d.found[0] = 0
    d.found[1] = d.found[3]
    d.found[2] = 0
    for k in range(d.open.shape[0]):
        d.open[k] = -1


@kernel
def _join(d: Batches, p: int, layout_number: int, level: int) -> None:
    """Give part `p` a lane in the open batch of its layout and level, or in a new one."""
    place = layout_number * LEVELS + level
    n = d.open[place]
    if n < 0 or d.batches[n].count == WIDTH:
        n = d.found[0]
        _open(d, n, layout_number, level)
        d.open[place] = n
    batch = d.batches[n]
    d.parts[n * WIDTH + batch.count] = p
    batch.count += 1


@kernel
def _open(d: Batches, n: int, layout_number: int, level: int) -> None:
    """A new batch, in the memory after the last one."""
    layout = d.layouts[layout_number]
    batch = d.batches[n]
    batch.layout = layout_number
    batch.level = level
    batch.count = 0
    batch.foreseen = 0
    batch.bodies = d.found[2]
    batch.lanes = d.found[1]
    batch.seats = batch.lanes + at.LANE_SIZE
    batch.joints = batch.seats + layout.seats * at.SEAT_SIZE
    batch.rows = batch.joints + (layout.frame_end - layout.first_frame) * at.JOINT_SIZE
    d.found[0] = n + 1
    d.found[1] = batch.rows + (layout.row_end - layout.first_row) * at.KEPT_SIZE
    d.found[2] += layout.seats * WIDTH


@kernel
def _load_bodies(work: JointWork, bodies: Records, part: Records, batch: Records, k: int) -> None:
    d = work.direct
    layout = d.layouts[batch.layout]
    for slot in range(layout.seats):
        if slot < layout.moving:
            body = work.members[part.first_member + slot].body
        else:
            body = d.fixed[part.first_fixed + slot - layout.moving]
        seat = batch.seats + slot * at.SEAT_SIZE
        d.bodies[batch.bodies + slot * WIDTH + k] = body
        _load_body(d.memory, seat + k, bodies, body)


@kernel
def _load_body(v: Floats, seat: int, bodies: Records, index: int) -> None:
    """The world is a body that stays where it is."""
    for field in range(at.SEAT_SIZE // WIDTH):
        v[seat + field * WIDTH] = 0.0
    v[seat + at.START_COS] = 1.0
    if index < 0:
        return
    body = bodies[index]
    if is_active(body):
        v[seat + at.INVERSE_MASS] = body.inverse_mass
        v[seat + at.INVERSE_INERTIA] = body.inverse_inertia
        v[seat + at.INERTIA] = body.inertia if body.inverse_inertia > 0.0 else 0.0
    v[seat + at.START_COS] = body.rotation_cos
    v[seat + at.START_SIN] = body.rotation_sin
    v[seat + at.START_ANGLE] = body.angle
    v[seat + at.CENTER_X] = body.center_x
    v[seat + at.CENTER_Y] = body.center_y


@kernel
def _load_joints(work: JointWork, part: Records, batch: Records, k: int) -> None:
    d = work.direct
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        number = work.constraints[part.first_constraint + frame.joint].joint
        if frame.coupled != 0:
            gear = work.joints[number]
            number = gear.joint_1 if frame.coupled == 1 else gear.joint_2
        joint = work.joints[number]
        place = batch.joints + frame.constants + k
        v[place + at.ANCHOR_AX] = joint.anchor_ax
        v[place + at.ANCHOR_AY] = joint.anchor_ay
        v[place + at.ANCHOR_BX] = joint.anchor_bx
        v[place + at.ANCHOR_BY] = joint.anchor_by
        v[place + at.AXIS_X] = joint.axis_x
        v[place + at.AXIS_Y] = joint.axis_y
        v[place + at.REFERENCE_ANGLE] = joint.reference_angle
        v[place + at.LENGTH] = joint.length
        v[place + at.RATIO] = joint.ratio
        v[place + at.POINT_AX] = joint.point_ax
        v[place + at.POINT_AY] = joint.point_ay
        v[place + at.POINT_BX] = joint.point_bx
        v[place + at.POINT_BY] = joint.point_by
        v[place + at.HERTZ] = joint.hertz
        v[place + at.DAMPING_RATIO] = joint.damping_ratio
        v[place + at.ANGULAR_HERTZ] = joint.angular_hertz
        v[place + at.ANGULAR_DAMPING_RATIO] = joint.angular_damping_ratio
        v[place + at.REST] = joint.rest
        v[place + at.LOWER] = joint.lower
        v[place + at.UPPER] = joint.upper
        v[place + at.MOTOR_SPEED] = joint.motor_speed
        v[place + at.MAX_MOTOR] = joint.max_motor
        v[place + at.MAX_FORCE] = joint.max_force
        v[place + at.MAX_TORQUE] = joint.max_torque
        v[place + at.END_ARM_X] = 0.0
        v[place + at.END_ARM_Y] = 0.0


@kernel
def _load_rows(work: JointWork, part: Records, batch: Records, k: int) -> None:
    """Impulses of the last step: half before and half after the move, or all of it before."""
    d = work.direct
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        if frame.coupled != 0:
            continue
        joint = work.joints[work.constraints[part.first_constraint + frame.joint].joint]
        for r in range(frame.first_row, frame.row_end):
            equation = d.equations[r]
            place = batch.rows + equation.kept + k
            for field in range(at.KEPT_SIZE // WIDTH):
                v[place + field * WIDTH] = 0.0
            found = slot_impulse(joint, equation.slot)
            v[place + at.IMPULSE] = 0.5 * found if part.halves == 1 else found
            v[place + at.RELAXING] = 0.5 * found if part.halves == 1 else 0.0
            v[place + at.PRELOAD] = slot_preload(joint, equation.slot)


@kernel
def slot_impulse(joint: Records, slot: int) -> float:
    """What a row gave over the last substep."""
    if slot < 2:
        return float(joint.impulse_0 if slot == 0 else joint.impulse_1)
    if slot == 2:
        return float(joint.impulse_2)
    return float(joint.impulse_3 if slot == 3 else joint.impulse_4)


@kernel
def slot_preload(joint: Records, slot: int) -> float:
    """What a row bears without giving way; only rows that keep a place have a preload."""
    if slot > 2:
        return 0.0
    if slot == 2:
        return float(joint.preload_2)
    return float(joint.preload_0 if slot == 0 else joint.preload_1)
