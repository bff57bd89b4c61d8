"""How fast the points of a contact close in, or open."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.lanes import lane_anchors
from sandbox.engine.contact_solver.law import (
    PairVelocity,
    anchors_of,
    pair_velocity,
    relative_velocity,
    start_velocity,
)
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Floats, Records

HARD = 2.0
"""Speed (m/s) past which a contact that stops by several impulses has an impact, whatever its restitution."""
SLOW = 0.2
"""The same where all such impacts concern few bodies; below it, what closes in is left to the contact solver."""


@inlined_kernel
def opening_speed(v: PairVelocity, contact: Records, point: int) -> float:
    """Speed (m/s) along the normal at which point 1 or 2 of a contact opens, with these velocities of its bodies."""
    x, y = relative_velocity(v, anchors_of(contact, point))
    return float(x * contact.normal_x + y * contact.normal_y)


@kernel
def closing_speed(a: Records, b: Records, contact: Records, point: int) -> float:
    """Speed (m/s) at which point 1 or 2 of two bodies approaches along the normal."""
    return -opening_speed(pair_velocity(a, b), contact, point)


@inlined_kernel
def stops_by_several(point_count: int, rolling_resistance: float) -> bool:
    """Whether a contact stops by impulses that have to agree: of two points, or of one and of the roll that it resists.

    A single point alone the solver stops exactly.
    """
    return bool(point_count == 2 or rolling_resistance > 0.0)


@kernel
def fastest_closing(a: Records, b: Records, contact: Records) -> float:
    """Speed (m/s) at which the faster point of a contact of bodies a and b closes in as the step begins."""
    first = closing_speed(a, b, contact, 1)
    second = closing_speed(a, b, contact, 2) if contact.point_count == 2 else first
    return first if first > second else second


@kernel
def mean_closing(a: Records, b: Records, contact: Records) -> float:
    """Speed (m/s) at which the points of a contact of bodies a and b close in on the mean as the step begins."""
    first = closing_speed(a, b, contact, 1)
    return 0.5 * (first + closing_speed(a, b, contact, 2)) if contact.point_count == 2 else first


@inlined_kernel
def gap_of(a: Records, b: Records, block: Records, v: Floats, point: int) -> float:
    """The gap (m) of now at `POINT_1` or `POINT_2` of the contact with lane `v` of a block, by its bodies' motions."""
    r = lane_anchors(v, point, 0)
    x = b.delta_x - a.delta_x + (b.delta_cos * r.bx - b.delta_sin * r.by) - (a.delta_cos * r.ax - a.delta_sin * r.ay)
    y = b.delta_y - a.delta_y + (b.delta_sin * r.bx + b.delta_cos * r.by) - (a.delta_sin * r.ax + a.delta_cos * r.ay)
    rounding = v[cb.RADIUS_A] * a.delta_cos + v[cb.RADIUS_B] * b.delta_cos if block.rounded == 1 else 0.0
    return float(x * v[cb.NORMAL_X] + y * v[cb.NORMAL_Y] + rounding + v[point + cb.SEPARATION])


@kernel
def closing_beyond_gap(solver: SolverBodies, slot: Records, block: Records, v: Floats, rate: float) -> float:
    """How much faster (m/s) than its gap would close in 1 / `rate` seconds a contact closes at its faster point.

    `v` is its lane of the block; velocities are those with which the substep began.
    """
    velocity = start_velocity(solver.free_motions, slot)
    fastest = 0.0
    for point in (cb.POINT_1, cb.POINT_2):
        gap = gap_of(solver.motions[slot.body_a], solver.motions[slot.body_b], block, v, point)
        x, y = relative_velocity(velocity, lane_anchors(v, point, 0))
        closing = -(x * v[cb.NORMAL_X] + y * v[cb.NORMAL_Y]) - (gap * rate if gap > 0.0 else 0.0)
        fastest = closing if closing > fastest else fastest
    return fastest


@inlined_kernel
def bounce_threshold(setting: Records) -> float:
    """Speed (m/s, where a metre is as many units of length as the settings say) below which impacts do not bounce."""
    return float(setting.restitution_threshold * setting.units_per_meter)
