"""Stage: bodies that nothing touches or holds take all substeps one after the other, while they are in registers.

Nobody asks for their velocities and places meanwhile, so the bits are those of going through all bodies in each
substep.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, absolute, any_lane, select
from sandbox.engine.bodies.integrate import Velocity, forces_on, integrate_velocity, prepare_some_forces
from sandbox.engine.bodies.integrate_positions import Scale, mean_velocity
from sandbox.engine.bodies.quarantine import MAX_SPEED, freeze_in_step, slowed
from sandbox.engine.records.bodies import FREE_Y, INVERSE_MASS, POSE, START, TORQUE, VELOCITY, SolverBodies
from sandbox.engine.records.gather_fields import Rows, gather_fields, rows_from, scatter_fields
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FLY, GRAVITY, IMPACTS, SECONDS, SUBSTEPS, UNITS
from sandbox.geometry.trig import cos_sin, cos_sin_lanes
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
    setting: Records,
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
        frozen += fly_some(bodies, rows[first:end], solver, setting, active_info, step_count, flight)
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
    bodies: Records,
    rows: Integers,
    solver: SolverBodies,
    setting: Records,
    active_info: Records,
    step_count: int,
    flight: Flight,
) -> int:
    """The same for some bodies; returns how many were frozen."""
    frozen = 0
    count = rows.shape[0]
    for k in range(0, count, WIDTH):
        if _coast(bodies, rows_from(rows, k), solver, setting, flight):
            continue
        some = rows[k : k + WIDTH if k + WIDTH < count else count]
        prepare_some_forces(bodies, some, solver, setting, flight.seconds)
        for i in some:
            if not _slow_down(solver, i, flight):
                freeze_in_step(bodies[i], solver.motions[i], solver.forces[i], active_info, step_count)
                frozen += 1
    return frozen


@inlined_kernel
def _coast(bodies: Records, rows: Rows, solver: SolverBodies, setting: Records, flight: Flight) -> bool:
    """Move four bodies side by side. False, with nothing done, where one of them gets too fast."""
    seconds = flight.seconds
    vx, vy, w, x = gather_fields(solver.motions, rows, VELOCITY)
    y, cosine, sine, angle = gather_fields(solver.motions, rows, POSE)
    inverse_mass, inverse_inertia, force_x, force_y = gather_fields(bodies, rows, INVERSE_MASS)
    torque, linear_damping, angular_damping, gravity_scale = gather_fields(bodies, rows, TORQUE)
    ax = gravity_scale * setting.gravity_x + inverse_mass * force_x
    ay = gravity_scale * setting.gravity_y + inverse_mass * force_y
    by_force = forces_on(Velocity(ax, ay, inverse_inertia * torque), linear_damping, angular_damping, seconds)
    change = by_force.change
    start = end = Velocity(vx, vy, w)
    after = angle
    for _substep in range(flight.substeps):
        start = end
        end = Velocity(
            (start.x + change.x) * by_force.linear_decay,
            (start.y + change.y) * by_force.linear_decay,
            (start.w + change.w) * by_force.angular_decay,
        )
        x = x + seconds * (0.5 * (start.x + end.x))
        y = y + seconds * (0.5 * (start.y + end.y))
        after = after + seconds * (0.5 * (start.w + end.w))
    # A substep leaves the faster of two velocities the faster one, so all lie between the first and the last.
    speeds = absolute(vx) + absolute(vy) + absolute(w) + (absolute(end.x) + absolute(end.y) + absolute(end.w))
    if any_lane(~(speeds <= MAX_SPEED)):  # or what is not a number
        return False
    turned = after != angle
    if any_lane(turned):
        new_cosine, new_sine = cos_sin_lanes(after)
        cosine = select(turned, new_cosine, cosine)
        sine = select(turned, new_sine, sine)
    scatter_fields(solver.motions, rows, VELOCITY, (end.x, end.y, end.w, x), 0, WIDTH)
    scatter_fields(solver.motions, rows, POSE, (y, cosine, sine, after), 0, WIDTH)
    _, _, level, buoyed = gather_fields(solver.free_motions, rows, FREE_Y)
    begun = end if flight.late_impacts else start
    scatter_fields(solver.free_motions, rows, START, (begun.x, begun.y, begun.w, end.x), 0, WIDTH)
    scatter_fields(solver.free_motions, rows, FREE_Y, (end.y, end.w, level, buoyed), 0, WIDTH)
    return True


@kernel
def _slow_down(solver: SolverBodies, i: int, flight: Flight) -> bool:
    """Move a body that is slowed down on its way; False for one whose velocity is not a number."""
    force = solver.forces[i]
    motion = solver.motions[i]
    free_motion = solver.free_motions[i]
    angle = motion.delta_angle
    for _substep in range(flight.substeps):
        if not integrate_velocity(force, free_motion, motion) and not slowed(motion):
            return False
        _move(force, free_motion, motion, flight.scale, flight.seconds)
    if motion.delta_angle != angle:
        motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)
    if flight.late_impacts:
        _note_velocity(free_motion, motion)
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
