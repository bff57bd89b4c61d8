"""Impacts with restitution: the normal impulses of both points at once, then the friction that they allow."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of, pair_mass
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import friction_impulse, push, put_back, rub_of, take
from sandbox.engine.restitution.two_point_block import one_point, pair_impulses, two_points
from sandbox.tables import Records


@kernel
def strike_elastic(bodies: Records, solver: SolverBodies, contact: Records, change1: float, change2: float) -> None:
    """Apply the normal impulses that give the wanted changes (m/s), and friction at the points that they push."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    nx = contact.normal_x
    ny = contact.normal_y
    r1 = anchors_of(contact, 1)
    both = contact.point_count == 2
    block = two_points(contact, mass, r1, anchors_of(contact, 2)) if both else one_point(contact, mass, r1)
    load1, load2 = pair_impulses(block, change1, change2)
    if load1 <= 0.0 and load2 <= 0.0:
        return
    friction = contact.friction
    struck = take(solver.free_motions, contact)
    rub1 = rub_of(a, b, contact, 1)
    rub2 = rub_of(a, b, contact, 2) if both else rub1
    if load1 > 0.0:
        struck = push(struck, mass, rub1.anchors, load1 * nx, load1 * ny)
    if load2 > 0.0:
        struck = push(struck, mass, rub2.anchors, load2 * nx, load2 * ny)
    if load1 > 0.0 and friction > 0.0:
        drag = friction_impulse(struck, rub1, contact.surface_speed, friction * load1, 0.0)
        struck = push(struck, mass, rub1.anchors, drag * rub1.tangent_x, drag * rub1.tangent_y)
    if load2 > 0.0 and friction > 0.0:
        drag = friction_impulse(struck, rub2, contact.surface_speed, friction * load2, 0.0)
        struck = push(struck, mass, rub2.anchors, drag * rub2.tangent_x, drag * rub2.tangent_y)
    put_back(solver, contact, struck)
    contact.impact_impulse += load1 + load2
