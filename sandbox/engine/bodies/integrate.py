"""Stages: velocities from forces, and the new poses at the end of a step."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Number
from sandbox.engine.bodies.quarantine import freeze_in_step, is_slow, slowed
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import INTEGRATE_VELOCITIES, PREPARE_FORCES, SECONDS
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

SOLVED = 1.0
"""`forces.moves` of a body that the solver moves."""
LED = 2.0
"""`forces.moves` of a body that follows a velocity of its own: kinematic."""


class Velocity(NamedTuple):
    """Of a body, in m/s and rad/s."""

    x: Number
    y: Number
    w: Number


class ByForce(NamedTuple):
    """A velocity, after some time, is the sum of what it was and `change`, times what its decay leaves."""

    change: Velocity
    linear_decay: Number
    angular_decay: Number


@inlined_kernel
def begin_motion(body: Records, motion: Records, free_motion: Records) -> float:
    """Load the velocity of a body; it has not moved yet, and nothing is known to hinder it.

    Returns the square of the highest speed (m/s) of a point of it.
    """
    vx = body.velocity_x
    vy = body.velocity_y
    w = body.angular_velocity
    # A zero without its sign: impulses on what has no inverse mass leave that as it is, whoever applies them.
    motion.velocity_x = vx + 0.0
    motion.velocity_y = vy + 0.0
    motion.angular_velocity = w + 0.0
    motion.delta_x = 0.0
    motion.delta_y = 0.0
    motion.delta_cos = 1.0
    motion.delta_sin = 0.0
    motion.delta_angle = 0.0
    free_motion.substep_level = 0
    free_motion.start_x = free_motion.free_x = vx
    free_motion.start_y = free_motion.free_y = vy
    free_motion.start_w = free_motion.free_w = w
    rim = w * body.extent
    return float(vx * vx + vy * vy + rim * rim)


@kernel
def prepare_forces(
    bodies: Records,
    active_bodies: Integers,
    solver: SolverBodies,
    setting: Records,
    seconds: float,
    workers: Workers,
) -> None:
    """Work out once what forces and damping do to bodies in each of their substeps of so many `seconds`."""
    workers.numbers[SECONDS] = seconds
    first, end = first_part(workers, PREPARE_FORCES, 0, active_bodies.shape[0])
    while first < end:
        prepare_some_forces(bodies, active_bodies[first:end], solver, setting, seconds)
        first, end = next_part(workers, first, end)


@kernel
def prepare_some_forces(
    bodies: Records, rows: Integers, solver: SolverBodies, setting: Records, seconds: float
) -> None:
    """The same for some bodies."""
    for i in rows:
        body = bodies[i]
        force = solver.forces[i]
        force.moves = SOLVED if body.type == DYNAMIC else LED
        force.by_end = 0.0
        if body.type == STATIC or body.awake == 0:
            force.moves = 0.0
            continue
        ax = body.gravity_scale * setting.gravity_x + body.inverse_mass * body.force_x
        ay = body.gravity_scale * setting.gravity_y + body.inverse_mass * body.force_y
        acceleration = Velocity(ax, ay, body.inverse_inertia * body.torque)
        by_force = forces_on(acceleration, body.linear_damping, body.angular_damping, seconds)
        force.change_x = by_force.change.x
        force.change_y = by_force.change.y
        force.change_w = by_force.change.w
        force.linear_decay = by_force.linear_decay
        force.angular_decay = by_force.angular_decay
        force.extent = body.extent


@inlined_kernel
def forces_on(acceleration: Velocity, linear_damping: Number, angular_damping: Number, seconds: float) -> ByForce:
    """What an acceleration (m/s^2, rad/s^2) and damping (1/s) do to a velocity within so many seconds.

    Exact terminal velocity, decay to second order, always stable.
    """
    lag = 1.0 + 0.5 * seconds * linear_damping
    turn_lag = 1.0 + 0.5 * seconds * angular_damping
    change = Velocity(
        seconds * acceleration.x * lag, seconds * acceleration.y * lag, seconds * acceleration.w * turn_lag
    )
    return ByForce(change, _decay(seconds * linear_damping), _decay(seconds * angular_damping))


@kernel
def integrate_velocities(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int, workers: Workers
) -> int:
    """Gravity, forces and damping over one substep; what was or gets too fast is slowed down. Returns how many bodies
    this worker has frozen."""
    frozen = 0
    first, end = first_part(workers, INTEGRATE_VELOCITIES, 0, rows.shape[0])
    while first < end:
        frozen += integrate_some_velocities(bodies, rows[first:end], solver, active_info, step_count)
        first, end = next_part(workers, first, end)
    return frozen


@kernel
def integrate_some_velocities(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int
) -> int:
    """The same for some bodies."""
    frozen = 0
    for i in rows:
        force = solver.forces[i]
        if force.moves != SOLVED:
            continue
        motion = solver.motions[i]
        fine = integrate_velocity(force, solver.free_motions[i], motion)
        if not fine and not slowed(motion):
            freeze_in_step(bodies[i], motion, force, active_info, step_count)
            frozen += 1
    return frozen


@inlined_kernel
def integrate_velocity(force: Records, free_motion: Records, motion: Records) -> bool:
    """The same for one body, which the solver moves, but for what is too fast: whether it is not."""
    start_x = motion.velocity_x
    start_y = motion.velocity_y
    start_w = motion.angular_velocity
    vx = (start_x + force.change_x) * force.linear_decay
    vy = (start_y + force.change_y) * force.linear_decay
    w = (start_w + force.change_w) * force.angular_decay
    motion.velocity_x = vx
    motion.velocity_y = vy
    motion.angular_velocity = w
    free_motion.start_x = start_x
    free_motion.start_y = start_y
    free_motion.start_w = start_w
    free_motion.free_x = vx
    free_motion.free_y = vy
    free_motion.free_w = w
    return is_slow(vx, vy, w)


@inlined_kernel
def _decay(x: Number) -> Number:
    """exp(-x) to second order, for x >= 0: never negative, so that strong damping stays stable."""
    return 1.0 / (1.0 + x + 0.5 * x * x)


@inlined_kernel
def finish_motion(body: Records, motion: Records) -> None:
    """Write the new velocity and pose into a body and clear the forces."""
    if body.type == STATIC or body.awake == 0:
        return
    body.velocity_x = motion.velocity_x
    body.velocity_y = motion.velocity_y
    body.angular_velocity = motion.angular_velocity
    body.center_x += motion.delta_x
    body.center_y += motion.delta_y
    if motion.delta_angle != 0.0:
        angle: float = body.angle + motion.delta_angle
        body.angle = angle
        body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)
    body.force_x = 0.0
    body.force_y = 0.0
    body.torque = 0.0


@kernel
def place_origin(body: Records) -> None:
    """Derive the origin from the centre of mass and the rotation."""
    x = body.local_center_x
    y = body.local_center_y
    body.position_x = body.center_x - (body.rotation_cos * x - body.rotation_sin * y)
    body.position_y = body.center_y - (body.rotation_sin * x + body.rotation_cos * y)
