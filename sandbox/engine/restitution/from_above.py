"""Where passes over impacts that strike together begin: with what would stop each body on what is below it.

A pass carries an impulse few contacts further, so that as many would be needed as a stack that lands is high, and more.
But what lands on the ground as a whole is stopped from the top down: each body by those of its contacts that are nearer
to something immovable, in equal shares, as if what is there did not yield; what it takes goes on down. For a stack that
is the solution; elsewhere passes have less to find.

Source: E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid bodies with stacking", ACM Transactions on Graphics 22
(2003), for going through a heap by its distance from the ground.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import PairMass, PairVelocity, pair_mass, pair_velocity, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rebound_speed import NONE
from sandbox.engine.restitution.solve_group import push_motions, set_velocity
from sandbox.engine.restitution.two_point_block import bearing_impulses, block_of
from sandbox.engine.restitution.worklist import END, next_contact
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

_IMMOVABLE, _UNKNOWN = 0, -1
"""`closing` of an impact body holds how many contacts it is away from what does not move."""


@kernel
def begin_from_above(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> None:
    """Give the contacts that are linked from the `first` one on the loads that stop each body on what is below it, and
    `solver.motions` the velocities that follow."""
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        row.load1 = row.load2 = row.drag = 0.0
        set_velocity(solver.motions, contact, start_velocity(solver.free_motions, contact))
        for i in (contact.body_a, contact.body_b):
            solver.impact_bodies[i].closing = _UNKNOWN if bodies[i].type == DYNAMIC else _IMMOVABLE
        k = row.next
    k = _highest_first(solver, impacts, first)
    while k != END:
        slot = impacts.slots[k]
        on_top = _upper(solver, slot)
        _stop(bodies, solver, contacts, impacts, k, on_top)
        k = slot.following


@kernel
def _highest_first(solver: SolverBodies, impacts: ImpactList, first: int) -> int:
    """Find how far the bodies are from what does not move, breadth first; link by `following` the contacts by each of
    which one was reached first, the farthest ones first, and return the first of these."""
    slots = impacts.slots
    rows = impacts.rows
    group = rows[first].group
    front = last = END
    k = first
    while k != END:
        i = _unknown(solver, slots[k])
        if i >= 0 and _is_beside_immovable(solver, slots[k]):
            solver.impact_bodies[i].closing = 1
            front, last = _append(slots, k, front, last)
        k = rows[k].next
    top = END
    while front != END:
        k = front
        front = slots[k].following
        last = END if front == END else last
        slots[k].following = top
        top = k
        here = _upper(solver, slots[k])
        j = solver.first_impact[here]
        while j != END:
            i = _unknown(solver, slots[j])
            if i >= 0 and rows[j].group == group:
                solver.impact_bodies[i].closing = solver.impact_bodies[here].closing + 1
                front, last = _append(slots, j, front, last)
            j = next_contact(slots[j], here)
    return top


@inlined_kernel
def _append(slots: Records, k: int, front: int, last: int) -> tuple[int, int]:
    """Put contact k behind the last one of a queue."""
    slots[k].following = END
    if last == END:
        return k, k
    slots[last].following = k
    return front, k


@inlined_kernel
def _unknown(solver: SolverBodies, slot: Records) -> int:
    """A body of a contact that has not been reached yet, or -1."""
    if solver.impact_bodies[slot.body_a].closing == _UNKNOWN:
        return int(slot.body_a)
    if solver.impact_bodies[slot.body_b].closing == _UNKNOWN:
        return int(slot.body_b)
    return -1


@inlined_kernel
def _is_beside_immovable(solver: SolverBodies, slot: Records) -> bool:
    """Whether one body of a contact does not move."""
    a = solver.impact_bodies[slot.body_a].closing
    b = solver.impact_bodies[slot.body_b].closing
    return bool(a == _IMMOVABLE or b == _IMMOVABLE)


@inlined_kernel
def _upper(solver: SolverBodies, slot: Records) -> int:
    """The body of a contact that is farther from what does not move."""
    a = solver.impact_bodies[slot.body_a].closing
    b = solver.impact_bodies[slot.body_b].closing
    return int(slot.body_a if a > b else slot.body_b)


@kernel
def _stop(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, i: int) -> None:
    """Stop body i on what is below it: by its contacts of the group of the `first` one."""
    slots = impacts.slots
    rows = impacts.rows
    shares = 0
    j = solver.first_impact[i]
    while j != END:
        shares += 1 if _bears(solver, impacts, first, j, i) else 0
        j = next_contact(slots[j], i)
    x = solver.motions[i].velocity_x
    y = solver.motions[i].velocity_y
    w = solver.motions[i].angular_velocity
    j = solver.first_impact[i]
    while j != END:
        if _bears(solver, impacts, first, j, i):
            contact = contacts[slots[j].contact]
            mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
            if contact.body_a == i:
                alone = PairMass(mass.mass_a, mass.inertia_a, 0.0, 0.0)
                v = PairVelocity(x, y, w, 0.0, 0.0, 0.0)
            else:
                alone = PairMass(0.0, 0.0, mass.mass_b, mass.inertia_b)
                v = PairVelocity(0.0, 0.0, 0.0, x, y, w)
            ask2 = -opening_speed(v, contact, 2) if contact.point_count == 2 else NONE
            load1, load2 = bearing_impulses(block_of(contact, alone), -opening_speed(v, contact, 1), ask2)
            rows[j].load1 = load1 / shares
            rows[j].load2 = load2 / shares
            now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
            push_motions(solver, contact, mass, now, rows[j].load1, rows[j].load2)
        j = next_contact(slots[j], i)


@inlined_kernel
def _bears(solver: SolverBodies, impacts: ImpactList, first: int, k: int, i: int) -> bool:
    """Whether contact k is of the group of the `first` one, and body i is on top."""
    slot = impacts.slots[k]
    other = slot.body_b if slot.body_a == i else slot.body_a
    lower = solver.impact_bodies[other].closing < solver.impact_bodies[i].closing
    return bool(lower and impacts.rows[k].group == impacts.rows[first].group)
