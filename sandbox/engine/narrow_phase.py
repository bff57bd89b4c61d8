"""Stage: the separating-axis test decides each proposed pair and keeps what is known of it from the last step."""

from __future__ import annotations

import math

from sandbox._jit import ZERO, inlined_kernel, kernel
from sandbox.engine.bounds import pair_margin
from sandbox.engine.continuous import allowed_depth
from sandbox.engine.islands import is_active
from sandbox.engine.one_way import comes_from_front, leads_on
from sandbox.engine.seams import mend_contact
from sandbox.geometry.manifold import collide_cores
from sandbox.geometry.time_of_touch import time_of_touch
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED, STATIC

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""
_SLOP_SHARE = 0.05
"""Share of the margin within which a fast pair counts as touching already."""


@kernel
def find_contacts(
    bodies: Records,
    flights: Records,
    holds: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    pairs: Records,
    pair_count: int,
    fall: float,
    seconds: float,
    manifold: Records,
    old: Records,
    old_count: int,
    contacts: Records,
) -> int:
    """Write a contact for every pair that touches or will touch within `seconds`; return how many.

    `fall` (m) is what gravity adds to a way within that time. Pairs and old contacts are both sorted by (shape_a,
    shape_b): one walk through both matches them, and impulses of points with the same feature id carry over (warm
    starting). Contacts among sleeping bodies, which the grid does not propose, are kept as they are.
    """
    _mark_hemmed(bodies, flights, holds, shapes, pairs, pair_count)
    count = ZERO
    k = 0
    for i in range(pair_count):
        shape_a = pairs[i].shape_a
        shape_b = pairs[i].shape_b
        while k < old_count and _comes_before(old[k], shape_a, shape_b):
            count = _keep_if_asleep(bodies, old[k], contacts, count)
            k += 1
        contact = contacts[count]
        if not _meet(bodies, flights, holds, shapes, turned, seams, shape_a, shape_b, fall, seconds, manifold, contact):
            continue
        known = k < old_count and old[k].shape_a == shape_a and old[k].shape_b == shape_b
        one_way = (shapes[shape_a].traits | shapes[shape_b].traits) & ONE_WAY
        if one_way and not _lands(bodies, shapes, turned, shape_a, shape_b, known, contact):
            continue
        if known:
            _match(old[k], contact)
        count += 1
    for i in range(k, old_count):
        count = _keep_if_asleep(bodies, old[i], contacts, count)
    return count


@kernel
def _lands(bodies: Records, shapes: Records, turned: Records, i: int, j: int, known: bool, contact: Records) -> bool:
    """Whether the contact of a pair, one of them one-way, is one that holds; `known` if it did so in the last step."""
    if not leads_on(bodies, shapes, i, j, contact.normal_x, contact.normal_y):
        return False
    a = bodies[shapes[i].body]
    b = bodies[shapes[j].body]
    slop = allowed_depth(shapes[i], shapes[j])
    return known or comes_from_front(
        bodies, shapes, turned, i, j, b.center_x - a.center_x, b.center_y - a.center_y, slop
    )


@kernel
def _mark_hemmed(
    bodies: Records, flights: Records, holds: Records, shapes: Records, pairs: Records, pair_count: int
) -> None:
    """Mark the bodies that something immovable may stop during the step."""
    for i in range(bodies.shape[0]):
        flights[i].hemmed = 0
        holds[i].deep = 0
    for i in range(pair_count):
        a = shapes[pairs[i].shape_a].body
        b = shapes[pairs[i].shape_b].body
        if not is_active(bodies[a]):
            flights[b].hemmed = 1
        elif not is_active(bodies[b]):
            flights[a].hemmed = 1


@inlined_kernel
def _is_hemmed(flights: Records, a: int, b: int) -> bool:
    """Whether the velocities of two bodies may change within the step, so that their difference says too little."""
    return bool(flights[a].hemmed + flights[b].hemmed > 0)


@inlined_kernel
def _comes_before(contact: Records, shape_a: int, shape_b: int) -> bool:
    first = contact.shape_a
    return bool(first < shape_a or (first == shape_a and contact.shape_b < shape_b))


@kernel
def _keep_if_asleep(bodies: Records, old: Records, contacts: Records, count: int) -> int:
    """Append an old contact if one of its bodies sleeps and none is active; return the new count."""
    a = bodies[old.body_a]
    b = bodies[old.body_b]
    if is_active(a) or is_active(b) or a.awake + b.awake == 2:
        return count
    contacts[count] = old
    return count + 1


@inlined_kernel
def _meet(
    bodies: Records,
    flights: Records,
    holds: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    fall: float,
    seconds: float,
    manifold: Records,
    contact: Records,
) -> bool:
    """Fill the contact of a pair, if its shapes touch, or nearly, or will within the step.

    A pair that closes in faster than its margin is looked at where it will first touch: the axis there is the one that
    stops it, while the axis at the start would deflect bodies that only pass by. Where a body spins so fast that its
    way bends by more than the margin, no axis of now says anything: it is not looked ahead, but caught when it touches
    (`continuous`).
    """
    a = bodies[shapes[i].body]
    b = bodies[shapes[j].body]
    margin = pair_margin(a, b)
    vx = b.velocity_x - a.velocity_x
    vy = b.velocity_y - a.velocity_y
    hemmed = _is_hemmed(flights, shapes[i].body, shapes[j].body)
    speed = math.sqrt(vx * vx + vy * vy)
    if hemmed and is_active(a) and is_active(b):
        speed = speed + math.sqrt(a.velocity_x * a.velocity_x + a.velocity_y * a.velocity_y)
        speed = speed + math.sqrt(b.velocity_x * b.velocity_x + b.velocity_y * b.velocity_y)
    swing = abs(a.angular_velocity) * (a.extent - shapes[i].radius)
    swing = seconds * (swing + abs(b.angular_velocity) * (b.extent - shapes[j].radius))
    way = seconds * speed + swing
    t = 0.0
    bends = way > margin and _is_watched(a, b) and _bend(a, shapes[i], seconds) + _bend(b, shapes[j], seconds) > margin
    if bends:
        margin = _SLOP_SHARE * margin
    elif way > margin:
        slop = _SLOP_SHARE * margin + fall + swing
        t = _touch(bodies, shapes, turned, i, j, vx, vy, seconds, slop, manifold)
        if t < 0.0 and hemmed and is_active(a) and is_active(b):
            # Either of them may be stopped within the step: what if only the other one moves?
            for only_a in range(2):
                if t < 0.0:
                    vx = -a.velocity_x if only_a == 1 else b.velocity_x
                    vy = -a.velocity_y if only_a == 1 else b.velocity_y
                    t = _touch(bodies, shapes, turned, i, j, vx, vy, seconds, slop, manifold)
        if t < 0.0:
            return False
        margin = way
    if not _collide(bodies, shapes, turned, i, j, vx * t, vy * t, margin, manifold):
        return False
    if (shapes[i].traits | shapes[j].traits) & SEAMED:
        t = _mend(bodies, shapes, turned, seams, i, j, vx, vy, t, seconds, margin, manifold)
        if t < 0.0:
            return False
    _fill(bodies, shapes, i, j, vx * t, vy * t, manifold[0], contact)
    overlap = -manifold[0].separation
    if overlap > 0.0 and (a.type == STATIC) != (b.type == STATIC) and overlap > allowed_depth(shapes[i], shapes[j]):
        holds[shapes[i].body].deep = 1
        holds[shapes[j].body].deep = 1
    return True


@kernel
def _mend(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    vx: float,
    vy: float,
    t: float,
    seconds: float,
    margin: float,
    manifold: Records,
) -> float:
    """Make the manifold of a pair with seams one that its wholes have; the time it is of, -1 if there is none.

    What is fast may first touch a part across a seam: it is looked at where the step will bring it.
    """
    x = bodies[shapes[j].body].center_x - bodies[shapes[i].body].center_x
    y = bodies[shapes[j].body].center_y - bodies[shapes[i].body].center_y
    now = t == 0.0
    while not mend_contact(
        bodies, shapes, turned, seams, i, j, x + vx * t, y + vy * t, vx * seconds, vy * seconds, margin, FACE_BIAS,
        now, manifold,
    ):  # fmt: skip
        if now or t == seconds:
            return -1.0
        t = seconds
        if not _collide(bodies, shapes, turned, i, j, vx * t, vy * t, margin, manifold):
            return -1.0
    return t


@inlined_kernel
def _is_watched(a: Records, b: Records) -> bool:
    """Whether `continuous` keeps two bodies from passing through each other."""
    return bool(a.type == STATIC or b.type == STATIC or a.bullet + b.bullet > 0)


@inlined_kernel
def _bend(body: Records, shape: Records, seconds: float) -> float:
    """How far the way of a shape's outermost point bends away from its tangent within the step, in metres."""
    turn = seconds * body.angular_velocity
    return float(0.5 * turn * turn * (body.extent - shape.thin))


@kernel
def _touch(
    bodies: Records,
    shapes: Records,
    turned: Records,
    i: int,
    j: int,
    vx: float,
    vy: float,
    seconds: float,
    slop: float,
    manifold: Records,
) -> float:
    """Time until two shapes touch, if b moves against a by (vx, vy) m/s; -1 if they do not within `seconds`."""
    a = shapes[i]
    b = shapes[j]
    return time_of_touch(
        turned,
        a.vertex_start,
        a.vertex_count,
        a.radius,
        b.vertex_start,
        b.vertex_count,
        b.radius,
        bodies[b.body].center_x - bodies[a.body].center_x,
        bodies[b.body].center_y - bodies[a.body].center_y,
        vx,
        vy,
        seconds,
        slop,
        manifold,
    )


@inlined_kernel
def _collide(
    bodies: Records,
    shapes: Records,
    turned: Records,
    i: int,
    j: int,
    shift_x: float,
    shift_y: float,
    margin: float,
    manifold: Records,
) -> bool:
    """Manifold of a pair of shapes, with b moved against a by (shift_x, shift_y) metres."""
    a = shapes[i]
    b = shapes[j]
    return (
        collide_cores(
            turned,
            a.vertex_start,
            a.vertex_count,
            a.radius,
            b.vertex_start,
            b.vertex_count,
            b.radius,
            bodies[b.body].center_x - bodies[a.body].center_x + shift_x,
            bodies[b.body].center_y - bodies[a.body].center_y + shift_y,
            margin,
            FACE_BIAS,
            manifold,
        )
        > 0
    )


@inlined_kernel
def _fill(
    bodies: Records,
    shapes: Records,
    i: int,
    j: int,
    shift_x: float,
    shift_y: float,
    m: Records,
    contact: Records,
) -> None:
    """Copy a manifold into a fresh contact and mix the surfaces of its shapes.

    The manifold is of the moment when b has moved against a by (shift_x, shift_y) metres: gaps are taken back to now.
    """
    a = shapes[i]
    b = shapes[j]
    dx = bodies[b.body].center_x - bodies[a.body].center_x + shift_x
    dy = bodies[b.body].center_y - bodies[a.body].center_y + shift_y
    ahead = -(shift_x * m.normal_x + shift_y * m.normal_y)
    contact.shape_a = i
    contact.shape_b = j
    contact.body_a = a.body
    contact.body_b = b.body
    contact.normal_x = m.normal_x
    contact.normal_y = m.normal_y
    contact.friction = math.sqrt(a.friction * b.friction)
    contact.restitution = a.restitution if a.restitution > b.restitution else b.restitution
    rolling = a.rolling_resistance if a.rolling_resistance > b.rolling_resistance else b.rolling_resistance
    contact.rolling_resistance = rolling
    contact.surface_speed = a.surface_speed + b.surface_speed
    contact.radius_a = a.radius
    contact.radius_b = b.radius
    contact.rolling_impulse = 0.0
    contact.impact_impulse = 0.0
    contact.touching = 0
    contact.point_count = m.point_count
    contact.anchor_ax1 = m.x1
    contact.anchor_ay1 = m.y1
    contact.anchor_bx1 = m.x1 - dx
    contact.anchor_by1 = m.y1 - dy
    contact.separation1 = m.separation1 + ahead
    contact.feature1 = m.feature1
    contact.normal_impulse1 = 0.0
    contact.tangent_impulse1 = 0.0
    two = m.point_count == 2
    contact.anchor_ax2 = m.x2 if two else 0.0
    contact.anchor_ay2 = m.y2 if two else 0.0
    contact.anchor_bx2 = m.x2 - dx if two else 0.0
    contact.anchor_by2 = m.y2 - dy if two else 0.0
    contact.separation2 = m.separation2 + ahead if two else 0.0
    contact.feature2 = m.feature2 if two else -1
    contact.normal_impulse2 = 0.0
    contact.tangent_impulse2 = 0.0


@inlined_kernel
def _match(old: Records, contact: Records) -> None:
    """Carry impulses over from the points of the last step with the same feature ids."""
    contact.touching = old.touching
    contact.rolling_impulse = old.rolling_impulse
    if contact.feature1 == old.feature1:
        contact.normal_impulse1 = old.normal_impulse1
        contact.tangent_impulse1 = old.tangent_impulse1
    elif contact.feature1 == old.feature2 and old.point_count == 2:
        contact.normal_impulse1 = old.normal_impulse2
        contact.tangent_impulse1 = old.tangent_impulse2
    if contact.point_count == 2:
        if contact.feature2 == old.feature2 and old.point_count == 2:
            contact.normal_impulse2 = old.normal_impulse2
            contact.tangent_impulse2 = old.tangent_impulse2
        elif contact.feature2 == old.feature1:
            contact.normal_impulse2 = old.normal_impulse1
            contact.tangent_impulse2 = old.tangent_impulse1
