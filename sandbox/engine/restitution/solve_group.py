"""Impacts with restitution that strike together: the impulses that give each of a group what it asks for, or more.

A pass goes through the contacts of the group, a block of two points each (`two_point_block.py`), along their normals,
then, where that is asked for, along their tangents. Passes are accelerated by Nesterov's method, as those of the
contact solver's blocks are (`contact_solver/nesterov.py`). These impacts are few, linked, and agree to a velocity.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import (
    Levers,
    PairMass,
    PairVelocity,
    anchors_of,
    clamp_to_cone,
    effective_mass,
    levers_of,
    pair_mass,
    pair_velocity,
    push_along,
    set_pair_velocity,
    speed_of_centers,
    speed_of_turning,
    start_velocity,
)
from sandbox.engine.contact_solver.nesterov import momentum
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between
from sandbox.engine.restitution.two_point_block import bearing_impulses, block_of
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records


@kernel
def solve_group(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    again: bool,
    rough: bool,
    agreed: float,
    passes: int,
) -> int:
    """Find the impulses, of which none pulls, that open each point as fast as is asked or faster, and no faster where
    they push: passes until they change no velocity by more than `agreed` (m/s).

    In: `rebound1` and `rebound2` of the contacts that are linked from the `first` one on. Out: their loads, and what
    these make of the velocities at the start of the substep in `solver.motions`. `again` goes on from what both are;
    `rough` finds also the friction, `drag`, that the loads allow. Returns passes times contacts.
    """
    count = _begin(bodies, solver, contacts, impacts, first, again, rough)
    agree = 0
    for turn in range(passes):
        largest = 0.0
        along = 0.0
        k = first
        while k != END:
            row = impacts.rows[k]
            contact = contacts[impacts.slots[k].contact]
            change, same = _solve_contact(bodies, solver, contact, row)
            if rough and contact.friction > 0.0:
                change += _rub(bodies, solver, contact, row)
            largest = change if change > largest else largest
            along += same
            k = row.next
        if largest <= agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return (turn + 1) * count
        agree = agree + 1 if along >= 0.0 else 0
        k = first
        while k != END:
            _go_further(bodies, solver, contacts[impacts.slots[k].contact], impacts.rows[k], momentum(agree))
            k = impacts.rows[k].next
    return passes * count


@kernel
def _begin(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    again: bool,
    rough: bool,
) -> int:
    """Begin with no impulses, in `solver.motions` with the velocities at the start of the substep, or go on; return the
    number of contacts."""
    count = 0
    k = first
    while k != END:
        row = impacts.rows[k]
        if not again:
            row.load1 = row.load2 = row.drag = 0.0
        row.last_drag = row.drag
        row.last1 = row.load1
        row.last2 = row.load2
        contact = contacts[impacts.slots[k].contact]
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        row.mass = effective_mass(mass, anchors_of(contact, 1), contact.normal_x, contact.normal_y)
        if not again:
            set_velocity(solver.motions, contact, start_velocity(solver.free_motions, contact))
        if rough and contact.friction > 0.0:
            rub = rub_between(bodies[contact.body_a], bodies[contact.body_b], contact)
            levers = levers_of(rub.anchors, rub.tangent_x, rub.tangent_y)
            row.lever_a = levers.a
            row.lever_b = levers.b
            row.rub_mass = rub.mass
        count += 1
        k = row.next
    return count


@kernel
def _solve_contact(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> tuple[float, float]:
    """Give a contact the impulses that it asks for, none of them pulling; return by how much they change its velocity
    (m/s), and whether they go on as since the pass before: positive, if they do."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    before1 = row.load1
    before2 = row.load2
    ask1 = row.rebound1 - opening_speed(now, contact, 1)
    if contact.point_count == 2:
        block = block_of(contact, mass)
        ask1 += block.k11 * before1 + block.k12 * before2
        ask2 = block.k12 * before1 + block.k22 * before2 + row.rebound2 - opening_speed(now, contact, 2)
        load1, load2 = bearing_impulses(block, ask1, ask2)
    else:
        load1 = before1 + row.mass * ask1
        load1 = load1 if load1 > 0.0 else 0.0
        load2 = 0.0
    added1 = load1 - before1
    added2 = load2 - before2
    row.load1 = load1
    row.load2 = load2
    push_motions(solver, contact, mass, now, added1, added2)
    largest = (abs(added1) + abs(added2)) * (mass.mass_a + mass.mass_b)
    return float(largest), float(added1 * (load1 - row.last1) + added2 * (load2 - row.last2))


@kernel
def _rub(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> float:
    """Give a contact the friction that stops its sliding, as far as its load allows; return by how much that changes
    its velocity (m/s)."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    limit = contact.friction * (row.load1 + row.load2)
    levers = Levers(row.lever_a, row.lever_b)
    slip = speed_of_centers(now, contact.normal_y, -contact.normal_x) + speed_of_turning(now, levers)
    drag = clamp_to_cone(row.drag - row.rub_mass * (slip - contact.surface_speed), limit)
    if row.slides != 0.0:
        drag = -row.slides * limit
    added = drag - row.drag
    row.drag = drag
    moved = push_along(now, mass, levers, added, contact.normal_y, -contact.normal_x)
    set_velocity(solver.motions, contact, moved)
    return float(abs(added) * (mass.mass_a + mass.mass_b))


@kernel
def _go_further(bodies: Records, solver: SolverBodies, contact: Records, row: Records, share: float) -> None:
    """Go on by a share of what the impulses have changed since the pass before; until the next one they may pull."""
    more1 = share * (row.load1 - row.last1)
    more2 = share * (row.load2 - row.last2)
    more_drag = share * (row.drag - row.last_drag)
    row.last1 = row.load1
    row.last2 = row.load2
    row.last_drag = row.drag
    if more1 != 0.0 or more2 != 0.0 or more_drag != 0.0:
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        if more_drag != 0.0:
            levers = Levers(row.lever_a, row.lever_b)
            now = push_along(now, mass, levers, more_drag, contact.normal_y, -contact.normal_x)
        row.load1 += more1
        row.load2 += more2
        row.drag += more_drag
        push_motions(solver, contact, mass, now, more1, more2)


@inlined_kernel
def push_motions(
    solver: SolverBodies, contact: Records, mass: PairMass, now: PairVelocity, load1: float, load2: float
) -> None:
    """Apply normal impulses (N s) at both points to the velocities of now, in `solver.motions`."""
    nx = contact.normal_x
    ny = contact.normal_y
    v = push_along(now, mass, levers_of(anchors_of(contact, 1), nx, ny), load1, nx, ny)
    if contact.point_count == 2:
        v = push_along(v, mass, levers_of(anchors_of(contact, 2), nx, ny), load2, nx, ny)
    set_velocity(solver.motions, contact, v)


@inlined_kernel
def set_velocity(motions: Records, contact: Records, v: PairVelocity) -> None:
    """Write the velocities of a contact's bodies."""
    set_pair_velocity(motions[contact.body_a], motions[contact.body_b], v)
