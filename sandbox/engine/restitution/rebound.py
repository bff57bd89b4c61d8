"""How impacts that strike together rebound: by the impulses that were found for them.

They are scaled to do what was asked as far as they can together: so however exact they are, a group gains no energy by
them. Where its contacts rub, they are found anew together with friction (`rough_group.py`).
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_mass, pair_velocity, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.jointed.reach import Reach
from sandbox.engine.restitution.push_group import push_group
from sandbox.engine.restitution.rough_group import scale_impulses, strike_rough_group
from sandbox.engine.restitution.solve_group import push_motions, set_velocity
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records


class Blow(NamedTuple):
    """By how much to multiply the loads of a group, and the share of them at which it stops, without friction."""

    scale: float
    stop: float


@kernel
def rebound(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    more: float,
    agreed: float,
    reach: Reach | None,
) -> int:
    """Apply the loads of the contacts linked from the `first` one on, scaled, times `more`, to the velocities of the
    substep, with the friction that they allow; `agreed` is the share of the closing speed to which that is exact.

    In: the loads, and `solver.motions` after them. `reach` is what the group reaches by joints. Returns how much work
    the friction was, passes times contacts.
    """
    blow = _blow_of(solver, contacts, impacts, first, more)
    if _rubs(contacts, impacts, first) and blow.scale > 0.0:
        _ask_as_scaled(solver, contacts, impacts, first, blow.scale)
        if reach is None:
            _begin_as_scaled(bodies, solver, contacts, impacts, first, blow.scale)
        return int(strike_rough_group(bodies, solver, contacts, impacts, first, blow.stop, agreed, reach))
    scale_impulses(impacts, first, blow.scale)
    push_group(bodies, solver, contacts, impacts, first, reach)
    return 0


@kernel
def _blow_of(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, more: float) -> Blow:
    """How to scale loads p that were to change normal velocities v by c and change them by d: the quadratic whose
    minimum is asked for, p d / 2 - p c, is the least along p where it is multiplied by p c / p d."""
    asked = changed = closed = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        if row.load1 > 0.0:
            before = opening_speed(start, contact, 1)
            asked += row.load1 * (row.rebound1 - before)
            changed += row.load1 * (opening_speed(now, contact, 1) - before)
            closed -= row.load1 * before
        if row.load2 > 0.0:
            before = opening_speed(start, contact, 2)
            asked += row.load2 * (row.rebound2 - before)
            changed += row.load2 * (opening_speed(now, contact, 2) - before)
            closed -= row.load2 * before
        k = row.next
    scale = more * asked / changed if asked > 0.0 and changed > 0.0 else 0.0
    return Blow(scale, closed / (scale * changed) if scale > 0.0 and closed > 0.0 else 1.0)


@kernel
def _rubs(contacts: Records, impacts: ImpactList, first: int) -> bool:
    """Whether some contact rubs."""
    k = first
    while k != END:
        if contacts[impacts.slots[k].contact].friction > 0.0:
            return True
        k = impacts.rows[k].next
    return False


@kernel
def _ask_as_scaled(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, scale: float) -> None:
    """Ask of all points that bear for the speeds that the scaled loads give them without friction."""
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        row.slides = row.drag = 0.0
        if row.load1 > 0.0:
            before = opening_speed(start, contact, 1)
            row.rebound1 = before + scale * (opening_speed(now, contact, 1) - before)
        if row.load2 > 0.0:
            before = opening_speed(start, contact, 2)
            row.rebound2 = before + scale * (opening_speed(now, contact, 2) - before)
        k = row.next


@kernel
def _begin_as_scaled(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, scale: float
) -> None:
    """Begin with the scaled loads, and with the velocities in `solver.motions` that they give: what does not slide is
    found by that, and only friction is left to be found."""
    k = first
    while k != END:
        contact = contacts[impacts.slots[k].contact]
        set_velocity(solver.motions, contact, start_velocity(solver.free_motions, contact))
        k = impacts.rows[k].next
    scale_impulses(impacts, first, scale)
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        push_motions(solver, contact, mass, now, row.load1, row.load2)
        k = row.next
