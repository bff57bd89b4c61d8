"""Impacts with restitution: the normal impulses of both points at once, then the friction that they allow."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of, pair_mass
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import friction_impulse, push, push_points, put_back, rub_of, take
from sandbox.engine.restitution.two_point_block import one_point, pair_impulses, two_points
from sandbox.tables import Records


@kernel
def strike_elastic(bodies: Records, solver: SolverBodies, contact: Records, change1: float, change2: float) -> None:
    """Apply the normal impulses that give the wanted changes (m/s), and friction at the points that they push."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    r1 = anchors_of(contact, 1)
    both = contact.point_count == 2
    block = two_points(contact, mass, r1, anchors_of(contact, 2)) if both else one_point(contact, mass, r1)
    load1, load2 = pair_impulses(block, change1, change2)
    if load1 <= 0.0 and load2 <= 0.0:
        return
    struck = push_points(take(solver.free_motions, contact), contact, mass, load1, load2)
    if contact.friction > 0.0:
        rub = rub_of(a, b, contact, load1, load2)
        drag = friction_impulse(struck, rub, contact.surface_speed, contact.friction * (load1 + load2), 0.0)
        struck = push(struck, mass, rub.anchors, drag * rub.tangent_x, drag * rub.tangent_y)
    put_back(solver, contact, struck)
    contact.impact_impulse += load1 + load2
