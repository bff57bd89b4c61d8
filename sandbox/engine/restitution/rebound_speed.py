"""When a contact closes within a substep, and how fast restitution then lets it open."""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import anchors_of, separation_of, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impulses import free_velocity
from sandbox.tables import Records

NONE = -1e30
"""Speed (m/s) at which a point is to open that has no impact."""
_ROUNDING = 1e-6
"""Share of a substep by which a contact may be late and still strike in it: what touches as it ends, but for rounding,
would be stopped by the contact solver."""


class Rebound(NamedTuple):
    """Speeds (m/s) at which the points of a contact are to open, or `NONE`, and the moment (s) of the earlier impact:
    from the beginning of the substep, or, looking back, from its end."""

    first: float
    second: float
    moment: float


class _Point(NamedTuple):
    """The same for a point."""

    speed: float
    moment: float


@inlined_kernel
def closes(rebound: Rebound) -> bool:
    """Whether a contact has an impact."""
    return bool(rebound.first > NONE or rebound.second > NONE)


@inlined_kernel
def rebound_speed(solver: SolverBodies, contact: Records, slot: Records, threshold: float, seconds: float) -> Rebound:
    """How a contact rebounds whose points close in faster than `threshold` (m/s).

    Negative `seconds` look back, on contacts that have come to overlap in the substep that is over.
    """
    one = two = _Point(NONE, 0.0)
    start = start_velocity(solver.free_motions, slot)
    opening = opening_speed(start, contact, 1)
    if -opening > threshold:
        one = _rebound_at(solver, contact, slot, 1, opening, seconds)
    if contact.point_count == 2:
        opening = opening_speed(start, contact, 2)
        if -opening > threshold:
            two = _rebound_at(solver, contact, slot, 2, opening, seconds)
    second_earlier = two.speed > NONE and (one.speed == NONE or two.moment < one.moment)
    return Rebound(one.speed, two.speed, two.moment if second_earlier else one.moment)


@kernel
def _rebound_at(
    solver: SolverBodies, contact: Records, slot: Records, point: int, start: float, seconds: float
) -> _Point:
    """The same for a point that opens at `start` (m/s) as the substep begins, which is fast enough for an impact.

    With the speed v at a gap s and the relative acceleration a along the normal, v^2 - 2 a s is the same at the
    surface: that is where restitution applies.
    """
    free = opening_speed(free_velocity(solver.free_motions, slot), contact, point)
    gap = gap_at(solver.motions[slot.body_a], solver.motions[slot.body_b], contact, point)
    path = -seconds * free
    late = _ROUNDING * abs(path)
    if seconds > 0.0 and gap - path > late:  # it does not close within the substep
        return _Point(NONE, 0.0)
    if seconds < 0.0 and (gap > late or gap - path <= 0.0):  # it is not closed, or was so when the substep began
        return _Point(NONE, 0.0)
    lift = 2.0 * gap * (free - start) / seconds
    at_surface = start * start - lift
    at_surface = at_surface if at_surface > 0.0 else 0.0
    square = contact.restitution * contact.restitution * at_surface + lift
    moment = -gap / free if free < 0.0 and (gap > 0.0 or seconds < 0.0) else 0.0
    return _Point(math.sqrt(square) if square > 0.0 else 0.0, float(moment))


@kernel
def gap_at(motion_a: Records, motion_b: Records, contact: Records, point: int) -> float:
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
