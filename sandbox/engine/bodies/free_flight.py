"""Stage: bodies that nothing touches or holds take all substeps one after the other, while they are in the cache.

Nobody asks for their velocities and places meanwhile, so the bits are those of going through all bodies in each
substep.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.bodies.integrate import SOLVED, integrate_position, integrate_velocity
from sandbox.engine.bodies.quarantine import freeze_in_step, slowed
from sandbox.engine.records.bodies import SolverBodies
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records


class Flight(NamedTuple):
    """So many substeps, each of so many seconds; the strength of gravity (m/s^2); whether substeps end with late
    impacts, before which everybody notes the velocity they have."""

    substeps: int
    seconds: float
    gravity: float
    late_impacts: bool


@kernel
def fly(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int, flight: Flight
) -> int:
    """Move bodies that have neither contacts nor joints through all substeps; returns how many were frozen."""
    frozen = 0
    for i in rows:
        force = solver.forces[i]
        if force.moves != SOLVED:
            continue
        motion = solver.motions[i]
        free_motion = solver.free_motions[i]
        angle = motion.delta_angle
        sound = True
        substep = 0
        while sound and substep < flight.substeps:
            integrate_velocity(force, free_motion, motion)
            sound = slowed(motion)
            if sound:
                integrate_position(force, free_motion, motion, flight.gravity, flight.seconds)
            substep += 1
        if not sound:
            freeze_in_step(bodies[i], motion, force, active_info, step_count)
            frozen += 1
            continue
        if motion.delta_angle != angle:
            motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)
        if flight.late_impacts:
            free_motion.start_x = free_motion.free_x = motion.velocity_x
            free_motion.start_y = free_motion.free_y = motion.velocity_y
            free_motion.start_w = free_motion.free_w = motion.angular_velocity
    return frozen
