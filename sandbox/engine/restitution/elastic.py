"""Impacts with restitution: the normal impulses of both points at once, with the friction that they allow."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import PairMass, pair_mass
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import Rub, Struck, push, push_points, put_back, rub_of, take
from sandbox.engine.restitution.rough_block import RoughLoads, rough_loads, rough_matrix
from sandbox.engine.restitution.rough_blow import rough_blow, rub_matrix
from sandbox.engine.restitution.two_point_block import block_of, pair_impulses
from sandbox.tables import Records


@kernel
def strike_elastic(bodies: Records, solver: SolverBodies, contact: Records, change1: float, change2: float) -> None:
    """Apply the normal impulses that give the wanted changes (m/s), and friction at the points that they push."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    struck = take(solver.free_motions, contact)
    block = block_of(contact, mass)
    load1, load2 = pair_impulses(block, change1, change2)
    if load1 <= 0.0 and load2 <= 0.0:
        return
    rub = rub_of(a, b, contact, load1, load2)
    if contact.friction > 0.0 and change1 > 0.0 and change2 > 0.0:
        loads = rough_loads(struck.start, contact, rub, rough_matrix(contact, mass, rub), change1, change2)
        if loads.first > 0.0 and loads.second > 0.0:
            _strike(solver, contact, struck, mass, rub, loads)
            return
        if loads.first > 0.0 or loads.second > 0.0:  # friction tips it over one point
            load1 = block.mass1 * change1 if loads.first > 0.0 else 0.0
            load2 = block.mass2 * change2 if loads.second > 0.0 else 0.0
            rub = rub_of(a, b, contact, load1, load2)
    scale = 1.0
    drag = 0.0
    if contact.friction > 0.0:
        blow = rough_blow(struck.start, contact, rub, rub_matrix(contact, mass, rub), load1 + load2)
        scale = blow.scale
        drag = blow.tangent
    _strike(solver, contact, struck, mass, rub, RoughLoads(scale * load1, scale * load2, drag))


@inlined_kernel
def _strike(
    solver: SolverBodies, contact: Records, struck: Struck, mass: PairMass, rub: Rub, loads: RoughLoads
) -> None:
    """Apply impulses to the bodies of a contact."""
    struck = push(struck, mass, rub.anchors, loads.drag * rub.tangent_x, loads.drag * rub.tangent_y)
    put_back(solver, contact, push_points(struck, contact, mass, loads.first, loads.second))
    contact.impact_impulse += loads.first + loads.second
