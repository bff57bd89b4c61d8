"""Stage: impacts. Those that fall into a substep are resolved before the solver makes them inelastic.

Hard ones without restitution come here, too (`halts.py`): the solver takes the points of a manifold in turn, from
which a flat box would rebound.
Contacts strike one after the other until none closes faster than the threshold, so that a blow runs through a row
of balls as it does through Newton's cradle. The two points of a manifold strike together, so that a flat box
leaves flat. The rebound speed comes from the energy at the surface, not at the place where the step happens to
catch the body, so that a bounce neither gains nor loses height.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.active.body_flags import STRUCK
from sandbox.engine.active.substep_level import contact_pace
from sandbox.engine.contact_solver.prepare import HARD, closes_hard
from sandbox.engine.restitution.apply_impulse import push, rub
from sandbox.engine.restitution.inelastic import halt, speed_to_lose
from sandbox.engine.restitution.two_point_block import pair_impulses
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC

_SWEEPS = 32


@kernel
def list_bouncy(
    bodies: Records,
    flights: Records,
    marks: Integers,
    contacts: Records,
    live: Integers,
    strikers: Integers,
    pace: int,
    fastest: float,
    threshold: float,
    bouncy: Integers,
) -> int:
    """List the contacts of a pace that may strike, or none when no body is fast enough for any to matter.

    Those are the `strikers` (see `list_contact`) with restitution, and all contacts of what is struck hard without.
    `fastest` is the square of the highest speed (m/s) of a point.
    """
    used = 0
    bounces = fastest > 0.25 * threshold * threshold
    if fastest > 0.25 * HARD * HARD and _mark_struck(bodies, marks, contacts, strikers):
        for i in live:
            struck = (marks[contacts[i].body_a] | marks[contacts[i].body_b]) & STRUCK != 0
            strikes = bounces if contacts[i].restitution > 0.0 else struck
            if strikes and contact_pace(bodies, flights, contacts[i]) == pace:
                bouncy[used] = i
                used += 1
    elif bounces:
        for k in range(1, strikers[0] + 1):
            contact = contacts[strikers[k]]
            if contact.restitution > 0.0 and contact_pace(bodies, flights, contact) == pace:
                bouncy[used] = strikers[k]
                used += 1
    return used


@kernel
def _mark_struck(bodies: Records, marks: Integers, contacts: Records, strikers: Integers) -> bool:
    """Mark the dynamic bodies of contacts that close in hard without restitution; return whether there are any.

    All their contacts take part in the blow: what they lie on must not yield to it.
    """
    found = False
    for k in range(1, strikers[0] + 1):
        contact = contacts[strikers[k]]
        if contact.restitution == 0.0 and closes_hard(bodies, contact):
            found = True
            marks[contact.body_a] |= STRUCK if bodies[contact.body_a].type == DYNAMIC else 0
            marks[contact.body_b] |= STRUCK if bodies[contact.body_b].type == DYNAMIC else 0
    return found


@kernel
def resolve_impacts(
    bodies: Records,
    motions: Records,
    flights: Records,
    contacts: Records,
    bouncy: Integers,
    bouncy_count: int,
    threshold: float,
    seconds: float,
) -> None:
    """Strike every bouncy contact that closes within the substep, again and again until none is left.

    Negative `seconds` look back: contacts that have closed within a substep that is over.
    """
    for _sweep in range(_SWEEPS):
        struck = False
        for k in range(bouncy_count):
            if _strike(bodies, motions, flights, contacts[bouncy[k]], threshold, seconds):
                struck = True
        if not struck:
            return


@kernel
def resolve_late_impacts(
    bodies: Records,
    movers: Integers,
    motions: Records,
    flights: Records,
    contacts: Records,
    bouncy: Integers,
    bouncy_count: int,
    pace: int,
    threshold: float,
    seconds: float,
) -> None:
    """Strike what has come into each other within the substep that just moved everything, unforeseen.

    Corners of a spinning body do that: their speeds change while it turns. The relax pass would stop them dead.
    """
    if bouncy_count == 0:
        return
    for i in movers:
        if bodies[i].type == DYNAMIC and bodies[i].awake == 1 and flights[i].pace == pace:
            flight = flights[i]
            flight.start_x = flight.free_x = motions[i].velocity_x
            flight.start_y = flight.free_y = motions[i].velocity_y
            flight.start_w = flight.free_w = motions[i].angular_velocity
    resolve_impacts(bodies, motions, flights, contacts, bouncy, bouncy_count, threshold, -seconds)


@kernel
def _strike(
    bodies: Records, motions: Records, flights: Records, contact: Records, threshold: float, seconds: float
) -> bool:
    """Resolve the impact of one contact, if there is one; both its points at once."""
    ia = contact.body_a
    ib = contact.body_b
    a = bodies[ia]
    b = bodies[ib]
    change1 = _wanted_change(motions[ia], motions[ib], flights[ia], flights[ib], contact, 1, threshold, seconds)
    change2 = 0.0
    if contact.point_count == 2:
        change2 = _wanted_change(motions[ia], motions[ib], flights[ia], flights[ib], contact, 2, threshold, seconds)
    if change1 <= 0.0 and change2 <= 0.0:
        return False
    if contact.restitution == 0.0:
        halt(a, b, motions, flights, contact, change1, change2)
        return True
    impulse1, impulse2 = pair_impulses(a, b, contact, change1, change2)
    contact.impact_impulse += impulse1 + impulse2
    for point in range(1, 3):
        impulse = impulse1 if point == 1 else impulse2
        if impulse > 0.0:
            push(a, b, motions, flights, contact, impulse, point)
    for point in range(1, 3):
        impulse = impulse1 if point == 1 else impulse2
        if impulse > 0.0:
            rub(a, b, motions, flights, contact, impulse, 0.0, point)
    return True


@kernel
def _wanted_change(
    motion_a: Records,
    motion_b: Records,
    flight_a: Records,
    flight_b: Records,
    contact: Records,
    point: int,
    threshold: float,
    seconds: float,
) -> float:
    """Change of normal velocity (m/s) that the impact at one point asks for; 0 when there is no impact.

    With the speed v at a gap s and the relative acceleration a along the normal, v^2 - 2 a s is the same at the
    surface: that is where restitution applies. Without restitution a point goes on until it touches, and stops there.
    """
    first = point == 1
    ax = contact.anchor_ax1 if first else contact.anchor_ax2
    ay = contact.anchor_ay1 if first else contact.anchor_ay2
    bx = contact.anchor_bx1 if first else contact.anchor_bx2
    by = contact.anchor_by1 if first else contact.anchor_by2
    separation = contact.separation1 if first else contact.separation2
    nx = contact.normal_x
    ny = contact.normal_y
    start_x = flight_b.start_x - flight_b.start_w * by - flight_a.start_x + flight_a.start_w * ay
    start_y = flight_b.start_y + flight_b.start_w * bx - flight_a.start_y - flight_a.start_w * ax
    start = start_x * nx + start_y * ny
    if -start <= threshold:
        return 0.0
    free_x = flight_b.free_x - flight_b.free_w * by - flight_a.free_x + flight_a.free_w * ay
    free_y = flight_b.free_y + flight_b.free_w * bx - flight_a.free_y - flight_a.free_w * ax
    free = free_x * nx + free_y * ny
    c_a = motion_a.delta_cos
    s_a = motion_a.delta_sin
    c_b = motion_b.delta_cos
    s_b = motion_b.delta_sin
    way_x = motion_b.delta_x - motion_a.delta_x + (c_b * bx - s_b * by - bx) - (c_a * ax - s_a * ay - ax)
    way_y = motion_b.delta_y - motion_a.delta_y + (s_b * bx + c_b * by - by) - (s_a * ax + c_a * ay - ay)
    rounding = contact.radius_a * (c_a - 1.0) + contact.radius_b * (c_b - 1.0)
    gap = separation + way_x * nx + way_y * ny + rounding
    other_end = gap + seconds * free
    if contact.restitution == 0.0:
        return speed_to_lose(gap, start, other_end, seconds)
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
