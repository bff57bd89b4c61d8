"""Stage: the separating-axis test decides each proposed pair and keeps what is known of it from the last step."""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bounds import shape_margin
from sandbox.engine.islands import is_active
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Records

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""


@kernel
def find_contacts(
    bodies: Records,
    flights: Records,
    shapes: Records,
    turned: Records,
    pairs: Records,
    pair_count: int,
    seconds: float,
    manifold: Records,
    old: Records,
    old_count: int,
    contacts: Records,
) -> int:
    """Write a contact for every pair that touches or may touch within `seconds`; return how many.

    Pairs and old contacts are both sorted by (shape_a, shape_b): one walk through both matches them, and impulses
    of points with the same feature id carry over (warm starting). Contacts among sleeping bodies, which the grid does
    not propose, are kept as they are.
    """
    _mark_hemmed(bodies, flights, shapes, pairs, pair_count)
    count = 0
    k = 0
    for i in range(pair_count):
        shape_a = pairs[i].shape_a
        shape_b = pairs[i].shape_b
        while k < old_count and _comes_before(old[k], shape_a, shape_b):
            count = _keep_if_asleep(bodies, old[k], contacts, count)
            k += 1
        hemmed = _is_hemmed(flights, shapes[shape_a].body, shapes[shape_b].body)
        if not _collide(bodies, shapes, turned, shape_a, shape_b, seconds, hemmed, manifold):
            continue
        contact = contacts[count]
        _fill(bodies, shapes, shape_a, shape_b, manifold[0], contact)
        if not hemmed and _cannot_close(bodies, contact, seconds):
            continue
        if k < old_count and old[k].shape_a == shape_a and old[k].shape_b == shape_b:
            _match(old[k], contact)
        count += 1
    for i in range(k, old_count):
        count = _keep_if_asleep(bodies, old[i], contacts, count)
    return count


@kernel
def _mark_hemmed(bodies: Records, flights: Records, shapes: Records, pairs: Records, pair_count: int) -> None:
    """Mark the bodies that something immovable may stop during the step."""
    for i in range(bodies.shape[0]):
        flights[i].hemmed = 0
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
def _collide(
    bodies: Records, shapes: Records, turned: Records, i: int, j: int, seconds: float, hemmed: bool, manifold: Records
) -> bool:
    """Manifold of one pair of shapes, looking ahead as far as the bodies can close in during the step."""
    a = shapes[i]
    b = shapes[j]
    body_a = bodies[a.body]
    body_b = bodies[b.body]
    margin_a = shape_margin(body_a.extent)
    margin_b = shape_margin(body_b.extent)
    margin = 2.0 * (margin_a if margin_a < margin_b else margin_b)
    speed = _closing_speed(body_a, body_b, hemmed)
    spin = abs(body_a.angular_velocity) * body_a.extent + abs(body_b.angular_velocity) * body_b.extent
    way = seconds * (speed + spin)
    return (
        collide_cores(
            turned,
            a.vertex_start,
            a.vertex_count,
            a.radius,
            b.vertex_start,
            b.vertex_count,
            b.radius,
            body_b.center_x - body_a.center_x,
            body_b.center_y - body_a.center_y,
            margin if margin > way else way,
            FACE_BIAS,
            manifold,
        )
        > 0
    )


@inlined_kernel
def _closing_speed(a: Records, b: Records, hemmed: bool) -> float:
    """Bound of how fast two centres can close in, in m/s: either may be stopped within the step if they are hemmed."""
    if hemmed:
        fast_a = math.sqrt(a.velocity_x * a.velocity_x + a.velocity_y * a.velocity_y)
        return fast_a + math.sqrt(b.velocity_x * b.velocity_x + b.velocity_y * b.velocity_y)
    vx = b.velocity_x - a.velocity_x
    vy = b.velocity_y - a.velocity_y
    return math.sqrt(vx * vx + vy * vy)


@inlined_kernel
def _fill(bodies: Records, shapes: Records, i: int, j: int, m: Records, contact: Records) -> None:
    """Copy a manifold into a fresh contact and mix the surfaces of its shapes."""
    a = shapes[i]
    b = shapes[j]
    dx = bodies[b.body].center_x - bodies[a.body].center_x
    dy = bodies[b.body].center_y - bodies[a.body].center_y
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
    contact.point_count = m.point_count
    contact.anchor_ax1 = m.x1
    contact.anchor_ay1 = m.y1
    contact.anchor_bx1 = m.x1 - dx
    contact.anchor_by1 = m.y1 - dy
    contact.separation1 = m.separation1
    contact.feature1 = m.feature1
    contact.normal_impulse1 = 0.0
    contact.tangent_impulse1 = 0.0
    two = m.point_count == 2
    contact.anchor_ax2 = m.x2 if two else 0.0
    contact.anchor_ay2 = m.y2 if two else 0.0
    contact.anchor_bx2 = m.x2 - dx if two else 0.0
    contact.anchor_by2 = m.y2 - dy if two else 0.0
    contact.separation2 = m.separation2 if two else 0.0
    contact.feature2 = m.feature2 if two else -1
    contact.normal_impulse2 = 0.0
    contact.tangent_impulse2 = 0.0


@inlined_kernel
def _cannot_close(bodies: Records, contact: Records, seconds: float) -> bool:
    """True when no point of a contact can close within the step: then it would only act as a ghost wall."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    margin_a = shape_margin(a.extent)
    margin_b = shape_margin(b.extent)
    margin = 2.0 * (margin_a if margin_a < margin_b else margin_b)
    if contact.separation1 <= margin:
        return False
    if contact.point_count == 2 and contact.separation2 <= margin:
        return False
    close1 = _closing_way(a, b, contact, contact.anchor_ax1, contact.anchor_ay1, seconds)
    if contact.separation1 <= close1 + margin:
        return False
    if contact.point_count == 1:
        return True
    close2 = _closing_way(a, b, contact, contact.anchor_ax2, contact.anchor_ay2, seconds)
    return bool(contact.separation2 > close2 + margin)


@kernel
def _closing_way(a: Records, b: Records, contact: Records, x: float, y: float, seconds: float) -> float:
    """How far the surfaces close in at a point (from the centre of a) within `seconds`, in metres."""
    bx = x - (b.center_x - a.center_x)
    by = y - (b.center_y - a.center_y)
    vx = b.velocity_x - b.angular_velocity * by - a.velocity_x + a.angular_velocity * y
    vy = b.velocity_y + b.angular_velocity * bx - a.velocity_y - a.angular_velocity * x
    return float(-seconds * (vx * contact.normal_x + vy * contact.normal_y))


@inlined_kernel
def _match(old: Records, contact: Records) -> None:
    """Carry impulses over from the points of the last step with the same feature ids."""
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
