"""Joints of nets that lie in no lane: impulses from and to the table, the force of each, and whether it breaks."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.soft_constraint import substep_share
from sandbox.engine.joints.direct.batches import slot_impulse
from sandbox.engine.joints.direct.reports import finish_report, set_slot_impulse
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records


@kernel
def read_impulses(work: JointWork) -> None:
    """Start the rows of nets from the impulses of the last step."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        share = substep_share(part.level)
        for r in range(part.first_row, part.row_end if part.swept == 1 else part.first_row):
            row = work.rows[r]
            row.impulse = share * slot_impulse(work.joints[work.constraints[row.constraint].joint], row.slot)
            row.total = 0.0


@kernel
def accumulate(work: JointWork, part: Records) -> None:
    """Add the impulses of a substep to those of the step."""
    if part.swept == 0:
        return
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        row.total += row.impulse


@kernel
def report_swept(work: JointWork, seconds: float, counter: Records) -> None:
    """Write impulses, forces and breakage of joints of nets that are awake and lie in no lane into the joint table."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.awake == 0 or part.swept == 0:
            continue
        for k in range(part.first_constraint, part.constraint_end):
            constraint = work.constraints[k]
            if constraint.in_lane == 0:
                _report(work, constraint, work.joints[constraint.joint], seconds, counter)


@kernel
def _report(work: JointWork, constraint: Records, joint: Records, seconds: float, counter: Records) -> None:
    """Mean force on b over the step, and torque on b about its anchor."""
    force_x = 0.0
    force_y = 0.0
    torque = 0.0
    share = substep_share(work.parts[constraint.part].level)
    for r in range(constraint.first_row, constraint.first_row + constraint.row_count):
        row = work.rows[r]
        set_slot_impulse(joint, row.slot, row.impulse / share)
        mean = row.total / seconds
        force_x += row.x2 * mean
        force_y += row.y2 * mean
        torque += (row.w2 - (constraint.arm_bx * row.y2 - constraint.arm_by * row.x2)) * mean
    counter.broken_count += finish_report(joint, force_x, force_y, torque, counter.step_count)
