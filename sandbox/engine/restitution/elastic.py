"""Impacts with restitution: the normal impulses of both points at once, with the friction that they allow."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import pair_mass
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import push, push_points, put_back, rub_of, take
from sandbox.engine.restitution.rough_blow import rough_blow, rub_matrix
from sandbox.engine.restitution.two_point_block import block_of, pair_impulses
from sandbox.tables import Records


@kernel
def strike_elastic(bodies: Records, solver: SolverBodies, contact: Records, change1: float, change2: float) -> None:
    """Apply the normal impulses that give the wanted changes (m/s), and friction at the points that they push."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    load1, load2 = pair_impulses(block_of(contact, mass), change1, change2)
    if load1 <= 0.0 and load2 <= 0.0:
        return
    struck = take(solver.free_motions, contact)
    if contact.friction > 0.0:
        rub = rub_of(bodies[contact.body_a], bodies[contact.body_b], contact, load1, load2)
        blow = rough_blow(struck.start, contact, rub, rub_matrix(contact, mass, rub), load1 + load2)
        load1 *= blow.scale
        load2 *= blow.scale
        struck = push(struck, mass, rub.anchors, blow.tangent * rub.tangent_x, blow.tangent * rub.tangent_y)
    put_back(solver, contact, push_points(struck, contact, mass, load1, load2))
    contact.impact_impulse += load1 + load2
