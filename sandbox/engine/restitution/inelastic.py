"""Hard impacts without restitution: both points of a contact stop at once, while friction brakes what slides.

Friction turns the bodies, which changes the speeds along the normal again; so both are found in rounds, with impulses
that accumulate and never pull. A normal round is the last, so that nothing leaves that should stay.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of, relative_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import apply_friction, apply_normal_impulse, start_velocity
from sandbox.engine.restitution.two_point_block import pair_impulses
from sandbox.tables import Records

_ROUNDS = 16
_SLOW = 0.2
"""Speed (m/s) below which a point is left to the solver."""


@kernel
def speed_to_lose(gap: float, start: float, other_end: float, seconds: float) -> float:
    """Change of normal velocity (m/s) that brings a point to the touch and no farther; 0 if the solver may do it.

    Within the coming substep it may close its `gap` (m); `other_end` is what would be left of that. When `seconds` are
    negative it has gone, and stops where it is near the touch.
    """
    near = gap <= _SLOW * abs(seconds)
    if other_end > 0.0 if seconds > 0.0 else not near:
        return 0.0
    speed = -gap / seconds if seconds > 0.0 and gap > 0.0 else 0.0
    return float(speed - start) if speed - start > _SLOW else 0.0


@kernel
def stop_inelastic(bodies: Records, solver: SolverBodies, contact: Records, change1: float, change2: float) -> None:
    """Apply the normal impulses that give the wanted changes, and the friction that belongs to them."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    load1 = load2 = drag1 = drag2 = 0.0
    for turn in range(_ROUNDS):
        new1, new2 = pair_impulses(a, b, contact, change1, change2)
        apply_normal_impulse(bodies, solver, contact, new1 - load1, 1)
        apply_normal_impulse(bodies, solver, contact, new2 - load2, 2)
        load1 = new1
        load2 = new2
        if contact.friction <= 0.0 or turn == _ROUNDS - 1:
            break
        before1 = _normal_speed(solver.free_motions, contact, 1)
        before2 = _normal_speed(solver.free_motions, contact, 2)
        drag1 = apply_friction(bodies, solver, contact, load1, drag1, 1)
        drag2 = apply_friction(bodies, solver, contact, load2, drag2, 2)
        if change1 > 0.0:
            change1 += before1 - _normal_speed(solver.free_motions, contact, 1)
        if change2 > 0.0:
            change2 += before2 - _normal_speed(solver.free_motions, contact, 2)
    contact.impact_impulse += load1 + load2


@kernel
def _normal_speed(free_motions: Records, contact: Records, point: int) -> float:
    """Speed (m/s) at which a point of b leaves that of a."""
    x, y = relative_velocity(start_velocity(free_motions, contact), anchors_of(contact, point))
    return float(x * contact.normal_x + y * contact.normal_y)
