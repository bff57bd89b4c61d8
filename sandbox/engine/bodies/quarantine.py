"""Stage: a body with bad numbers is frozen where it last was sound, so that it cannot poison the world."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.tables import Integers, Records
from sandbox.world.records import STATIC

MAX_SPEED = 1e7
"""Metres or radians a second past which a velocity counts as broken."""
MAX_COORDINATE = 1e9
"""Metres from the origin past which a body counts as lost."""


@kernel
def guard_velocities(
    bodies: Records, active_bodies: Integers, motions: Records, forces: Records, active_info: Records, counters: Records
) -> None:
    """Freeze bodies whose velocity is not a number, or too high, before the solver can pass it on."""
    for i in active_bodies:
        if forces[i].moves == 0:
            continue
        motion = motions[i]
        sound = abs(motion.velocity_x) <= MAX_SPEED and abs(motion.velocity_y) <= MAX_SPEED
        if not (sound and abs(motion.angular_velocity) <= MAX_SPEED):
            active_info[0].stale = 1
            _freeze(bodies[i], motion, counters[0])
            forces[i].moves = 0


@kernel
def guard_positions(
    bodies: Records, active_bodies: Integers, motions: Records, active_info: Records, counters: Records
) -> None:
    """Freeze bodies that would leave the world, or whose displacement is not a number, before they are moved."""
    for i in active_bodies:
        body = bodies[i]
        if body.type == STATIC:
            continue
        motion = motions[i]
        x = abs(body.center_x + motion.delta_x)
        y = abs(body.center_y + motion.delta_y)
        turned = abs(body.angle + motion.delta_angle)
        if not (x <= MAX_COORDINATE and y <= MAX_COORDINATE and turned <= MAX_COORDINATE):
            active_info[0].stale = 1
            _freeze(body, motion, counters[0])


@kernel
def _freeze(body: Records, motion: Records, counter: Records) -> None:
    """Make a body static at the pose it had when the step began."""
    body.type = STATIC
    body.frozen_step = counter.step_count
    body.awake = 1
    body.velocity_x = 0.0
    body.velocity_y = 0.0
    body.angular_velocity = 0.0
    body.inverse_mass = 0.0
    body.inverse_inertia = 0.0
    body.force_x = 0.0
    body.force_y = 0.0
    body.torque = 0.0
    motion.velocity_x = 0.0
    motion.velocity_y = 0.0
    motion.angular_velocity = 0.0
    motion.delta_x = 0.0
    motion.delta_y = 0.0
    motion.delta_cos = 1.0
    motion.delta_sin = 0.0
    motion.delta_angle = 0.0
    counter.frozen_count += 1
