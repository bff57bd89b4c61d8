"""Jointed bodies between the world and the joint solver: gathered before a pass, scattered after it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records


@kernel
def load_members(work: JointWork, bodies: Records) -> None:
    """Masses and first poses of a step; a part is awake if the solver moves any of its bodies."""
    for p in range(work.parts.shape[0]):
        work.parts[p].awake = 0
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        body = bodies[member.body]
        moves = is_active(body)
        member.inverse_mass = body.inverse_mass if moves else 0.0
        member.inverse_inertia = body.inverse_inertia if moves else 0.0
        member.start_cos = body.rotation_cos
        member.start_sin = body.rotation_sin
        member.start_angle = body.angle
        member.center_x = body.center_x
        member.center_y = body.center_y
        if moves:
            work.parts[member.part].awake = 1


@kernel
def part_level(work: JointWork, part: Records, free_motions: Records) -> int:
    """The substep level of a part: that of the first of its bodies which the solver moves."""
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        if member.inverse_mass > 0.0:
            level: int = free_motions[member.body].substep_level
            return level
    return 0


@kernel
def gather_members(work: JointWork, motions: Records) -> None:
    """Take over the velocities of nets, and of what joints cannot move."""
    i = 1
    while i < work.members.shape[0] and work.members[i].part < 0:
        _gather(work.members[i], motions)
        i += 1
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            for i in range(part.first_member, part.member_end):
                _gather(work.members[i], motions)


@kernel
def _gather(member: Records, motions: Records) -> None:
    motion = motions[member.body]
    member.velocity_x = motion.velocity_x
    member.velocity_y = motion.velocity_y
    member.angular_velocity = motion.angular_velocity


@kernel
def scatter_members(work: JointWork, motions: Records) -> None:
    """Give the velocities of nets back."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            for i in range(part.first_member, part.member_end):
                member = work.members[i]
                if member.inverse_mass > 0.0:
                    motion = motions[member.body]
                    motion.velocity_x = member.velocity_x
                    motion.velocity_y = member.velocity_y
                    motion.angular_velocity = member.angular_velocity


@kernel
def move_by_end_velocity(work: JointWork, motions: Records, free_motions: Records) -> None:
    """Let jointed bodies move by the velocity they have: `integrate_positions` takes the mean with the start."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1:
            for i in range(part.first_member, part.member_end):
                member = work.members[i]
                if member.inverse_mass > 0.0:
                    motion = motions[member.body]
                    free_motion = free_motions[member.body]
                    free_motion.start_x = free_motion.free_x = motion.velocity_x
                    free_motion.start_y = free_motion.free_y = motion.velocity_y
                    free_motion.start_w = free_motion.free_w = motion.angular_velocity


@kernel
def place_members(work: JointWork, part: Records, motions: Records) -> None:
    """Present pose of the members of a net, and of what joints cannot move."""
    i = 1
    while i < part.member_end:
        member = work.members[i]
        if member.part >= 0 and i < part.first_member:
            i = part.first_member
            continue
        motion = motions[member.body]
        member.displacement_x = motion.delta_x
        member.displacement_y = motion.delta_y
        c = motion.delta_cos
        s = motion.delta_sin
        member.cos = member.start_cos * c - member.start_sin * s
        member.sin = member.start_sin * c + member.start_cos * s
        member.angle = member.start_angle + motion.delta_angle
        i += 1
