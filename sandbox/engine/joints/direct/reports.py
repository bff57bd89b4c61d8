"""What the joints of batches gave over a step, into the joint table, and what they say about sleep."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, lanes, load, spread, store
from sandbox.engine.contact_solver.soft_constraint import substep_share
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.batches import joint_rows
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.laws import INFINITE
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.gather_fields import Rows
from sandbox.tables import Records


@kernel
def accumulate(d: Batches, batch: Records) -> None:
    """Add the impulses of a substep to those of the step, and keep along what they act."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        joint = batch.joints + frame.constants
        measured = frame.coordinate_1  # a gear acts on the bodies of the first joint that it couples
        store(v, joint + at.END_ARM_X, load(v, measured + at.ARM_BX))
        store(v, joint + at.END_ARM_Y, load(v, measured + at.ARM_BY))
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        kept = batch.rows + row.kept
        given = load(v, kept + at.IMPULSE) + load(v, kept + at.RELAXING)
        store(v, kept + at.TOTAL, load(v, kept + at.TOTAL) + given)
        side = row.place + at.JACOBIAN + at.SIDE
        store(v, kept + at.END_X, load(v, side))
        store(v, kept + at.END_Y, load(v, side + WIDTH))
        store(v, kept + at.END_W, load(v, side + 2 * WIDTH))


@kernel
def report_batches(work: JointWork, seconds: float, counter: Records) -> None:
    """Write impulses, forces and breakage of all joints of the batches into the joint table."""
    d = work.direct
    for n in range(d.found[0]):
        batch = d.batches[n]
        layout = d.layouts[batch.layout]
        for f in range(layout.first_frame, layout.frame_end):
            frame = d.layout_frames[f]
            if frame.coupled == 0:
                _report(work, batch, frame, joint_rows(work, batch, n, frame), seconds, counter)


@kernel
def _report(work: JointWork, batch: Records, frame: Records, joints: Rows, seconds: float, counter: Records) -> None:
    """Mean force on b over the step, and torque on b about its anchor, of the joints of all lanes."""
    d = work.direct
    v = d.memory
    force_x = spread(0.0)
    force_y = spread(0.0)
    torque = spread(0.0)
    share = substep_share(batch.level)
    arm_x = load(v, batch.joints + frame.constants + at.END_ARM_X)
    arm_y = load(v, batch.joints + frame.constants + at.END_ARM_Y)
    for r in range(frame.first_row, frame.row_end):
        row = d.equations[r]
        kept = batch.rows + row.kept
        for k in range(batch.count):
            joint = work.joints[joints[k]]
            set_slot_impulse(joint, row.slot, (v[kept + at.IMPULSE + k] + v[kept + at.RELAXING + k]) / share)
            if counter.step_count == 0:
                set_slot_preload(joint, row.slot, v[kept + at.PRELOAD + k])
        mean = load(v, kept + at.TOTAL) / seconds
        x = load(v, kept + at.END_X)
        y = load(v, kept + at.END_Y)
        force_x = force_x + x * mean
        force_y = force_y + y * mean
        torque = torque + (load(v, kept + at.END_W) - (arm_x * y - arm_y * x)) * mean
    x_of = lanes(force_x)
    y_of = lanes(force_y)
    torque_of = lanes(torque)
    for k in range(batch.count):
        joint = work.joints[joints[k]]
        counter.broken_count += finish_report(joint, x_of[k], y_of[k], torque_of[k], counter.step_count)


@kernel
def finish_report(joint: Records, force_x: float, force_y: float, torque: float, step_count: int) -> int:
    """Write what a joint gives, and whether it breaks by it; returns 1 if it does.

    One whose bodies are frozen for what it gave, which is no number, gives nothing: no snapshot may hold that.
    """
    force = math.sqrt(force_x * force_x + force_y * force_y)
    if not force + abs(torque) < INFINITE:
        _forget(joint)
        return 0
    joint.force_x = force_x
    joint.force_y = force_y
    joint.torque = torque
    if force > joint.break_force or abs(torque) > joint.break_torque:
        joint.broken_step = step_count
        return 1
    return 0


@kernel
def _forget(joint: Records) -> None:
    """Take back all that a joint gave."""
    for slot in range(5):
        set_slot_impulse(joint, slot, 0.0)
        set_slot_preload(joint, slot, 0.0)
    joint.force_x = 0.0
    joint.force_y = 0.0
    joint.torque = 0.0


@kernel
def set_slot_impulse(joint: Records, slot: int, impulse: float) -> None:
    """What a row gave over the last substep, as of level 0."""
    if slot == 0:
        joint.impulse_0 = impulse
    elif slot == 1:
        joint.impulse_1 = impulse
    elif slot == 2:
        joint.impulse_2 = impulse
    elif slot == 3:
        joint.impulse_3 = impulse
    else:
        joint.impulse_4 = impulse


@kernel
def set_slot_preload(joint: Records, slot: int, force: float) -> None:
    """What a row bore when the world was put down."""
    if slot == 0:
        joint.preload_0 = force
    elif slot == 1:
        joint.preload_1 = force
    elif slot == 2:
        joint.preload_2 = force
