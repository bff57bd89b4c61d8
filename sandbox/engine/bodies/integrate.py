"""Stages: velocities from forces, and the new poses at the end of a step."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import INTEGRATE_VELOCITIES, LEVEL, PREPARE_FORCES, SECONDS
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

SOLVED = 1.0
"""`forces.moves` of a body that the solver moves."""
LED = 2.0
"""`forces.moves` of a body that follows a velocity of its own: kinematic."""


@kernel
def begin_motions(bodies: Records, active_bodies: Integers, solver: SolverBodies) -> float:
    """Load the velocities; nothing has moved yet, and nothing is known to hinder anybody.

    Returns the square of the highest speed (m/s) of a point of any body.
    """
    fastest = 0.0
    for i in active_bodies:
        body = bodies[i]
        motion = solver.motions[i]
        # A zero without its sign: impulses on what has no inverse mass leave that as it is, whoever applies them.
        motion.velocity_x = body.velocity_x + 0.0
        motion.velocity_y = body.velocity_y + 0.0
        motion.angular_velocity = body.angular_velocity + 0.0
        motion.delta_x = 0.0
        motion.delta_y = 0.0
        motion.delta_cos = 1.0
        motion.delta_sin = 0.0
        motion.delta_angle = 0.0
        free_motion = solver.free_motions[i]
        free_motion.substep_level = 0
        free_motion.start_x = free_motion.free_x = body.velocity_x
        free_motion.start_y = free_motion.free_y = body.velocity_y
        free_motion.start_w = free_motion.free_w = body.angular_velocity
        rim = body.angular_velocity * body.extent
        square = body.velocity_x * body.velocity_x + body.velocity_y * body.velocity_y + rim * rim
        fastest = square if square > fastest else fastest
    return fastest


@kernel
def prepare_forces(
    bodies: Records,
    active_bodies: Integers,
    solver: SolverBodies,
    substep_level: int,
    setting: Records,
    seconds: float,
    workers: Workers,
) -> None:
    """Work out once what forces and damping do to the bodies of a substep level in each of its substeps of `seconds`.

    Exact terminal velocity, decay to second order, always stable.
    """
    workers.numbers[LEVEL] = substep_level
    workers.numbers[SECONDS] = seconds
    first, end = first_part(workers, PREPARE_FORCES, 0, active_bodies.shape[0])
    while first < end:
        prepare_some_forces(bodies, active_bodies[first:end], solver, substep_level, setting, seconds)
        first, end = next_part(workers, first, end)


@kernel
def prepare_some_forces(
    bodies: Records, rows: Integers, solver: SolverBodies, substep_level: int, setting: Records, seconds: float
) -> None:
    """The same for some bodies."""
    for i in rows:
        body = bodies[i]
        force = solver.forces[i]
        force.moves = SOLVED if body.type == DYNAMIC else LED
        force.by_end = 0.0
        if (
            body.type == STATIC
            or body.awake == 0
            or (body.type == DYNAMIC and solver.free_motions[i].substep_level != substep_level)
        ):
            force.moves = 0.0
            continue
        lag = 1.0 + 0.5 * seconds * body.linear_damping
        force.linear_decay = _decay(seconds * body.linear_damping)
        ax = body.gravity_scale * setting.gravity_x + body.inverse_mass * body.force_x
        ay = body.gravity_scale * setting.gravity_y + body.inverse_mass * body.force_y
        force.change_x = seconds * ax * lag
        force.change_y = seconds * ay * lag
        turn_lag = 1.0 + 0.5 * seconds * body.angular_damping
        force.angular_decay = _decay(seconds * body.angular_damping)
        aw = body.inverse_inertia * body.torque
        force.change_w = seconds * aw * turn_lag
        force.extent = body.extent


@kernel
def integrate_velocities(active_bodies: Integers, solver: SolverBodies, workers: Workers) -> None:
    """Gravity, forces and damping over one substep."""
    first, end = first_part(workers, INTEGRATE_VELOCITIES, 0, active_bodies.shape[0])
    while first < end:
        integrate_some_velocities(active_bodies[first:end], solver)
        first, end = next_part(workers, first, end)


@kernel
def integrate_some_velocities(rows: Integers, solver: SolverBodies) -> None:
    """The same for some bodies."""
    for i in rows:
        force = solver.forces[i]
        if force.moves == SOLVED:
            integrate_velocity(force, solver.free_motions[i], solver.motions[i])


@inlined_kernel
def integrate_velocity(force: Records, free_motion: Records, motion: Records) -> None:
    """The same for one body, which the solver moves."""
    free_motion.start_x = motion.velocity_x
    free_motion.start_y = motion.velocity_y
    free_motion.start_w = motion.angular_velocity
    motion.velocity_x = (motion.velocity_x + force.change_x) * force.linear_decay
    motion.velocity_y = (motion.velocity_y + force.change_y) * force.linear_decay
    motion.angular_velocity = (motion.angular_velocity + force.change_w) * force.angular_decay
    free_motion.free_x = motion.velocity_x
    free_motion.free_y = motion.velocity_y
    free_motion.free_w = motion.angular_velocity


@kernel
def _decay(x: float) -> float:
    """exp(-x) to second order, for x >= 0: never negative, so that strong damping stays stable."""
    return 1.0 / (1.0 + x + 0.5 * x * x)


@kernel
def finish_motions(bodies: Records, active_bodies: Integers, motions: Records) -> None:
    """Write the new velocities and poses into the bodies and clear the forces."""
    for i in active_bodies:
        body = bodies[i]
        if body.type == STATIC or body.awake == 0:
            continue
        motion = motions[i]
        body.velocity_x = motion.velocity_x
        body.velocity_y = motion.velocity_y
        body.angular_velocity = motion.angular_velocity
        body.center_x += motion.delta_x
        body.center_y += motion.delta_y
        if motion.delta_angle != 0.0:
            body.angle += motion.delta_angle
            body.rotation_cos, body.rotation_sin = cos_sin(body.angle)
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
