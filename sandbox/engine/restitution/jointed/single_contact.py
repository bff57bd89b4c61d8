"""Friction within the blow at a single contact of jointed bodies: the path of the impulse is that of free bodies.

Only what an impulse does is another, as joints pass it on: the contact has another matrix, and closes as fast as stops
that hold let it without any impulse. Which do is guessed, as without friction (`loads.py`).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between
from sandbox.engine.restitution.jointed.delassus import TANGENT, WIDE, fill_matrix, note_speeds
from sandbox.engine.restitution.jointed.give import push_loads
from sandbox.engine.restitution.jointed.loads import IMMOVABLE, MOST_GUESSES
from sandbox.engine.restitution.jointed.reach import Reach, begin_pushes, holds_matrix, reach_stops, work_left
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
    without any, and the matrix."""
    if impacts.rows[k].load1 <= 0.0:
        return
    for _ in range(MOST_GUESSES):
        _find_blow(bodies, solver, contacts, impacts, k, reach)
        push_loads(bodies, solver, contacts, impacts, k, 1.0, reach)
        if holds_matrix(reach) or work_left(reach) <= 0:
            break
        begin_pushes(bodies, solver, impacts, k, reach)
        note_speeds(bodies, solver, contacts, impacts, k)
        fill_matrix(bodies, solver, contacts, impacts, k, reach)
    push_group(bodies, solver, contacts, impacts, k, reach)


@kernel
def _find_blow(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, k: int, reach: Reach
) -> None:
    """Find load and friction with the stops that hold, which hold all the while."""
    row = impacts.rows[k]
    contact = contacts[impacts.slots[k].contact]
    m = reach.work.direct.delassus
    matrix = RubMatrix(m[0], m[TANGENT], (1.0 + _REGULAR) * m[TANGENT * WIDE + TANGENT])
    begin_pushes(bodies, solver, impacts, k, reach)
    reach_stops(solver, reach)
    start = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    asked = row.rebound1 - opening_speed(start, contact, 1)
    least = IMMOVABLE * (bodies[contact.body_a].inverse_mass + bodies[contact.body_b].inverse_mass)
    row.load1 = row.drag = 0.0
    if asked > 0.0 and matrix.nn > least:
        rub = rub_between(bodies[contact.body_a], bodies[contact.body_b], contact)
        load = asked / matrix.nn
        blow = rough_blow(start, contact, rub, matrix, load)
        row.load1 = blow.scale * load
        row.drag = blow.tangent
