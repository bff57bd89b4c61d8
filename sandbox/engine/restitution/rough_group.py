"""Friction within the blow of impacts that strike together, which also changes how they share the loads.

Loads and friction are found together (`solve_group.py`), for what is asked of the group or, where a contact slides back
by then, for as much as goes before it does: the rest is found anew from there, with the friction the other way. So
friction turns nothing that the loads could hold. No group gains energy (`blow_work.py`).
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_velocity, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.blow_work import share_within
from sandbox.engine.restitution.groups import CLOSING, fastest, size_of
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between, slip_speed
from sandbox.engine.restitution.jointed.loads import solve_jointed
from sandbox.engine.restitution.jointed.reach import Reach
from sandbox.engine.restitution.push_group import push_group
from sandbox.engine.restitution.solve_group import solve_group
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_MOST_PARTS = 16
"""Times that the rest is found anew where a contact slides back, of a group of one, and half as many of two; what
slides back after the last has the friction of the end."""
_MOST_PASSES = 16
_SAME = 10.0
"""Times what the speeds agree to: a contact that slides back no faster sticks."""


class _Slips(NamedTuple):
    """Speeds (m/s) at which a contact slides, before and after."""

    before: float
    after: float


class _Part(NamedTuple):
    """A part of a blow: its loads together (N s), their work (`blow_work.py`), that of the friction, and which share it
    takes until a contact slides back."""

    load: float
    power: float
    slowing: float
    rubbing: float
    rub_slowing: float
    share: float


@kernel
def strike_rough_group(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    stop: float,
    agreed: float,
    reach: Reach | None,
) -> int:
    """Apply the blow after which the contacts linked from the `first` one on open as fast as is asked.

    In: `rebound1` and `rebound2`, the loads of the blow without friction, and `solver.motions` after them, of which the
    group has stopped at the share `stop`; the share `agreed` of its closing speed to which it is solved. Returns the
    work, passes times contacts.
    """
    slow = agreed * fastest(solver, contacts, impacts, first, CLOSING)
    restitution = 1.0 / stop - 1.0
    work = done = lowest = load = stopped = 0.0
    effort = 0
    parts = 1 + _MOST_PARTS // size_of(impacts, first)
    for turn in range(parts):
        effort += _solve(bodies, solver, contacts, impacts, first, turn == 0, slow, reach)
        if turn < parts - 1 and _mark_sliding_back(bodies, solver, contacts, impacts, first, _SAME * slow):
            effort += _solve(bodies, solver, contacts, impacts, first, True, slow, reach)
        part = _part_of(bodies, solver, contacts, impacts, first)
        if part.load <= 0.0:
            break
        share = part.share
        turns = -0.5 * part.power / part.slowing if part.slowing > 0.0 else share
        turns = turns if turns < share else share
        if turns > 0.0:
            lowest = work + turns * (part.power + turns * part.slowing)
            stopped = load + turns * part.load
        if turns < share:
            share = share_within(share, part.power, part.slowing, (1.0 - restitution * restitution) * lowest - work)
            most = (stopped / stop - load) / part.load
            share = most if most < share else share
        # Friction is found for the end of a part, and may push on in its beginning.
        share = share_within(share, part.power + part.rubbing, part.slowing + part.rub_slowing, -done)
        scale_impulses(impacts, first, share)
        share *= push_group(bodies, solver, contacts, impacts, first, reach)
        work += share * (part.power + share * part.slowing)
        done += share * (part.power + part.rubbing + share * (part.slowing + part.rub_slowing))
        load += share * part.load
        if share < part.share or part.share == 1.0:
            break
    return effort


@kernel
def _solve(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    again: bool,
    slow: float,
    reach: Reach | None,
) -> int:
    """Find loads and friction, to `slow` (m/s); `again` goes on from those there are, where nothing is jointed.
    Returns the work of passes over free bodies."""
    if reach is not None:
        solve_jointed(bodies, solver, contacts, impacts, first, True, slow, reach)
        return 0
    return int(solve_group(bodies, solver, contacts, impacts, first, again, True, slow, _MOST_PASSES))


@kernel
def _mark_sliding_back(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, same: float
) -> bool:
    """Mark the contacts that slide back, faster than `same` (m/s): until they do friction does not change its side.
    Returns whether there are any."""
    found = False
    k = first
    while k != END:
        row = impacts.rows[k]
        slips = _slips(bodies, solver, contacts[impacts.slots[k].contact], row)
        row.slides = 0.0
        if slips.before * slips.after < 0.0 and abs(slips.after) > same and abs(slips.before) > same:
            row.slides = 1.0 if slips.before > 0.0 else -1.0
            found = True
        k = row.next
    return found


@inlined_kernel
def _slips(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> _Slips:
    """How a contact slides before and after what was found, if it bears and rubs."""
    if contact.friction <= 0.0 or row.load1 + row.load2 <= 0.0:
        return _Slips(0.0, 0.0)
    rub = rub_between(bodies[contact.body_a], bodies[contact.body_b], contact)
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    before = slip_speed(start_velocity(solver.free_motions, contact), rub)
    return _Slips(before - contact.surface_speed, slip_speed(now, rub) - contact.surface_speed)


@kernel
def _part_of(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> _Part:
    """What loads and friction do, by the velocities at the start of the substep and those in `solver.motions`."""
    load = power = slowing = rubbing = rub_slowing = 0.0
    share = 1.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        if row.drag != 0.0:
            slips = _slips(bodies, solver, contact, row)
            rubbing += row.drag * slips.before
            rub_slowing += 0.5 * row.drag * (slips.after - slips.before)
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        opening = opening_speed(start, contact, 1)
        load += row.load1 + row.load2
        power += row.load1 * opening
        slowing += 0.5 * row.load1 * (opening_speed(now, contact, 1) - opening)
        if row.load2 > 0.0:
            opening = opening_speed(start, contact, 2)
            power += row.load2 * opening
            slowing += 0.5 * row.load2 * (opening_speed(now, contact, 2) - opening)
        if row.slides != 0.0:
            slips = _slips(bodies, solver, contact, row)
            until = slips.before / (slips.before - slips.after) if slips.before * slips.after < 0.0 else 1.0
            share = until if until < share else share
            row.slides = 0.0
        k = row.next
    return _Part(load, power, slowing, rubbing, rub_slowing, share)


@kernel
def scale_impulses(impacts: ImpactList, first: int, share: float) -> None:
    """Multiply loads and friction."""
    k = first
    while k != END:
        row = impacts.rows[k]
        row.load1 *= share
        row.load2 *= share
        row.drag *= share
        k = row.next
