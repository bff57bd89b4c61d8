"""Hard impacts without restitution: both points of a contact stop at once, while friction brakes what slides.

Friction turns the bodies, which changes the speeds along the normal again; so both are found in rounds, with impulses
that accumulate and never pull. A normal round is the last, so that nothing leaves that should stay.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import Anchors, anchors_of, pair_mass, relative_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import Struck, friction_impulse, push, put_back, rub_of, take
from sandbox.engine.restitution.two_point_block import one_point, pair_impulses, two_points
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
    """Apply the normal impulses that give the wanted changes, and the friction that belongs to them.

    A round that changes no impulse is the last: the next ones would not either.
    """
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    nx = contact.normal_x
    ny = contact.normal_y
    r1 = anchors_of(contact, 1)
    r2 = anchors_of(contact, 2)
    block = two_points(contact, mass, r1, r2) if contact.point_count == 2 else one_point(contact, mass, r1)
    rub1 = rub_of(a, b, contact, 1)
    rub2 = rub_of(a, b, contact, 2)
    friction = contact.friction
    surface_speed = contact.surface_speed
    struck = take(solver.free_motions, contact)
    load1 = load2 = drag1 = drag2 = 0.0
    for turn in range(_ROUNDS):
        new1, new2 = pair_impulses(block, change1, change2)
        same = new1 == load1 and new2 == load2
        impulse = new1 - load1
        struck = push(struck, mass, rub1.anchors, impulse * nx, impulse * ny)
        impulse = new2 - load2
        struck = push(struck, mass, rub2.anchors, impulse * nx, impulse * ny)
        load1 = new1
        load2 = new2
        if friction <= 0.0 or turn == _ROUNDS - 1:
            break
        before1 = _normal_speed(struck, r1, nx, ny)
        before2 = _normal_speed(struck, r2, nx, ny)
        new1 = friction_impulse(struck, rub1, surface_speed, friction * load1, drag1)
        impulse = new1 - drag1
        struck = push(struck, mass, rub1.anchors, impulse * rub1.tangent_x, impulse * rub1.tangent_y)
        new2 = friction_impulse(struck, rub2, surface_speed, friction * load2, drag2)
        impulse = new2 - drag2
        struck = push(struck, mass, rub2.anchors, impulse * rub2.tangent_x, impulse * rub2.tangent_y)
        if same and new1 == drag1 and new2 == drag2:
            break
        drag1 = new1
        drag2 = new2
        if change1 > 0.0:
            change1 += before1 - _normal_speed(struck, r1, nx, ny)
        if change2 > 0.0:
            change2 += before2 - _normal_speed(struck, r2, nx, ny)
    put_back(solver, contact, struck)
    contact.impact_impulse += load1 + load2


@inlined_kernel
def _normal_speed(struck: Struck, r: Anchors, nx: float, ny: float) -> float:
    """Speed (m/s) at which a point of b leaves that of a."""
    x, y = relative_velocity(struck.start, r)
    return float(x * nx + y * ny)
