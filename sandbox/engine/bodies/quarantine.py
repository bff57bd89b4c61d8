"""Stage: a body with bad numbers is frozen where it last was sound, so that it cannot poison the world.

Only its own numbers freeze a body: its velocity and the forces on it, before anything is solved with them, and where it
would go. What contacts and joints make too fast is slowed down to the highest speed.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import GUARD_VELOCITIES
from sandbox.tables import Integers, Records
from sandbox.world.records import STATIC

MAX_SPEED = 1e7
"""Units of length, or radians, a second past which a velocity counts as broken."""
MAX_COORDINATE = 1e9
"""Units of length from the origin past which a body counts as lost."""


@inlined_kernel
def guard_forces(body: Records, setting: Records, active_info: Records, step_count: int) -> bool:
    """Freeze a body that its own velocity and the forces on it would make too fast within a step; returns whether.

    It comes before contacts and joints look at masses, so that to them such a body is one that does not move.
    """
    if body.type == STATIC:
        return False
    seconds = setting.step_seconds
    linear = MAX_SPEED * (1.0 + seconds * body.linear_damping)
    angular = MAX_SPEED * (1.0 + seconds * body.angular_damping)
    ax = body.gravity_scale * setting.gravity_x + body.inverse_mass * body.force_x
    ay = body.gravity_scale * setting.gravity_y + body.inverse_mass * body.force_y
    aw = body.inverse_inertia * body.torque
    sound = (abs(body.velocity_x + seconds * ax) <= linear) & (abs(body.velocity_y + seconds * ay) <= linear)
    if sound & (abs(body.angular_velocity + seconds * aw) <= angular):
        return False
    active_info[0].stale = 1
    _freeze(body, step_count)
    return True


@kernel
def guard_velocities(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int, workers: Workers
) -> int:
    """Slow down what the solver made too fast, before it can pass that on, and freeze what has no velocity at all.

    Returns how many this worker has frozen.
    """
    frozen = 0
    first, end = first_part(workers, GUARD_VELOCITIES, 0, rows.shape[0])
    while first < end:
        frozen += guard_some_velocities(bodies, rows[first:end], solver, active_info, step_count)
        first, end = next_part(workers, first, end)
    return frozen


@kernel
def guard_some_velocities(
    bodies: Records, rows: Integers, solver: SolverBodies, active_info: Records, step_count: int
) -> int:
    """The same for some bodies."""
    frozen = 0
    for i in rows:
        motion = solver.motions[i]
        if is_slow(motion.velocity_x, motion.velocity_y, motion.angular_velocity):
            continue
        force = solver.forces[i]
        if force.moves > 0.0 and not slowed(motion):
            freeze_in_step(bodies[i], motion, force, active_info, step_count)
            frozen += 1
    return frozen


@inlined_kernel
def is_slow(vx: float, vy: float, w: float) -> bool:
    """Whether velocities are numbers within `MAX_SPEED`."""
    return bool((abs(vx) <= MAX_SPEED) & (abs(vy) <= MAX_SPEED) & (abs(w) <= MAX_SPEED))


@kernel
def freeze_in_step(body: Records, motion: Records, force: Records, active_info: Records, step_count: int) -> None:
    """Freeze a body whose velocity is not a number, at the pose it had when the step began."""
    active_info[0].stale = 1
    _freeze(body, step_count)
    _stop(motion)
    force.moves = 0.0


@inlined_kernel
def guard_position(body: Records, motion: Records, active_info: Records, step_count: int) -> bool:
    """Freeze a body that would leave the world, or whose motion is not a number, before it is moved; returns
    whether."""
    if body.type == STATIC:
        return False
    x = abs(body.center_x + motion.delta_x)
    y = abs(body.center_y + motion.delta_y)
    turned = abs(body.angle + motion.delta_angle)
    inside = (x <= MAX_COORDINATE) & (y <= MAX_COORDINATE) & (turned <= MAX_COORDINATE)
    if inside and (is_slow(motion.velocity_x, motion.velocity_y, motion.angular_velocity) or slowed(motion)):
        return False
    active_info[0].stale = 1
    _freeze(body, step_count)
    _stop(motion)
    return True


@inlined_kernel
def slowed(motion: Records) -> bool:
    """Keep velocities within `MAX_SPEED`; whether they are numbers."""
    motion.velocity_x = _within(motion.velocity_x)
    motion.velocity_y = _within(motion.velocity_y)
    motion.angular_velocity = _within(motion.angular_velocity)
    speed = abs(motion.velocity_x) + abs(motion.velocity_y) + abs(motion.angular_velocity)
    return bool(speed <= 3.0 * MAX_SPEED)


@inlined_kernel
def _within(speed: float) -> float:
    """What is not a number stays so."""
    if speed > MAX_SPEED:
        return MAX_SPEED
    return -MAX_SPEED if speed < -MAX_SPEED else speed


@kernel
def _freeze(body: Records, step_count: int) -> None:
    """Make a body static at the pose from which the step measures what it moves."""
    body.type = STATIC
    body.frozen_step = step_count
    body.awake = 1
    body.velocity_x = 0.0
    body.velocity_y = 0.0
    body.angular_velocity = 0.0
    body.inverse_mass = 0.0
    body.inverse_inertia = 0.0
    body.force_x = 0.0
    body.force_y = 0.0
    body.torque = 0.0


@kernel
def _stop(motion: Records) -> None:
    """Take back what a body has moved in this step."""
    motion.velocity_x = 0.0
    motion.velocity_y = 0.0
    motion.angular_velocity = 0.0
    motion.delta_x = 0.0
    motion.delta_y = 0.0
    motion.delta_cos = 1.0
    motion.delta_sin = 0.0
    motion.delta_angle = 0.0
