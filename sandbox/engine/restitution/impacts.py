"""Stage: impacts. Those that fall into a substep are resolved before the solver makes them inelastic.

Those without restitution are stopped all at once, afterwards (`inelastic.py`).
Contacts strike one after the other until none closes faster than the threshold (`worklist.py`), so that an impact runs
through a row of balls as it does through Newton's cradle. Where that does not end, as a light body rattles between
heavy ones, those that have struck strike together instead (`simultaneous.py`). The two points of a manifold always do,
so that a flat box leaves flat. The rebound speed comes from the energy at the surface, not at the place where the step
happens to catch the body, so that a bounce neither gains nor loses height.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.substep_level import contact_substep_level
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import anchors_of, separation_of, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.restitution.elastic import strike_elastic
from sandbox.engine.restitution.groups import ALONE, NOT_STRUCK, form_groups, note_first_strike, starts_group
from sandbox.engine.restitution.impulses import free_velocity
from sandbox.engine.restitution.simultaneous import strike_group
from sandbox.engine.restitution.worklist import END, add_all, add_contacts, take_first
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

_MOST_WORK = 15_000
"""Passes times contacts of those that strike together in a substep: what is left goes to the contact solver."""
_STRIKES = 16
"""Of a contact one by one, as many as a ball of 100 times the mass needs on a light one at a wall: what goes on longer
rattles, and strikes together."""
_ROUNDS = 32
"""In which groups strike together: most end with the first few."""


class ImpactList(NamedTuple):
    """The contacts that may have an impact in a step: `rows[:length]`, as `IMPACT`, and in `slots`, as `IMPACT_SLOT`;
    and the speed (m/s) below which none does."""

    rows: Records
    slots: Records
    length: int
    threshold: float


@kernel
def list_impact_contacts(
    bodies: Records,
    solver: SolverBodies,
    contacts: Contacts,
    substep_level: int,
    fastest: float,
    threshold: float,
    slots: Records,
) -> int:
    """List the contacts of a substep level that may strike, or none when no body is fast enough for any to matter.

    Those are the `impact_candidates` (see `decide_pairs`) with restitution. `fastest` is the square of the highest
    speed (m/s) of a point. Returns how many `slots` are used.
    """
    used = 0
    candidates = contacts.impact_candidates
    if fastest <= 0.25 * threshold * threshold:
        return 0
    for k in range(1, candidates[0] + 1):
        contact = contacts.now[candidates[k]]
        level = contact_substep_level(bodies, solver.free_motions, contact)
        if contact.restitution > 0.0 and level == substep_level:
            slot = slots[used]
            slot.contact = candidates[k]
            slot.body_a = contact.body_a
            slot.body_b = contact.body_b
            used += 1
    return used


@kernel
def resolve_impacts(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float
) -> None:
    """Strike every listed contact that closes within the substep, again and again until none is left.

    Negative `seconds` look back: contacts that have come into each other, unforeseen, within the substep that just
    moved everything. Corners of a spinning body do that: their speeds change while it turns, and the relax pass would
    stop them dead. Groups that do not come to an end one by one are taken back, and strike together.
    """
    if _strike_singly(bodies, solver, contacts, impacts, seconds):
        return
    rows: Any = impacts.rows[: impacts.length]
    work = 0
    for turn in range(_ROUNDS):
        if work >= _MOST_WORK or not _add_closing(bodies, solver, contacts, impacts, seconds):
            return
        form_groups(bodies, rows, solver.struck)
        for k in range(impacts.length):
            if starts_group(rows, k, solver.struck):
                left = _MOST_WORK - work
                work += strike_group(bodies, solver, contacts, rows[k:], impacts.threshold, turn == 0, left)


@kernel
def _strike_singly(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float
) -> bool:
    """Strike contacts one after the other; return whether that came to an end.

    Those that have struck have a `group` afterwards.
    """
    slots = impacts.slots
    for k in range(impacts.length):
        impacts.rows[k].group = ALONE
        solver.struck[slots[k].body_a] = solver.struck[slots[k].body_b] = NOT_STRUCK
    ended = True
    first, last = add_all(slots, impacts.length)
    while first != END:
        k = first
        slot = slots[k]
        first, last = take_first(slots, first, last)
        if slot.strikes == _STRIKES:
            ended = False
        elif _strike(bodies, solver, contacts, slot, impacts.rows[k], impacts.threshold, seconds):
            slot.strikes += 1
            for i in (slot.body_a, slot.body_b):
                if bodies[i].type == DYNAMIC:
                    first, last = add_contacts(slots, i, solver.first_impact[i], first, last)
    return ended


@kernel
def _add_closing(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float) -> bool:
    """Let contacts that close strike too, and return whether there are any."""
    found = False
    for k in range(impacts.length):
        slot = impacts.slots[k]
        contact = contacts[slot.contact]
        change1, change2 = _wanted_changes(solver, contact, slot, impacts.threshold, seconds)
        if change1 > 0.0 or change2 > 0.0:
            note_first_strike(bodies, solver, contact, impacts.rows[k])
            found = True
    return found


@kernel
def _strike(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    slot: Records,
    impact: Records,
    threshold: float,
    seconds: float,
) -> bool:
    """Resolve the impact of one contact, if there is one; both its points at once."""
    contact = contacts[slot.contact]
    change1, change2 = _wanted_changes(solver, contact, slot, threshold, seconds)
    if change1 <= 0.0 and change2 <= 0.0:
        return False
    note_first_strike(bodies, solver, contact, impact)
    strike_elastic(bodies, solver, contact, change1, change2)
    return True


@inlined_kernel
def _wanted_changes(
    solver: SolverBodies, contact: Records, slot: Records, threshold: float, seconds: float
) -> tuple[float, float]:
    """Change of normal velocity (m/s) that the impact at each point asks for; 0 where there is no impact."""
    change1 = change2 = 0.0
    start = start_velocity(solver.free_motions, slot)
    opening = opening_speed(start, contact, 1)
    if -opening > threshold:
        change1 = _wanted_change(solver, contact, slot, 1, opening, seconds)
    if contact.point_count == 2:
        opening = opening_speed(start, contact, 2)
        if -opening > threshold:
            change2 = _wanted_change(solver, contact, slot, 2, opening, seconds)
    return change1, change2


@kernel
def _wanted_change(
    solver: SolverBodies, contact: Records, slot: Records, point: int, start: float, seconds: float
) -> float:
    """The same for a point that opens at `start` (m/s) as the substep begins, which is fast enough for an impact.

    With the speed v at a gap s and the relative acceleration a along the normal, v^2 - 2 a s is the same at the
    surface: that is where restitution applies.
    """
    free = opening_speed(free_velocity(solver.free_motions, slot), contact, point)
    gap = _gap(solver.motions[slot.body_a], solver.motions[slot.body_b], contact, point)
    other_end = gap + seconds * free
    if seconds > 0.0 and other_end > 0.0:  # it does not close within the substep
        return 0.0
    if seconds < 0.0 and (gap > 0.0 or other_end <= 0.0):  # it is not closed, or was so when the substep began
        return 0.0
    lift = 2.0 * gap * (free - start) / seconds
    at_surface = start * start - lift
    at_surface = at_surface if at_surface > 0.0 else 0.0
    rebound = contact.restitution * contact.restitution * at_surface + lift
    rebound = math.sqrt(rebound) if rebound > 0.0 else 0.0
    return float(rebound - start)


@kernel
def _gap(motion_a: Records, motion_b: Records, contact: Records, point: int) -> float:
    """The gap (m) at a point after what the bodies have moved since the step began."""
    r = anchors_of(contact, point)
    c_a = motion_a.delta_cos
    s_a = motion_a.delta_sin
    c_b = motion_b.delta_cos
    s_b = motion_b.delta_sin
    x = motion_b.delta_x - motion_a.delta_x + (c_b * r.bx - s_b * r.by - r.bx) - (c_a * r.ax - s_a * r.ay - r.ax)
    y = motion_b.delta_y - motion_a.delta_y + (s_b * r.bx + c_b * r.by - r.by) - (s_a * r.ax + c_a * r.ay - r.ay)
    rounding = contact.radius_a * (c_a - 1.0) + contact.radius_b * (c_b - 1.0)
    return float(separation_of(contact, point) + x * contact.normal_x + y * contact.normal_y + rounding)
