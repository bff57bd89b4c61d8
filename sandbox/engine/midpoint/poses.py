"""Bodies where their velocities take them in half a step.

There is where the step looks at them, so what they move is measured from there: where the step begins, it is half a
step back. Whoever adds what a body has moved to where it is gets the same place as without.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import AHEAD
from sandbox.engine.contact_solver.gather import PairPose
from sandbox.engine.records.bodies import SolverBodies
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records
from sandbox.world.records import KINEMATIC


@kernel
def put_ahead(bodies: Records, rows: Integers, solver: SolverBodies, seconds: float) -> None:
    """Put those that are to be `AHEAD` there, `seconds` after the beginning of the step."""
    for i in rows:
        if solver.flags[i] & AHEAD:
            body = bodies[i]
            motion = solver.motions[i]
            _measure_from(body, motion, seconds)
            body.center_x -= motion.delta_x
            body.center_y -= motion.delta_y
            body.angle -= motion.delta_angle
            c = body.rotation_cos
            s = body.rotation_sin
            body.rotation_cos = c * motion.delta_cos + s * motion.delta_sin
            body.rotation_sin = s * motion.delta_cos - c * motion.delta_sin


@kernel
def put_back(body: Records, motion: Records, seconds: float) -> None:
    """Put one of them back to where the step began, and measure from there what it has moved. Its rotation follows
    when that is added."""
    x = seconds * body.velocity_x
    y = seconds * body.velocity_y
    angle = seconds * body.angular_velocity
    body.center_x -= x
    body.center_y -= y
    begun: float = body.angle - angle
    body.angle = begun
    motion.delta_x += x
    motion.delta_y += y
    motion.delta_angle += angle
    if motion.delta_angle == 0.0:
        body.rotation_cos, body.rotation_sin = cos_sin(begun)


@kernel
def rewind_driven(bodies: Records, rows: Integers, solver: SolverBodies, seconds: float) -> None:
    """Put kinematic bodies back to where the step began, for the islands of the next substep level; those that are
    `AHEAD` are so by `seconds`."""
    for i in rows:
        if bodies[i].type == KINEMATIC:
            _measure_from(bodies[i], solver.motions[i], seconds if solver.flags[i] & AHEAD else 0.0)


@inlined_kernel
def _measure_from(body: Records, motion: Records, seconds: float) -> None:
    """Let a body be where the step begins, measured from where it is so many seconds later."""
    x, y, cos, sin = _way(body, seconds)
    motion.delta_x = -x
    motion.delta_y = -y
    motion.delta_angle = -seconds * body.angular_velocity
    motion.delta_cos = cos
    motion.delta_sin = -sin


@inlined_kernel
def pair_way(bodies: Records, flags: Integers, a: int, b: int, seconds: float) -> PairPose:
    """How far two bodies move in so many seconds at the velocities with which the step began, if they are `AHEAD`."""
    x_a, y_a, cos_a, sin_a = _way(bodies[a], seconds if flags[a] & AHEAD else 0.0)
    x_b, y_b, cos_b, sin_b = _way(bodies[b], seconds if flags[b] & AHEAD else 0.0)
    return PairPose(x_b - x_a, y_b - y_a, cos_a, sin_a, cos_b, sin_b)


@inlined_kernel
def _way(body: Records, seconds: float) -> tuple[float, float, float, float]:
    """How far a body moves, and cosine and sine of the angle by which it turns."""
    angle: float = seconds * body.angular_velocity
    cos, sin = cos_sin(angle)
    return float(seconds * body.velocity_x), float(seconds * body.velocity_y), cos, sin
