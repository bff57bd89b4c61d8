"""Stage: bodies that nothing touches or holds take all substeps one after the other, while they are in the cache.

Nobody asks for their velocities and places meanwhile, so the bits are those of going through all bodies in each
substep.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.integrate import SOLVED, integrate_velocity
from sandbox.engine.bodies.integrate_positions import Scale, Velocity, mean_velocity
from sandbox.engine.bodies.quarantine import freeze_in_step, is_slow, slowed
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FLY, GRAVITY, IMPACTS, SECONDS, SUBSTEPS, UNITS
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Floats, Integers, Records


class Flight(NamedTuple):
    """So many substeps, each of so many seconds; what is gentle; whether substeps end with late impacts, before which
    everybody notes the velocity they have."""

    substeps: int
    seconds: float
    scale: Scale
    late_impacts: bool


@kernel
def fly(
    bodies: Records,
    rows: Integers,
    held_count: int,
    solver: SolverBodies,
    active_info: Records,
    step_count: int,
    flight: Flight,
    workers: Workers,
) -> int:
    """Move the bodies behind the first `held_count`, which have neither contacts nor joints, through all substeps.

    Returns how many this worker has frozen.
    """
    tell_flight(workers.numbers, flight)
    frozen = 0
    first, end = first_part(workers, FLY, held_count, rows.shape[0])
    while first < end:
        frozen += fly_some(bodies, rows[first:end], solver, active_info, step_count, flight)
        first, end = next_part(workers, first, end)
    return frozen


@kernel
def tell_flight(numbers: Floats, flight: Flight) -> None:
    """Tell who moves bodies how they are to be moved."""
    numbers[SUBSTEPS] = flight.substeps
    numbers[SECONDS] = flight.seconds
    numbers[GRAVITY] = flight.scale.gravity
    numbers[UNITS] = flight.scale.units_per_meter
    numbers[IMPACTS] = 1.0 if flight.late_impacts else 0.0


@kernel
def told_flight(n: Floats) -> Flight:
    """How bodies are to be moved."""
    return Flight(int(n[SUBSTEPS]), n[SECONDS], Scale(n[GRAVITY], n[UNITS]), n[IMPACTS] > 0.0)


@kernel
def fly_some(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int, flight: Flight
) -> int:
    """The same for some bodies; returns how many were frozen."""
    frozen = 0
    for i in rows:
        force = solver.forces[i]
        if force.moves != SOLVED:
            continue
        motion = solver.motions[i]
        free_motion = solver.free_motions[i]
        angle = motion.delta_angle
        if not (_coast(force, motion, free_motion, flight) or _slow_down(force, motion, free_motion, flight)):
            freeze_in_step(bodies[i], motion, force, active_info, step_count)
            frozen += 1
            continue
        if motion.delta_angle != angle:
            motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)
        if flight.late_impacts:
            _note_velocity(free_motion, motion)
    return frozen


@inlined_kernel
def _coast(force: Records, motion: Records, free_motion: Records, flight: Flight) -> bool:
    """Move a body that never gets too fast, in registers. False, with nothing done, for any other."""
    seconds = flight.seconds
    vx = start_x = motion.velocity_x
    vy = start_y = motion.velocity_y
    w = start_w = motion.angular_velocity
    x = motion.delta_x
    y = motion.delta_y
    angle = motion.delta_angle
    change_x = force.change_x
    change_y = force.change_y
    change_w = force.change_w
    linear = force.linear_decay
    angular = force.angular_decay
    for _substep in range(flight.substeps):
        start_x = vx
        start_y = vy
        start_w = w
        vx = (vx + change_x) * linear
        vy = (vy + change_y) * linear
        w = (w + change_w) * angular
        x += seconds * (0.5 * (start_x + vx))
        y += seconds * (0.5 * (start_y + vy))
        angle += seconds * (0.5 * (start_w + w))
    # A substep leaves the faster of two velocities the faster one, so all lie between the first and the last.
    if not (is_slow(motion.velocity_x, motion.velocity_y, motion.angular_velocity) and is_slow(vx, vy, w)):
        return False
    motion.velocity_x = vx
    motion.velocity_y = vy
    motion.angular_velocity = w
    motion.delta_x = x
    motion.delta_y = y
    motion.delta_angle = angle
    free_motion.start_x = start_x
    free_motion.start_y = start_y
    free_motion.start_w = start_w
    free_motion.free_x = vx
    free_motion.free_y = vy
    free_motion.free_w = w
    return True


@kernel
def _slow_down(force: Records, motion: Records, free_motion: Records, flight: Flight) -> bool:
    """Move a body that is slowed down on its way; False for one whose velocity is not a number."""
    for _substep in range(flight.substeps):
        integrate_velocity(force, free_motion, motion)
        if not slowed(motion):
            return False
        _move(force, free_motion, motion, flight.scale, flight.seconds)
    return True


@inlined_kernel
def _move(force: Records, free_motion: Records, motion: Records, scale: Scale, seconds: float) -> None:
    """As `integrate_positions` does, but for the cosine and sine of what the body has turned by."""
    start = Velocity(free_motion.start_x, free_motion.start_y, free_motion.start_w)
    free = Velocity(free_motion.free_x, free_motion.free_y, free_motion.free_w)
    end = Velocity(motion.velocity_x, motion.velocity_y, motion.angular_velocity)
    mean = mean_velocity(start, free, end, force.extent, seconds, scale)
    motion.delta_x += seconds * mean.x
    motion.delta_y += seconds * mean.y
    motion.delta_angle += seconds * mean.w


@inlined_kernel
def _note_velocity(free_motion: Records, motion: Records) -> None:
    """Let the velocity of now be that with which impacts begin."""
    free_motion.start_x = free_motion.free_x = motion.velocity_x
    free_motion.start_y = free_motion.free_y = motion.velocity_y
    free_motion.start_w = free_motion.free_w = motion.angular_velocity
