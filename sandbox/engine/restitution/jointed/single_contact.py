"""Friction within the blow at a single contact of jointed bodies: the path of the impulse is that of free bodies.

Only what an impulse does is another, as joints pass it on; that is found by pushing along both axes.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import (
    apply_impulse,
    pair_mass,
    pair_velocity,
    relative_velocity,
    start_velocity,
)
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import Rub, rub_of
from sandbox.engine.restitution.jointed.give import give
from sandbox.engine.restitution.jointed.reach import Reach, begin_pushes, pass_on
from sandbox.engine.restitution.rough_blow import RubMatrix, rough_blow
from sandbox.engine.restitution.solve_group import set_velocity
from sandbox.tables import Records

_REGULAR = 1e-9
"""What hangs on a pivot moves along one line only, and sticks to it when it has stopped: a matrix that is singular."""


class _Change(NamedTuple):
    """What a push changes the speeds (m/s) along normal and tangent."""

    normal: float
    tangent: float


@kernel
def strike_rough_jointed(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, k: int, reach: Reach
) -> None:
    """Apply the blow at impact k, whose group it is, with the friction that it allows. In: its loads without any."""
    row = impacts.rows[k]
    contact = contacts[impacts.slots[k].contact]
    load = row.load1 + row.load2
    if load <= 0.0:
        return
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    rub = rub_of(a, b, contact, row.load1, row.load2)
    pushed = _push(bodies, solver, contact, impacts, k, reach, rub, contact.normal_x, contact.normal_y)
    rubbed = _push(bodies, solver, contact, impacts, k, reach, rub, rub.tangent_x, rub.tangent_y)
    start = start_velocity(solver.free_motions, contact)
    matrix = RubMatrix(pushed.normal, rubbed.normal, (1.0 + _REGULAR) * rubbed.tangent)
    blow = rough_blow(start, contact, rub, matrix, load)
    row.load1 *= blow.scale
    row.load2 *= blow.scale
    row.drag = blow.tangent
    share = give(bodies, solver, contacts, impacts, k, 1.0, 0.0, reach).share
    contact.impact_impulse += share * blow.scale * load


@kernel
def _push(
    bodies: Records,
    solver: SolverBodies,
    contact: Records,
    impacts: ImpactList,
    k: int,
    reach: Reach,
    rub: Rub,
    x: float,
    y: float,
) -> _Change:
    """What an impulse along (x, y) where the contact rubs, of as many N s as its bodies have kg, changes there for each
    N s."""
    begin_pushes(bodies, solver, impacts, k, reach)
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    size = 1.0 / (mass.mass_a + mass.mass_b)
    start = start_velocity(solver.free_motions, contact)
    set_velocity(solver.motions, contact, apply_impulse(start, mass, rub.anchors, size * x, size * y))
    pass_on(solver, reach)
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    before_x, before_y = relative_velocity(start, rub.anchors)
    now_x, now_y = relative_velocity(now, rub.anchors)
    vx = (now_x - before_x) / size
    vy = (now_y - before_y) / size
    return _Change(vx * contact.normal_x + vy * contact.normal_y, vx * rub.tangent_x + vy * rub.tangent_y)
