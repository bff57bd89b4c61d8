"""Impulses from and to the joint table, the force that each joint gives, and whether it breaks by it."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.joints.hinges import report_hinges
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records


@kernel
def read_impulses(work: JointWork) -> None:
    """Start from the impulses of the last step: half before and half after the move, or all of it before."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.swept == 0:
            continue
        for r in range(part.first_row, part.row_end):
            row = work.rows[r]
            found = _slot_impulse(work.joints[work.constraints[row.constraint].joint], row.slot)
            row.impulse = 0.5 * found if part.halves == 1 else found
            row.relaxing = 0.5 * found if part.halves == 1 else 0.0
            row.total = 0.0


@kernel
def _slot_impulse(joint: Records, slot: int) -> float:
    if slot < 2:
        return float(joint.impulse_0 if slot == 0 else joint.impulse_1)
    if slot == 2:
        return float(joint.impulse_2)
    return float(joint.impulse_3 if slot == 3 else joint.impulse_4)


@kernel
def _set_slot_impulse(joint: Records, slot: int, impulse: float) -> None:
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
def accumulate(work: JointWork, part: Records) -> None:
    """Add the impulses of a substep to those of the step."""
    if part.swept == 0:
        return
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        row.total += row.impulse + row.relaxing


@kernel
def finish_joints(work: JointWork, seconds: float, counter: Records) -> None:
    """Write impulses, forces and breakage of all joints that are awake into the joint table."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.awake == 0:
            continue
        report_hinges(work, part, seconds, counter)
        for k in range(part.first_constraint, part.constraint_end if part.swept == 1 else part.first_constraint):
            constraint = work.constraints[k]
            if constraint.in_lane == 0:
                _report(work, constraint, work.joints[constraint.joint], seconds, counter)


@kernel
def _report(work: JointWork, constraint: Records, joint: Records, seconds: float, counter: Records) -> None:
    """Mean force on b over the step, and torque on b about its anchor."""
    force_x = 0.0
    force_y = 0.0
    torque = 0.0
    for r in range(constraint.first_row, constraint.first_row + constraint.row_count):
        row = work.rows[r]
        _set_slot_impulse(joint, row.slot, row.impulse + row.relaxing)
        mean = row.total / seconds
        force_x += row.x2 * mean
        force_y += row.y2 * mean
        torque += (row.w2 - (constraint.arm_bx * row.y2 - constraint.arm_by * row.x2)) * mean
    joint.force_x = force_x
    joint.force_y = force_y
    joint.torque = torque
    force = math.sqrt(force_x * force_x + force_y * force_y)
    if force > joint.break_force or abs(torque) > joint.break_torque:
        joint.broken_step = counter.step_count
        counter.broken_count += 1
