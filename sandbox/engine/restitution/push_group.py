"""The impulses that were found for what strikes together become part of the velocities, and are reported."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import pair_mass
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import push, push_points, put_back, rub_between, take
from sandbox.engine.restitution.jointed.give import give
from sandbox.engine.restitution.jointed.reach import Reach
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records


@kernel
def push_group(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, reach: Reach | None
) -> float:
    """Apply loads and friction of the contacts linked from the `first` one on; returns the share that was applied: of
    jointed bodies as much as leaves them no more energy than they had."""
    share = 1.0
    if reach is not None:
        share = give(bodies, solver, contacts, impacts, first, reach)
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        if reach is None:
            _push(bodies, solver, contact, row)
        contact.impact_impulse += share * (row.load1 + row.load2)
        k = row.next
    return share


@kernel
def _push(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> None:
    """Apply what was found for a contact."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    struck = push_points(take(solver.free_motions, contact), contact, mass, row.load1, row.load2)
    if row.drag != 0.0:
        rub = rub_between(a, b, contact)
        struck = push(struck, mass, rub.anchors, row.drag * rub.tangent_x, row.drag * rub.tangent_y)
    put_back(solver, contact, struck)
