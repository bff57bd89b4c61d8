"""The relative way of two bodies through a step, and when they touch on it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.sweep import time_of_hit
from sandbox.tables import Records

DEEP = 0.005
"""Overlap that is let pass, in metres: it is pushed out in time."""
DEEP_SHARE = 0.25
"""Past this share of the half widths of both, shapes are about to come out on the wrong side."""
CREEP = 0.02
"""Share of what is let pass by which an overlap may grow in a step: what slides under a load must not stick."""
CREEP_LINKED = 1.0
"""The same for links: one that is held while its neighbours go on tears their joints."""
_LEAST_DEEP = 1e-9


@kernel
def allowed_depth(a: Records, b: Records) -> float:
    """How deep two shapes may get into each other unforeseen, in metres."""
    share = DEEP_SHARE * (a.thin + b.thin)
    share = share if share < DEEP else DEEP
    return float(share if share > _LEAST_DEEP else _LEAST_DEEP)


@kernel
def lay_way(
    bodies: Records,
    motions: Records,
    holds: Records,
    a: int,
    b: int,
    start_a: float,
    start_b: float,
    end_a: float,
    end_b: float,
    s: Records,
) -> None:
    """The relative way of two bodies, each between two times of its own way through the step."""
    x = bodies[b].center_x - bodies[a].center_x
    y = bodies[b].center_y - bodies[a].center_y
    back_a = 1.0 - start_a
    back_b = 1.0 - start_b
    s.x = x - back_b * motions[b].delta_x + back_a * motions[a].delta_x
    s.y = y - back_b * motions[b].delta_y + back_a * motions[a].delta_y
    long_a = end_a - start_a
    long_b = end_b - start_b
    s.way_x = long_b * motions[b].delta_x - long_a * motions[a].delta_x
    s.way_y = long_b * motions[b].delta_y - long_a * motions[a].delta_y
    s.angle_a = start_a * motions[a].delta_angle
    s.angle_b = start_b * motions[b].delta_angle
    s.creep = CREEP_LINKED if holds[a].linked + holds[b].linked > 0 else CREEP
    s.turn_a = long_a * motions[a].delta_angle
    s.turn_b = long_b * motions[b].delta_angle


@kernel
def hit(shapes: Records, turned: Records, i: int, j: int, manifold: Records, sweep: Records, swept: Records) -> float:
    """When the pair whose way is laid in `sweep` touches on its way into each other; -1 if it does not go there."""
    a = shapes[i]
    b = shapes[j]
    sweep[0].deep = allowed_depth(a, b)
    sweep[0].thin = a.thin + b.thin
    t = time_of_hit(
        turned, a.vertex_start, a.vertex_count, a.radius, b.vertex_start, b.vertex_count, b.radius, sweep, swept,
        manifold,
    )  # fmt: skip
    return float(t)
