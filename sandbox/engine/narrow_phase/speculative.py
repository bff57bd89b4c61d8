"""Speculative contacts: what will touch in the step has one now.

A pair that closes in faster than its margin is looked at where it will first touch: the axis there is the one that
stops it, while the axis at the start would deflect bodies that only pass by. So is a slower one that will touch; one
that will not, as far as is known, but is within its margin, is looked at where it is. Where a body spins so fast that
its path bends by more than the margin, no axis of now says anything: it has no speculative contact, but is swept
(`continuous_collision`).
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.proxies import ACTIVE, BULLET, FIXED, MAY_STOP
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Colliders
from sandbox.geometry.core import core_of
from sandbox.geometry.linear_cast import features_apart, linear_cast
from sandbox.tables import Records

_SLOP_SHARE = 0.05
"""Share of the margin within which a fast pair counts as touching already."""
_TOUCH_SHARE = 0.002
"""Share of the margin to which the moment of touch is found: what slides past meanwhile has another axis there."""


@kernel
def mark_may_stop(colliders: Colliders, active: ActiveSet, ccd_bodies: Records) -> None:
    """Tell the proxies of moving shapes whether something may stop their body; `select_pairs` has marked of which.

    The velocity of such a body may change within the step: what it has against another says too little.
    """
    filters = colliders.filters
    moving = active.shapes[: active.info[0].moving]
    found = False
    for i in moving:
        if filters[i].may_stop == 1:
            filters[i].may_stop = 0
            ccd_bodies[filters[i].body].may_stop = 1
            found = True
    if not found:
        return
    for i in moving:
        if ccd_bodies[filters[i].body].may_stop == 1:
            colliders.proxies[i].traits |= MAY_STOP
    for i in moving:
        ccd_bodies[filters[i].body].may_stop = 0


@inlined_kernel
def closing_distance(a: Records, b: Records, vx: float, vy: float, seconds: float) -> float:
    """Most (m) that two proxies can close in within the step; (vx, vy) is the velocity of b against a."""
    speed = math.sqrt(vx * vx + vy * vy)
    if (a.traits | b.traits) & MAY_STOP and a.traits & b.traits & ACTIVE:
        speed = speed + a.speed
        speed = speed + b.speed
    return float(seconds * speed + seconds * (a.swing + b.swing))


@kernel
def speculative_impact(
    bodies: Records,
    shapes: Records,
    proxies: Records,
    cores: Records,
    i: int,
    j: int,
    margin: float,
    fall: float,
    seconds: float,
) -> tuple[float, float, float, float]:
    """(time, vx, vy, margin): when a pair whose `closing_distance` is more than its margin is to be looked at.

    (vx, vy) is the velocity (m/s) of b against a that brings it there, the margin how far from touching it may be
    then (m). The time is -1 if it will not touch. `margin` is that of a slow pair.
    """
    a = proxies[i]
    b = proxies[j]
    vx = b.velocity_x - a.velocity_x
    vy = b.velocity_y - a.velocity_y
    watched = (a.traits | b.traits) & (FIXED | BULLET) != 0
    if watched and _bend(bodies, shapes, i, seconds) + _bend(bodies, shapes, j, seconds) > margin:
        return 0.0, vx, vy, _SLOP_SHARE * margin
    slop = _SLOP_SHARE * margin + fall + seconds * (a.swing + b.swing)
    distance = closing_distance(a, b, vx, vy, seconds)
    core_a = core_of(a)
    core_b = core_of(b)
    offset = (b.center_x - a.center_x, b.center_y - a.center_y)
    start = features_apart(cores, core_a, core_b, offset[0], offset[1])
    t = linear_cast(cores, core_a, core_b, start, offset, (vx, vy), seconds, slop)
    if t < 0.0 and (a.traits | b.traits) & MAY_STOP and a.traits & b.traits & ACTIVE:
        # Either of them may be stopped within the step: what if only the other one moves?
        for only_a in range(2):
            if t < 0.0:
                vx = -a.velocity_x if only_a == 1 else b.velocity_x
                vy = -a.velocity_y if only_a == 1 else b.velocity_y
                t = linear_cast(cores, core_a, core_b, start, offset, (vx, vy), seconds, slop)
    return t, vx, vy, distance


@kernel
def first_touch(
    proxies: Records, cores: Records, i: int, j: int, vx: float, vy: float, m: Records, margin: float, seconds: float
) -> float:
    """The time (s) at which a slow pair, whose manifold of now is within its margin, is to be looked at instead: where
    it first touches in the step; 0 if it touches already, or will not.

    (vx, vy) is the velocity (m/s) of b against a.
    """
    slop = _TOUCH_SHARE * margin
    if m.separation <= slop or m.separation + (vx * m.normal_x + vy * m.normal_y) * seconds > slop:
        return 0.0
    a = proxies[i]
    b = proxies[j]
    core_a = core_of(a)
    core_b = core_of(b)
    offset = (b.center_x - a.center_x, b.center_y - a.center_y)
    start = features_apart(cores, core_a, core_b, offset[0], offset[1])
    t = linear_cast(cores, core_a, core_b, start, offset, (vx, vy), seconds, slop)
    return t if t > 0.0 else 0.0


@inlined_kernel
def _bend(bodies: Records, shapes: Records, i: int, seconds: float) -> float:
    """How far the path of a shape's outermost point bends away from its tangent within the step, in metres."""
    body = bodies[shapes[i].body]
    turn = seconds * body.angular_velocity
    return float(0.5 * turn * turn * (body.extent - shapes[i].thin))
