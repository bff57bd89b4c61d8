"""Stage: mouse joints pull grabbed points toward their targets, softly and with a force limit."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import Anchors, PairMass, velocity_change
from sandbox.engine.contact_solver.soft_constraint import soft_coefficients, substep_share
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC


@kernel
def solve_mouse_joints(state: StateTables, solver: SolverBodies, substep_level: int, seconds: float) -> bool:
    """Warm start and solve every mouse joint on bodies of a substep level once; whether there are any."""
    some = False
    for k in range(state.drags.shape[0]):
        drag = state.drags[k]
        if drag.body < 0 or state.bodies[drag.body].type != DYNAMIC:
            continue
        if solver.free_motions[drag.body].substep_level == substep_level:
            share = substep_share(substep_level)
            _solve(state.bodies[drag.body], solver.motions[drag.body], drag, seconds, share)
            some = True
    return some


@kernel
def _solve(body: Records, motion: Records, drag: Records, seconds: float, share: float) -> None:
    """The same for one; a substep takes that `share` of one of level 0, as of which its impulse is kept."""
    c = body.rotation_cos * motion.delta_cos - body.rotation_sin * motion.delta_sin
    s = body.rotation_sin * motion.delta_cos + body.rotation_cos * motion.delta_sin
    rx = c * drag.local_x - s * drag.local_y
    ry = s * drag.local_x + c * drag.local_y
    old_x = share * drag.impulse_x
    old_y = share * drag.impulse_y
    _apply(body, motion, rx, ry, old_x, old_y)
    bias_rate, mass_scale, impulse_scale = soft_coefficients(drag.hertz, drag.damping_ratio, seconds)
    error_x = body.center_x + motion.delta_x + rx - drag.target_x
    error_y = body.center_y + motion.delta_y + ry - drag.target_y
    speed_x = motion.velocity_x - motion.angular_velocity * ry + bias_rate * error_x
    speed_y = motion.velocity_y + motion.angular_velocity * rx + bias_rate * error_y
    k11 = body.inverse_mass + body.inverse_inertia * ry * ry
    k12 = -body.inverse_inertia * rx * ry
    k22 = body.inverse_mass + body.inverse_inertia * rx * rx
    determinant = k11 * k22 - k12 * k12
    if determinant <= 0.0:
        return
    new_x = old_x - mass_scale * (k22 * speed_x - k12 * speed_y) / determinant - impulse_scale * old_x
    new_y = old_y - mass_scale * (k11 * speed_y - k12 * speed_x) / determinant - impulse_scale * old_y
    limit = seconds * drag.max_force
    size = math.sqrt(new_x * new_x + new_y * new_y)
    if size > limit:
        new_x = new_x * (limit / size)
        new_y = new_y * (limit / size)
    drag.impulse_x = new_x / share
    drag.impulse_y = new_y / share
    _apply(body, motion, rx, ry, new_x - old_x, new_y - old_y)


@kernel
def _apply(body: Records, motion: Records, rx: float, ry: float, px: float, py: float) -> None:
    mass = PairMass(0.0, 0.0, body.inverse_mass, body.inverse_inertia)
    change = velocity_change(mass, Anchors(0.0, 0.0, rx, ry), px, py)
    motion.velocity_x += change.bx
    motion.velocity_y += change.by
    motion.angular_velocity += change.bw
