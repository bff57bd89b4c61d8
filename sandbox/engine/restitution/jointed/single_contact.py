"""Friction within the blow at a single contact of jointed bodies: the path of the impulse is that of free bodies.

Only what an impulse does is another, as joints pass it on: the contact has another matrix.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import pair_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between
from sandbox.engine.restitution.jointed.delassus import TANGENT, WIDE
from sandbox.engine.restitution.jointed.reach import Reach, begin_pushes, reach_stops
from sandbox.engine.restitution.push_group import push_group
from sandbox.engine.restitution.rough_blow import RubMatrix, rough_blow
from sandbox.tables import Records

_REGULAR = 1e-9
"""What hangs on a pivot moves along one line only, and sticks to it when it has stopped: a matrix that is singular."""


@kernel
def strike_rough_jointed(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, k: int, reach: Reach
) -> None:
    """Apply the blow at impact k, of one point, whose group it is, with the friction that it allows. In: its load
    without any, and the matrix. Stops that hold hold all the while."""
    row = impacts.rows[k]
    contact = contacts[impacts.slots[k].contact]
    if row.load1 <= 0.0:
        return
    m = reach.work.direct.delassus
    matrix = RubMatrix(m[0], m[TANGENT], (1.0 + _REGULAR) * m[TANGENT * WIDE + TANGENT])
    begin_pushes(bodies, solver, impacts, k, reach)
    reach_stops(solver, reach)
    start = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    blow = rough_blow(
        start, contact, rub_between(bodies[contact.body_a], bodies[contact.body_b], contact), matrix, row.load1
    )
    row.load1 *= blow.scale
    row.drag = blow.tangent
    push_group(bodies, solver, contacts, impacts, k, reach)
