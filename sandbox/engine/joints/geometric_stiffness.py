"""Links under high tension swing faster than substeps can follow; they get the inertia at which these still can.

A force f that pulls at the arm r of a body turns it back with r . f for each radian: the geometric stiffness of
M. Tournier et al., "Stable Constrained Dynamics", 2015, which in the plane is a number for each body. The substep can
follow as long as its square times that is less than four times the inertia. Thrust, which makes links buckle, is
tamed alike.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records


@kernel
def add_geometric_stiffness(work: JointWork, part: Records, seconds: float, acting: float) -> None:
    """Set the inertia of the members of a part for this substep, from the impulses of the one before."""
    for i in range(part.first_member, part.member_end):
        work.members[i].tension = 0.0
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        constraint = work.constraints[row.constraint]
        if row.sides == 2 and row.stiffness > 0.0:
            force = row.impulse / acting
            work.members[row.member_1].tension += force * (constraint.arm_ax * row.x1 + constraint.arm_ay * row.y1)
            work.members[row.member_2].tension += force * (constraint.arm_bx * row.x2 + constraint.arm_by * row.y2)
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        least = 0.5 * seconds * seconds * abs(member.tension)
        if member.inertia > 0.0:
            member.inverse_inertia = 1.0 / (member.inertia if member.inertia > least else least)


@kernel
def remove_geometric_stiffness(work: JointWork, part: Records) -> None:
    """Give the members of a part their own inertia: only with that can passes not add energy."""
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        if member.inertia > 0.0:
            member.inverse_inertia = 1.0 / member.inertia
