"""Batches are put together anew in each step, of the parts that are awake: sleepers take up no lanes.

What a part comes to does not depend on who else is in its batch. Lanes without a part repeat the first one; nothing is
ever read from them.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Vector, load, select, spread, store
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.contact_solver.soft_constraint import substep_share
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import LEVELS, Batches
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.gather_fields import Rows, gather_fields
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import JOINT

_ANCHOR_AX, _AXIS_X, _RATIO, _POINT_BY, _ANGULAR_HERTZ, _LOWER, _MAX_MOTOR = JOINT.places(
    ("anchor_ax", "axis_x", "ratio", "point_by", "angular_hertz", "lower", "max_motor"), 8
)
_IMPULSE_0, _PRELOAD_0 = JOINT.places(("impulse_0", "preload_0"), 8)
"""Numbers of fields of a joint from which on four are read at once."""


@kernel
def fill_batches(work: JointWork, bodies: Records, new: bool) -> None:
    """Lay all factorised parts that are awake into lanes: masses, poses, joints, and the impulses of the last step.

    In the first step of a world all are `new`.
    """
    d = work.direct
    _empty(d)
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.direct == 1 and part.awake == 1:
            _join(d, p, part.level, part)
    v = d.memory
    for n in range(d.found[0]):
        batch = d.batches[n]
        for k in range(WIDTH):
            part = work.parts[d.parts[n * WIDTH + (k if k < batch.count else 0)]]
            v[batch.lanes + at.IN_USE + k] = 1.0 if k < batch.count else 0.0
            v[batch.lanes + at.HALVES + k] = float(part.halves)
            v[batch.lanes + at.SEPARATED + k] = v[batch.lanes + at.CORRECTED + k] = 0.0
            v[batch.lanes + at.NEW + k] = 1.0 if new else 0.0
            v[batch.lanes + at.STRUCK + k] = 0.0
            _load_bodies(work, bodies, part, batch, k)
        _load_joints(work, batch, n)
        _load_rows(work, batch, n)


@kernel
def _empty(d: Batches) -> None:
    d.found[0] = 0
    d.found[1] = d.found[3]
    d.found[2] = 0
    for k in range(d.open.shape[0]):
        d.open[k] = -1


@kernel
def _join(d: Batches, p: int, level: int, part: Records) -> None:
    """Give part `p` a lane in the open batch of its layout and level, or in a new one. What is staggered is apart."""
    staggered = part.free * (1 - part.dragged) * d.layouts[part.layout].staggers
    place = 2 * (part.layout * LEVELS + level) + staggered
    n = d.open[place]
    if n < 0 or d.batches[n].count == WIDTH:
        n = d.found[0]
        _open(d, n, part.layout, level)
        d.batches[n].staggered = staggered
        d.open[place] = n
    batch = d.batches[n]
    d.parts[n * WIDTH + batch.count] = p
    part.lane = n * WIDTH + batch.count
    batch.count += 1


@kernel
def _open(d: Batches, n: int, layout_number: int, level: int) -> None:
    """A new batch, in the memory after the last one."""
    layout = d.layouts[layout_number]
    batch = d.batches[n]
    batch.layout = layout_number
    batch.level = level
    batch.count = 0
    batch.between = 0
    batch.foreseen = 0
    batch.redundant = 0
    batch.in_blow = 0
    batch.next_struck = 0
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
def _load_joints(work: JointWork, batch: Records, n: int) -> None:
    """The constants of the joints of batch n; in the joint table and here they stand in the same order."""
    d = work.direct
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        rows = joint_rows(work, batch, n, frame)
        place = batch.joints + frame.constants
        _store_four(v, place + at.ANCHOR_AX, gather_fields(work.joints, rows, _ANCHOR_AX))
        _store_four(v, place + at.AXIS_X, gather_fields(work.joints, rows, _AXIS_X))
        _store_four(v, place + at.RATIO, gather_fields(work.joints, rows, _RATIO))
        point_by, _, hertz, damping_ratio = gather_fields(work.joints, rows, _POINT_BY)
        store(v, place + at.POINT_BY, point_by)
        store(v, place + at.HERTZ, hertz)
        store(v, place + at.DAMPING_RATIO, damping_ratio)
        angular_hertz, angular_damping_ratio, rest, _ = gather_fields(work.joints, rows, _ANGULAR_HERTZ)
        store(v, place + at.ANGULAR_HERTZ, angular_hertz)
        store(v, place + at.ANGULAR_DAMPING_RATIO, angular_damping_ratio)
        store(v, place + at.REST, rest)
        lower, upper, _, motor_speed = gather_fields(work.joints, rows, _LOWER)
        store(v, place + at.LOWER, lower)
        store(v, place + at.UPPER, upper)
        store(v, place + at.MOTOR_SPEED, motor_speed)
        max_motor, max_force, max_torque, _ = gather_fields(work.joints, rows, _MAX_MOTOR)
        store(v, place + at.MAX_MOTOR, max_motor)
        store(v, place + at.MAX_FORCE, max_force)
        store(v, place + at.MAX_TORQUE, max_torque)
        store(v, place + at.END_ARM_X, spread(0.0))
        store(v, place + at.END_ARM_Y, spread(0.0))


@inlined_kernel
def _store_four(v: Floats, place: int, vectors: tuple[Vector, Vector, Vector, Vector]) -> None:
    store(v, place, vectors[0])
    store(v, place + WIDTH, vectors[1])
    store(v, place + 2 * WIDTH, vectors[2])
    store(v, place + 3 * WIDTH, vectors[3])


@inlined_kernel
def joint_rows(work: JointWork, batch: Records, n: int, frame: Records) -> Rows:
    """Which joint each lane of batch n has for a frame of its layout."""
    first = _joint_of(work, batch, n, frame, 0)
    return (
        first,
        _joint_of(work, batch, n, frame, 1) if batch.count > 1 else first,
        _joint_of(work, batch, n, frame, 2) if batch.count > 2 else first,
        _joint_of(work, batch, n, frame, 3) if batch.count > 3 else first,
    )


@inlined_kernel
def _joint_of(work: JointWork, batch: Records, n: int, frame: Records, k: int) -> int:
    part = work.parts[work.direct.parts[n * WIDTH + k]]
    number: int = work.constraints[part.first_constraint + frame.joint].joint
    if frame.coupled != 0:
        gear = work.joints[number]
        number = gear.joint_1 if frame.coupled == 1 else gear.joint_2
    return number


@kernel
def _load_rows(work: JointWork, batch: Records, n: int) -> None:
    """Impulses of the last step: half before and half after the move, or all of it before; and preloads.

    The joint table has them for all slots, side by side: they pass through the working place of the joint.
    """
    d = work.direct
    v = d.memory
    layout = d.layouts[batch.layout]
    halves = load(v, batch.lanes + at.HALVES) == 1.0
    share = substep_share(batch.level)
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        if frame.coupled != 0:
            continue
        rows = joint_rows(work, batch, n, frame)
        _store_four(v, frame.place, gather_fields(work.joints, rows, _IMPULSE_0))
        _store_four(v, frame.place + 4 * WIDTH, gather_fields(work.joints, rows, _IMPULSE_0 + 4))
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            place = batch.rows + row.kept
            for field in range(at.KEPT_SIZE // WIDTH):
                store(v, place + field * WIDTH, spread(0.0))
            found = share * load(v, frame.place + row.slot * WIDTH)
            store(v, place + at.IMPULSE, select(halves, 0.5 * found, found))
            store(v, place + at.RELAXING, select(halves, 0.5 * found, 0.0))
            if row.slot <= 2:  # only rows that keep a place have a preload
                store(v, place + at.PRELOAD, load(v, frame.place + (_PRELOAD_0 - _IMPULSE_0 + row.slot) * WIDTH))


@kernel
def slot_impulse(joint: Records, slot: int) -> float:
    """What a row gave over the last substep, as of level 0."""
    if slot < 2:
        return float(joint.impulse_0 if slot == 0 else joint.impulse_1)
    if slot == 2:
        return float(joint.impulse_2)
    return float(joint.impulse_3 if slot == 3 else joint.impulse_4)
