"""Stages: velocities from forces, positions from velocities, and the new poses at the end of a step."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC, STATIC

SOLVED, LED = 1, 2
"""`pull.moves` of the bodies that the solver moves, and of those that follow a velocity of their own."""


@kernel
def begin_motions(bodies: Records, movers: Integers, motions: Records, flights: Records) -> float:
    """Load the velocities; nothing has moved yet, and nothing is known to hinder anybody.

    Returns the square of the highest speed (m/s) of a point of any body.
    """
    fastest = 0.0
    for i in movers:
        body = bodies[i]
        motion = motions[i]
        motion.velocity_x = body.velocity_x
        motion.velocity_y = body.velocity_y
        motion.angular_velocity = body.angular_velocity
        motion.delta_x = 0.0
        motion.delta_y = 0.0
        motion.delta_cos = 1.0
        motion.delta_sin = 0.0
        motion.delta_angle = 0.0
        body.posed = 0
        flight = flights[i]
        flight.start_x = flight.free_x = body.velocity_x
        flight.start_y = flight.free_y = body.velocity_y
        flight.start_w = flight.free_w = body.angular_velocity
        rim = body.angular_velocity * body.extent
        square = body.velocity_x * body.velocity_x + body.velocity_y * body.velocity_y + rim * rim
        fastest = square if square > fastest else fastest
    return fastest


@kernel
def rewind_driven(bodies: Records, movers: Integers, motions: Records) -> None:
    """Put kinematic bodies back to where the step began, for the islands of the next pace."""
    for i in movers:
        if bodies[i].type == KINEMATIC:
            motion = motions[i]
            motion.delta_x = 0.0
            motion.delta_y = 0.0
            motion.delta_cos = 1.0
            motion.delta_sin = 0.0
            motion.delta_angle = 0.0


@kernel
def begin_pulls(
    bodies: Records,
    movers: Integers,
    flights: Records,
    pulls: Records,
    pace: int,
    gravity_x: float,
    gravity_y: float,
    seconds: float,
) -> None:
    """Work out once what forces and damping do to the bodies of a pace in each of its substeps of `seconds`.

    Exact terminal velocity, decay to second order, always stable.
    """
    for i in movers:
        body = bodies[i]
        pull = pulls[i]
        pull.moves = SOLVED if body.type == DYNAMIC else LED
        if body.type == STATIC or body.awake == 0 or (body.type == DYNAMIC and flights[i].pace != pace):
            pull.moves = 0
            continue
        lag = 1.0 + 0.5 * seconds * body.linear_damping
        pull.slow = _decay(seconds * body.linear_damping)
        ax = body.gravity_scale * gravity_x + body.inverse_mass * body.force_x
        ay = body.gravity_scale * gravity_y + body.inverse_mass * body.force_y
        pull.push_x = seconds * ax * lag
        pull.push_y = seconds * ay * lag
        turn_lag = 1.0 + 0.5 * seconds * body.angular_damping
        pull.brake = _decay(seconds * body.angular_damping)
        aw = body.inverse_inertia * body.torque
        pull.push_w = seconds * aw * turn_lag
        pull.extent = body.extent


@kernel
def integrate_velocities(movers: Integers, motions: Records, flights: Records, pulls: Records) -> None:
    """Gravity, forces and damping over one substep."""
    for i in movers:
        pull = pulls[i]
        if pull.moves != SOLVED:
            continue
        flight = flights[i]
        motion = motions[i]
        flight.start_x = motion.velocity_x
        flight.start_y = motion.velocity_y
        flight.start_w = motion.angular_velocity
        motion.velocity_x = (motion.velocity_x + pull.push_x) * pull.slow
        motion.velocity_y = (motion.velocity_y + pull.push_y) * pull.slow
        motion.angular_velocity = (motion.angular_velocity + pull.push_w) * pull.brake
        flight.free_x = motion.velocity_x
        flight.free_y = motion.velocity_y
        flight.free_w = motion.angular_velocity


@kernel
def _decay(x: float) -> float:
    """exp(-x) to second order, for x >= 0: never negative, so that strong damping stays stable."""
    return 1.0 / (1.0 + x + 0.5 * x * x)


@kernel
def integrate_positions(
    movers: Integers, motions: Records, flights: Records, pulls: Records, gravity: float, seconds: float
) -> None:
    """Move by the velocity the solver left; a body that nothing touched moves by the mean of both ends.

    The mean is exact under constant acceleration, so free flight follows the parabola to rounding. A body in
    contact keeps the direction of its end velocity, which is what the solver made safe, but where it is only slowed
    or sped up, by no more than forces do (`gravity` in m/s^2 is the measure), it goes the mean way along it.
    """
    gentle = 4.0 * seconds * gravity
    for i in movers:
        pull = pulls[i]
        if pull.moves == 0:
            continue
        flight = flights[i]
        motion = motions[i]
        vx = motion.velocity_x
        vy = motion.velocity_y
        w = motion.angular_velocity
        if pull.moves == SOLVED and vx == flight.free_x and vy == flight.free_y and w == flight.free_w:
            vx = 0.5 * (flight.start_x + vx)
            vy = 0.5 * (flight.start_y + vy)
            w = 0.5 * (flight.start_w + w)
        elif pull.moves == SOLVED:
            share = _mean_share(flight.start_x - vx, flight.start_y - vy, vx, vy, gentle)
            vx = vx * share
            vy = vy * share
            change = flight.start_w - w
            if abs(change) * pull.extent <= gentle and abs(change) <= 0.5 * abs(w):
                w = w + 0.5 * change
        motion.delta_x += seconds * vx
        motion.delta_y += seconds * vy
        if w != 0.0:
            motion.delta_angle += seconds * w
            motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)


@kernel
def _mean_share(change_x: float, change_y: float, vx: float, vy: float, gentle: float) -> float:
    """Factor that turns the end velocity into the mean velocity along it; 1 after a change that is not gentle."""
    change = change_x * change_x + change_y * change_y
    square = vx * vx + vy * vy
    if change > gentle * gentle or change > 0.25 * square or square == 0.0:
        return 1.0
    return 1.0 + 0.5 * (change_x * vx + change_y * vy) / square


@kernel
def finish_motions(bodies: Records, movers: Integers, motions: Records) -> None:
    """Write the new velocities and poses into the bodies and clear the forces."""
    for i in movers:
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
