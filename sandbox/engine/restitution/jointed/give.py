"""Impulses of impacts on jointed bodies, as large a share of them as leaves no more energy than it may.

How jointed bodies answer to a push is not even in it, as stops may give way to one part of it and not to another. But
the kinetic energy after a share is convex in it, as that of any projection onto what joints allow is; so a share that
leaves too much is replaced by where a parabola through what is known of it would leave as much as it may.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import apply_impulse, pair_mass, pair_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between, slip_speed
from sandbox.engine.restitution.jointed.reach import Reach, begin_pushes, energy_in_motions, pass_on, take_over
from sandbox.engine.restitution.solve_group import push_motions, set_velocity
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_TRIES = 8
_ROUNDING = 1e-12
"""Share of the energy that may come of rounding."""


@kernel
def push_loads(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    share: float,
    reach: Reach,
) -> None:
    """Pass on a share of loads and friction, in `solver.motions`, of the group that is linked from impact `first`
    on."""
    begin_pushes(bodies, solver, impacts, first, reach)
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        a = bodies[contact.body_a]
        b = bodies[contact.body_b]
        mass = pair_mass(a, b)
        if row.drag != 0.0:
            rub = rub_between(a, b, contact)
            now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
            x = share * row.drag * rub.tangent_x
            y = share * row.drag * rub.tangent_y
            set_velocity(solver.motions, contact, apply_impulse(now, mass, rub.anchors, x, y))
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        push_motions(solver, contact, mass, now, share * row.load1, share * row.load2)
        k = row.next
    pass_on(solver, reach)


@kernel
def give(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, reach: Reach
) -> float:
    """Give loads and friction, or the share of them that does no more work than surfaces that move do; returns the
    share."""
    begin_pushes(bodies, solver, impacts, first, reach)
    before = energy_in_motions(bodies, solver, impacts, first, reach)
    power = _power(bodies, solver, contacts, impacts, first)
    most = _work_of_surfaces(contacts, impacts, first) + _ROUNDING * before
    share = 1.0
    for _ in range(_TRIES):
        push_loads(bodies, solver, contacts, impacts, first, share, reach)
        work = energy_in_motions(bodies, solver, impacts, first, reach) - before
        if work <= most:
            take_over(bodies, solver, impacts, first, reach)
            return share
        share = _smaller(share, work, power, most)
    return 0.0


@inlined_kernel
def _smaller(share: float, work: float, power: float, most: float) -> float:
    """Where the work p s + q s^2, with the power p, which is `work` at the `share`, comes to `most`."""
    q = (work - power * share) / (share * share)
    square = power * power + 4.0 * q * most
    found = (math.sqrt(square) - power) / (2.0 * q) if q > 0.0 and square > 0.0 else 0.0
    return found if found < 0.999 * share else 0.999 * share


@kernel
def _power(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The work (J) of the first bit of what is given, for as much as all of it is, by what `solver.motions` has."""
    power = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        power += row.load1 * opening_speed(now, contact, 1)
        if row.load2 > 0.0:
            power += row.load2 * opening_speed(now, contact, 2)
        if row.drag != 0.0:
            rub = rub_between(bodies[contact.body_a], bodies[contact.body_b], contact)
            power += row.drag * slip_speed(now, rub)
        k = row.next
    return power


@kernel
def _work_of_surfaces(contacts: Records, impacts: ImpactList, first: int) -> float:
    """The most work (J) that moving surfaces do by friction."""
    work = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        work += abs(row.drag * contacts[impacts.slots[k].contact].surface_speed)
        k = row.next
    return work
