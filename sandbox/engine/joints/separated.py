"""What a substep does about joints that are torn apart, or whose links turn too fast to foresee.

A joint that is drawn together moves all that hangs on it, so that the speeds which would correct a long chain at once
are enormous. A part that is *separated*, by an impact or a command, is therefore solved otherwise: its velocities only
keep the errors as they are, which takes no look ahead and cannot add energy, and displacements that velocities never
see bring it together (`position_correction`).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.jacobian import row_error
from sandbox.engine.joints.ldl import change_impulse
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.targets import COMPLIANCE, CORRECTION_SPEED, is_rigid, limited
from sandbox.tables import Records
from sandbox.world.joint_records import MOTOR

SHORT = 2
"""Joints of a part whose speeds of correction may add up."""


@kernel
def detect_separation(work: JointWork, part: Records, seconds: float) -> None:
    """Set what every row may have left of its error after this substep; the impulses are still those of the last.

    A part is separated if its errors come to more than one joint may correct, unless it has but two joints.
    """
    total = 0.0
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        excess = excess_error(work, row, seconds)
        row.kept = limited(excess, seconds)
        row.apart = _without_yield(row, seconds) if row.slot < 3 else excess
        total += abs(excess)
    long = part.constraint_end - part.first_constraint > SHORT
    part.separated = 1 if long and total > CORRECTION_SPEED * seconds else 0
    if part.separated == 1:
        for r in range(part.first_row, part.row_end):
            work.rows[r].kept = work.rows[r].apart


@kernel
def excess_error(work: JointWork, row: Records, seconds: float) -> float:
    """How far a limit is overrun, or the error of a rigid row beyond what it yields to its impulse, in m or rad."""
    joint = work.joints[work.constraints[row.constraint].joint]
    if row.slot == 4 and joint.limit == 1 and row.stiffness > 0.0:
        return overrun(joint, row.error)
    return float(row.error - _yielded(row, seconds)) if is_rigid(row, joint) else 0.0


@kernel
def overrun(joint: Records, place: float) -> float:
    """Signed distance to the limit that has been passed; 0 between the limits."""
    over = place - joint.upper
    under = place - joint.lower
    return float(over if over > 0.0 else (under if under < 0.0 else 0.0))


@kernel
def _yielded(row: Records, seconds: float) -> float:
    """Error that the softness of a rigid row leaves under the impulse of the last substep, and gives back."""
    return float(-seconds * COMPLIANCE * row.stiffness * row.impulse)


@kernel
def _without_yield(row: Records, seconds: float) -> float:
    """Error of a row less what it yields, which is part of it; an impulse that was an impact says nothing about it."""
    size = abs(row.error)
    share = _yielded(row, seconds) if row.error > 0.0 else -_yielded(row, seconds)
    share = share if share > 0.0 else 0.0
    left = size - share if share < size else 0.0
    return float(left if row.error > 0.0 else -left)


@kernel
def misses_targets(work: JointWork, part: Records, seconds: float) -> bool:
    """Whether some joint, at the predicted pose, misses its aim by more than a substep could correct."""
    most = CORRECTION_SPEED * seconds
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        constraint = work.constraints[row.constraint]
        joint = work.joints[constraint.joint]
        error = row_error(row, constraint)
        missed = 0.0
        if row.slot == 4 and joint.limit == 1 and row.active == 1 and row.stop != 0:
            missed = abs(error - (joint.upper if row.stop < 0 else joint.lower) - row.kept)
        elif row.slot == 4 and joint.limit == 1 and row.stiffness > 0.0:
            missed = abs(overrun(joint, error)) - abs(row.kept)
        elif is_rigid(row, joint):
            missed = abs(error - row.kept + seconds * row.softness * row.impulse)
        if missed > (4.0 * most if joint.kind == MOTOR else most):  # a motor may have a long way to go
            return True
    return False


@kernel
def solve_velocities_only(work: JointWork, part: Records) -> None:
    """Take back what the rows have done in this substep; the part counts as separated."""
    part.separated = 1
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        row.kept = row.apart
        row.capped = 0
        row.active = -1 if row.stiffness > 0.0 else 0
        change_impulse(work, row, -row.impulse, False)
