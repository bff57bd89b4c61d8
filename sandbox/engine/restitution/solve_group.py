"""Impacts with restitution that strike together: the impulses that would stop a group.

A pass goes through the contacts of the group, a block of two points each (`two_point_block.py`), along their normals.
Passes are accelerated by Nesterov's method, as those of the contact solver's blocks are (`contact_solver/nesterov.py`).
These impacts are few, in a list, without friction until they have rebounded, and agree to a velocity.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import (
    PairVelocity,
    PointImpulses,
    anchors_of,
    pair_mass,
    pair_velocity,
    push_both,
    start_velocity,
)
from sandbox.engine.contact_solver.nesterov import momentum
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import next_of
from sandbox.engine.restitution.two_point_block import Block, bearing_impulses, block_of
from sandbox.tables import Records


@kernel
def stop_group(
    bodies: Records, solver: SolverBodies, contacts: Records, group: Records, agreed: float, passes: int
) -> int:
    """Find the impulses of the inelastic impact: passes until they change no velocity by more than `agreed` (m/s).

    Out: the loads of the group, and what they make of the velocities at the start of the substep in `solver.motions`.
    Returns how many passes that took, of so many.
    """
    _begin(solver, contacts, group)
    agree = 0
    for turn in range(passes):
        largest = 0.0
        along = 0.0
        k = 0
        while k >= 0:
            slot = group[k]
            change = _stop_contact(bodies, solver, contacts[slot.contact], slot)
            largest = change if change > largest else largest
            along += slot.added1 * (slot.load1 - slot.last1) + slot.added2 * (slot.load2 - slot.last2)
            k = next_of(group, k)
        if largest <= agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return turn + 1
        agree = agree + 1 if along >= 0.0 else 0
        k = 0
        while k >= 0:
            _go_further(bodies, solver, contacts[group[k].contact], group[k], momentum(agree))
            k = next_of(group, k)
    return passes


@kernel
def _begin(solver: SolverBodies, contacts: Records, group: Records) -> None:
    """Begin with no impulses, in `solver.motions` with the velocities at the start of the substep."""
    k = 0
    while k >= 0:
        slot = group[k]
        slot.load1 = slot.load2 = slot.last1 = slot.last2 = slot.added1 = slot.added2 = 0.0
        contact = contacts[slot.contact]
        _set_velocity(solver.motions, contact, start_velocity(solver.free_motions, contact))
        k = next_of(group, k)


@kernel
def _stop_contact(bodies: Records, solver: SolverBodies, contact: Records, slot: Records) -> float:
    """Give a contact the impulses that stop it, none of them pulling; return its change of velocity (m/s)."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    both = contact.point_count == 2
    block = block_of(contact, mass)
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    before1 = slot.load1
    before2 = slot.load2
    ask1 = _alone(block, before1, before2) - opening_speed(now, contact, 1)
    ask2 = block.k12 * before1 + block.k22 * before2 - opening_speed(now, contact, 2) if both else 0.0
    load1, load2 = bearing_impulses(block, ask1, ask2)
    added1 = load1 - before1
    added2 = load2 - before2
    slot.load1 = load1
    slot.load2 = load2
    slot.added1 = added1
    slot.added2 = added2
    _push(bodies, solver, contact, added1, added2)
    return float((abs(added1) + abs(added2)) * (mass.mass_a + mass.mass_b))


@kernel
def _alone(block: Block, load1: float, load2: float) -> float:
    """What the impulses of a contact have added to the normal velocity at its point 1."""
    inverse = 1.0 / block.mass1 if block.mass1 > 0.0 else 0.0
    return inverse * load1 + block.k12 * load2


@kernel
def _go_further(bodies: Records, solver: SolverBodies, contact: Records, slot: Records, share: float) -> None:
    """Go on by a share of what the impulses have changed since the pass before; until the next one they may pull."""
    more1 = share * (slot.load1 - slot.last1)
    more2 = share * (slot.load2 - slot.last2)
    slot.last1 = slot.load1
    slot.last2 = slot.load2
    if more1 != 0.0 or more2 != 0.0:
        slot.load1 += more1
        slot.load2 += more2
        _push(bodies, solver, contact, more1, more2)


@kernel
def _push(bodies: Records, solver: SolverBodies, contact: Records, load1: float, load2: float) -> None:
    """Apply normal impulses (N s) at both points to `solver.motions`."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    r1 = anchors_of(contact, 1)
    r2 = anchors_of(contact, 2)
    loads = PointImpulses(load1, load2)
    _set_velocity(solver.motions, contact, push_both(now, mass, r1, r2, loads, contact.normal_x, contact.normal_y))


@kernel
def _set_velocity(motions: Records, contact: Records, v: PairVelocity) -> None:
    """Write the velocities of a contact's bodies."""
    a = motions[contact.body_a]
    b = motions[contact.body_b]
    a.velocity_x = v.ax
    a.velocity_y = v.ay
    a.angular_velocity = v.aw
    b.velocity_x = v.bx
    b.velocity_y = v.by
    b.angular_velocity = v.bw
