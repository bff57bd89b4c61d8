"""Displacements that bring a separated part together: pseudo-velocities, which move bodies once and are then forgotten.

E. Guendelman et al., "Nonconvex Rigid Bodies with Stacking", 2003, separate positions from velocities in this way. The
linear system is damped (K. Levenberg, 1944): joints next to each other come together at once, and what only the whole
chain could do, such as to fit between walls that are too far apart, does not throw its links about.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.ldl import factorize, solve_directly
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.separated import excess_error
from sandbox.engine.joints.targets import CORRECTION_SPEED, is_rigid
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records

DAMPING = 0.03
"""Softness of rows that are corrected, as a share of their stiffness."""


@kernel
def find_corrections(work: JointWork, part: Records, seconds: float) -> None:
    """Find what brings a separated part together without moving or turning a body faster than `CORRECTION_SPEED`."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        excess = excess_error(work, row, seconds)
        rigid = is_rigid(row, work.joints[work.constraints[row.constraint].joint])
        row.active = 1 if rigid or excess != 0.0 else 0
        row.bias = excess / seconds
        row.softness = DAMPING * row.stiffness
    _set_aside(work, part)
    factorize(work, part)
    solve_directly(work, part, False)
    _take_back(work, part)
    _slow_down(work, part)


@kernel
def _set_aside(work: JointWork, part: Records) -> None:
    """Keep velocities and impulses for later; mending begins at rest."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        row.aside = row.impulse
        row.impulse = 0.0
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        member.correction_x = member.velocity_x
        member.correction_y = member.velocity_y
        member.correction_w = member.angular_velocity
        member.velocity_x = 0.0
        member.velocity_y = 0.0
        member.angular_velocity = 0.0


@kernel
def _take_back(work: JointWork, part: Records) -> None:
    """Exchange what was found for the velocities, and put the impulses back."""
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        x = member.velocity_x
        y = member.velocity_y
        w = member.angular_velocity
        member.velocity_x = member.correction_x
        member.velocity_y = member.correction_y
        member.angular_velocity = member.correction_w
        member.correction_x = x
        member.correction_y = y
        member.correction_w = w
    for r in range(part.first_row, part.row_end):
        work.rows[r].impulse = work.rows[r].aside


@kernel
def _slow_down(work: JointWork, part: Records) -> None:
    """Make the fastest member keep to the limit, and all others with it."""
    fastest = CORRECTION_SPEED
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        for speed in (abs(member.correction_x), abs(member.correction_y), abs(member.correction_w)):
            fastest = speed if speed > fastest else fastest
    share = CORRECTION_SPEED / fastest
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        member.correction_x *= share
        member.correction_y *= share
        member.correction_w *= share


@kernel
def apply_corrections(work: JointWork, motions: Records, seconds: float) -> None:
    """Displace the members of separated parts."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.separated == 1:
            for i in range(part.first_member, part.member_end):
                member = work.members[i]
                motion = motions[member.body]
                motion.delta_x += seconds * member.correction_x
                motion.delta_y += seconds * member.correction_y
                motion.delta_angle += seconds * member.correction_w
                motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)
