"""Jointed bodies between the world and the joint solver: gathered before a pass, scattered after it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.geometry.trig import cos_sin
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
        member.inertia = body.inertia if moves and body.inverse_inertia > 0.0 else 0.0
        member.start_cos = body.rotation_cos
        member.start_sin = body.rotation_sin
        member.start_angle = body.angle
        member.center_x = body.center_x
        member.center_y = body.center_y
        if moves:
            work.parts[member.part].awake = 1


@kernel
def gather_members(work: JointWork, motions: Records, free_motions: Records, moving: bool) -> None:
    """Take over velocities. Half of what forces add is held back while bodies are `moving`, and given back after.

    That is the velocity Verlet scheme: positions move by the velocity at the middle of the substep.
    """
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        if member.part >= 0 and work.parts[member.part].current == 0:
            continue
        motion = motions[member.body]
        member.velocity_x = motion.velocity_x
        member.velocity_y = motion.velocity_y
        member.angular_velocity = motion.angular_velocity
        if member.inverse_mass == 0.0 or work.parts[member.part].halves == 0:
            continue
        if moving:
            free_motion = free_motions[member.body]
            member.kick_x = 0.5 * (free_motion.free_x - free_motion.start_x)
            member.kick_y = 0.5 * (free_motion.free_y - free_motion.start_y)
            member.kick_w = 0.5 * (free_motion.free_w - free_motion.start_w)
        sign = -1.0 if moving else 1.0
        member.velocity_x += sign * member.kick_x
        member.velocity_y += sign * member.kick_y
        member.angular_velocity += sign * member.kick_w


@kernel
def scatter_members(work: JointWork, motions: Records) -> None:
    """Give the velocities back."""
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        if member.inverse_mass > 0.0 and work.parts[member.part].current == 1:
            motion = motions[member.body]
            motion.velocity_x = member.velocity_x
            motion.velocity_y = member.velocity_y
            motion.angular_velocity = member.angular_velocity


@kernel
def move_by_end_velocity(work: JointWork, motions: Records, free_motions: Records) -> None:
    """Let jointed bodies move by the velocity they have: `integrate_positions` takes the mean with the start."""
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        if member.inverse_mass > 0.0 and work.parts[member.part].current == 1:
            motion = motions[member.body]
            free_motion = free_motions[member.body]
            free_motion.start_x = free_motion.free_x = motion.velocity_x
            free_motion.start_y = free_motion.free_y = motion.velocity_y
            free_motion.start_w = free_motion.free_w = motion.angular_velocity


@kernel
def predict_poses(work: JointWork, part: Records, motions: Records, ahead: float) -> None:
    """Pose of the members of a part, and of what joints cannot move, `ahead` seconds from now."""
    i = 1
    while i < part.member_end:
        member = work.members[i]
        if member.part >= 0 and i < part.first_member:
            i = part.first_member
            continue
        motion = motions[member.body]
        member.displacement_x = motion.delta_x + ahead * member.velocity_x
        member.displacement_y = motion.delta_y + ahead * member.velocity_y
        turn = motion.delta_angle + ahead * member.angular_velocity
        c = motion.delta_cos
        s = motion.delta_sin
        if ahead != 0.0:
            c, s = cos_sin(turn)
        member.cos = member.start_cos * c - member.start_sin * s
        member.sin = member.start_sin * c + member.start_cos * s
        member.angle = member.start_angle + turn
        i += 1
