"""Friction within the blow of impacts that strike together, and how it changes what restitution asks for.

The loads of the group grow from nothing in parts, all in proportion, each with the friction of now: what slides the
other way as it leaves is rubbed the other way. Restitution multiplies the loads at which the group no longer closes, by
the sum of loads times speeds (Poisson), as in the blow at one contact (`rough_blow.py`); but it gives back no more than
the square of restitution of the work that stopping the group took, so that no group gains energy by its friction.

Source: W. J. Stronge, "Rigid body collisions with friction", Proceedings of the Royal Society A 431 (1990), for the
work that restitution gives back.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_mass, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import friction_impulse, push, push_points, put_back, rub_of, take
from sandbox.engine.restitution.jointed.friction import rub_jointed
from sandbox.engine.restitution.jointed.give import give
from sandbox.engine.restitution.jointed.reach import Reach
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_FIRST_PART = 0.125
"""Share of the loads that tells how fast a group slows down with its friction."""
_MOST_PARTS = 16
"""Until a group has stopped: two are enough where friction keeps its directions until then."""
_STOPPED = 1e-4
"""Share of the power with which a group closes that counts as none."""
_PASSES = 16
"""Over the friction of a part."""


class Push(NamedTuple):
    """A part of the loads, the power of all of them as it comes and how fast that rises without friction, and the most
    work (J) that it may do on jointed bodies."""

    part: float
    power: float
    slowing: float
    most: float


class Pushed(NamedTuple):
    """The part that was applied, and the work (J) that it did."""

    part: float
    work: float


@kernel
def rub_through(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    stop: float,
    agreed: float,
    reach: Reach | None,
) -> float:
    """Apply the loads part by part, each with its friction; return which share of them it takes until the group has
    rebounded, which without friction stops at the share `stop`.

    A part of the loads does the work `part * (power + slowing * part / 2)`, J, as friction only comes after it.
    """
    share = work = 0.0
    power = first_power = _power(solver, contacts, impacts, first)
    if first_power >= 0.0:  # on the whole it opens: what joints pass on from elsewhere
        return share
    slowing = rate = -first_power / stop  # without friction
    turn = 0
    while power < _STOPPED * first_power and turn < _MOST_PARTS:
        # As it slows down now; without friction twice as far as it takes gives back the work, and further gives more.
        part = _FIRST_PART if turn == 0 else -power / (rate if 2.0 * rate > slowing else 0.5 * slowing)
        turn += 1
        pushed = push_part(bodies, solver, contacts, impacts, first, Push(part, power, slowing, 0.0), reach)
        if pushed.part <= 0.0:
            return share
        _rub_part(bodies, solver, contacts, impacts, first, pushed.part, agreed, reach)
        share += pushed.part
        work += pushed.work
        now = _power(solver, contacts, impacts, first)
        rate = (now - power) / pushed.part
        power = now
    if power < _STOPPED * first_power:  # it closes on, and may strike again
        return share
    restitution = 1.0 / stop - 1.0
    part = share * restitution
    given_back = power * power - 2.0 * slowing * restitution * restitution * work
    most = (math.sqrt(given_back) - power) / slowing if given_back > 0.0 else 0.0
    part = part if part < most else most
    if part > 0.0:
        most = -restitution * restitution * work
        part = push_part(bodies, solver, contacts, impacts, first, Push(part, power, slowing, most), reach).part
        _rub_part(bodies, solver, contacts, impacts, first, part, agreed, reach)
    return share + part


@kernel
def _power(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The sum of loads times the speeds (N m) at which their points open: negative, while the group closes."""
    power = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        power += row.load1 * opening_speed(start, contact, 1)
        if row.load2 > 0.0:
            power += row.load2 * opening_speed(start, contact, 2)
        k = row.next
    return power


@kernel
def push_part(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    push: Push,
    reach: Reach | None,
) -> Pushed:
    """Apply a part of the loads, without friction; of jointed bodies as much of it as does no more work than it may."""
    part = push.part
    k = first
    while k != END:
        impacts.rows[k].drag = 0.0
        k = impacts.rows[k].next
    if reach is not None:
        given = give(bodies, solver, contacts, impacts, first, part, push.most, reach)
        return Pushed(given.share * part, given.work)
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        struck = take(solver.free_motions, contact)
        put_back(solver, contact, push_points(struck, contact, mass, part * row.load1, part * row.load2))
        k = row.next
    return Pushed(part, part * (push.power + 0.5 * push.slowing * part))


@kernel
def _rub_part(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    part: float,
    agreed: float,
    reach: Reach | None,
) -> None:
    """Apply the friction that a part of the loads allows, `drag`: passes until it changes by no more than the share
    `agreed` of these."""
    if reach is not None:
        rub_jointed(bodies, solver, contacts, impacts, first, part, agreed, reach)
        return
    changes = True
    turn = 0
    while changes and turn < _PASSES:
        changes = False
        turn += 1
        k = first
        while k != END:
            row = impacts.rows[k]
            changes = _rub(bodies, solver, contacts[impacts.slots[k].contact], row, part, agreed) or changes
            k = row.next


@kernel
def _rub(bodies: Records, solver: SolverBodies, contact: Records, row: Records, part: float, agreed: float) -> bool:
    """The same for a contact; return whether it sticks and its friction is other than in the pass before."""
    load = part * (row.load1 + row.load2)
    if contact.friction <= 0.0 or load <= 0.0:
        return False
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    rub = rub_of(a, b, contact, row.load1, row.load2)
    struck = take(solver.free_motions, contact)
    limit = contact.friction * load
    drag = friction_impulse(struck, rub, contact.surface_speed, limit, row.drag)
    added = drag - row.drag
    row.drag = drag
    put_back(solver, contact, push(struck, pair_mass(a, b), rub.anchors, added * rub.tangent_x, added * rub.tangent_y))
    return bool(abs(drag) < limit and abs(added) > agreed * load)
