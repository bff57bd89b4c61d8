"""Which rows are part of the linear system: those whose impulse is within its bounds, or on its way back into them.

The bounds of motors, limits, ropes and brakes make this a complementarity problem. It is solved by block pivoting
(J. Judice, F. Pires, 1994): guess which rows are at a bound, solve the others at once, and look again.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.joints.jacobian import row_error, row_speed
from sandbox.engine.joints.ldl import change_impulse
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.targets import INFINITE, pair_strength, target_positions, target_velocities
from sandbox.tables import Records


@kernel
def choose_rows(work: JointWork, part: Records, seconds: float, acting: float, relaxing: bool) -> bool:
    """Set the law of every row at the present velocities and mark the active ones; whether any mark has changed."""
    _aim(work, part, seconds, acting, relaxing)
    changed = False
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        before = row.active
        row.active = 0
        if row.stiffness > 0.0 and row.capped == 0:
            row.active = _is_active(work, row, relaxing)
        changed = changed or row.active != before
    return changed


@kernel
def release_bounded(work: JointWork, part: Records, relaxing: bool) -> None:
    """Take back the impulses of all rows that are not rigid, and leave these out of the linear system."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        if row.stiffness > 0.0 and row.low < row.high and (row.low > -INFINITE or row.high < INFINITE):
            row.active = 0
            change_impulse(work, row, -row.relaxing if relaxing else -row.impulse, relaxing)


@kernel
def _aim(work: JointWork, part: Records, seconds: float, acting: float, relaxing: bool) -> None:
    """Set all laws before any impulse changes: errors ahead belong to the velocities they were looked at with."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        constraint = work.constraints[row.constraint]
        joint = work.joints[constraint.joint]
        if row.stiffness > 0.0 and row.capped == 0:
            speed = row_speed(work.members, row)
            if relaxing:
                target_velocities(row, joint, speed, seconds, part.halves == 1)
            else:
                ahead = row.error + seconds * speed if part.separated == 1 else row_error(row, constraint)
                target_positions(row, joint, ahead, speed, seconds, acting)


@kernel
def _is_active(work: JointWork, row: Records, relaxing: bool) -> int:
    """1 unless the impulse is at a bound and would be pressed further against it. Puts it within its bounds first."""
    clamp(work, row, relaxing)
    current = row.relaxing if relaxing else row.impulse
    if row.low >= row.high:
        return 0
    wanted = row_speed(work.members, row) + row.bias + row.softness * current
    if (current <= row.low and wanted >= 0.0) or (current >= row.high and wanted <= 0.0):
        return 0
    return 1


@kernel
def clamp(work: JointWork, row: Records, relaxing: bool) -> None:
    """Put a row's impulse within its bounds."""
    current = row.relaxing if relaxing else row.impulse
    within = current if current < row.high else row.high
    within = within if within > row.low else row.low
    if within == current:
        return
    change_impulse(work, row, within - current, relaxing)
    if relaxing:  # to the bit, for whoever asks whether it is at its bound
        row.relaxing = within
    else:
        row.impulse = within


@kernel
def cap_pairs(work: JointWork, part: Records, seconds: float, acting: float, relaxing: bool) -> None:
    """Shorten forces of two rows that are together past their limit; such a pair has reached it for this pass."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        joint = work.joints[work.constraints[row.constraint].joint]
        most = pair_strength(row, joint) if row.slot == 0 and row.stiffness > 0.0 else INFINITE
        if most >= INFINITE:
            continue
        other = work.rows[r + 1]
        limit = most * (seconds if relaxing else acting)
        x = row.impulse + row.relaxing if relaxing else row.impulse
        y = other.impulse + other.relaxing if relaxing else other.impulse
        size = math.sqrt(x * x + y * y)
        if size > limit:
            share = limit / size - 1.0
            change_impulse(work, row, share * x, relaxing)
            change_impulse(work, other, share * y, relaxing)
            row.capped = 1
            other.capped = 1
