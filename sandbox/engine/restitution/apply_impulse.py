"""What the blow of one contact does to its two bodies: along the normal, and by friction along the tangent."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.prepare import effective_mass
from sandbox.tables import Records


@kernel
def push(
    a: Records, b: Records, motions: Records, flights: Records, contact: Records, impulse: float, point: int
) -> None:
    """Apply a normal impulse at a point."""
    ax, ay, bx, by = _where_it_strikes(a, b, contact, point)
    px = impulse * contact.normal_x
    py = impulse * contact.normal_y
    _apply(a, b, motions, flights, contact, px, py, ax, ay, bx, by)


@kernel
def rub(
    a: Records,
    b: Records,
    motions: Records,
    flights: Records,
    contact: Records,
    load: float,
    before: float,
    point: int,
) -> float:
    """Coulomb friction of the impact: stop the sliding at a point, as far as the normal impulse `load` allows.

    `before` (N s) has been applied already; returns what has been after this.
    """
    if contact.friction <= 0.0:
        return 0.0
    ax, ay, bx, by = _where_it_strikes(a, b, contact, point)
    tx = contact.normal_y
    ty = -contact.normal_x
    fa = flights[contact.body_a]
    fb = flights[contact.body_b]
    vx = fb.start_x - fb.start_w * by - fa.start_x + fa.start_w * ay
    vy = fb.start_y + fb.start_w * bx - fa.start_y - fa.start_w * ax
    speed = vx * tx + vy * ty - contact.surface_speed
    limit = contact.friction * load
    after = before - effective_mass(a, b, ax, ay, bx, by, tx, ty) * speed
    after = after if after < limit else limit
    after = after if after > -limit else -limit
    impulse = after - before
    _apply(a, b, motions, flights, contact, impulse * tx, impulse * ty, ax, ay, bx, by)
    return float(after)


@kernel
def _where_it_strikes(a: Records, b: Records, contact: Records, point: int) -> tuple[float, float, float, float]:
    """Anchors (m) of a point on both surfaces, from the centres of a and b.

    The contact has them half way between the surfaces, which were apart still when it was found; but the blow falls
    when they have met, and half a gap would be a longer arm for its friction.
    """
    first = point == 1
    ax = contact.anchor_ax1 if first else contact.anchor_ax2
    ay = contact.anchor_ay1 if first else contact.anchor_ay2
    bx = contact.anchor_bx1 if first else contact.anchor_bx2
    by = contact.anchor_by1 if first else contact.anchor_by2
    separation = contact.separation1 if first else contact.separation2
    # The contact was found where b had come nearer by this: the gap is what was left there.
    nearer = (b.center_x + bx - a.center_x - ax) * contact.normal_x
    nearer = nearer + (b.center_y + by - a.center_y - ay) * contact.normal_y
    half = 0.5 * (separation - nearer)
    half = half if half > 0.0 else 0.0
    x = half * contact.normal_x
    y = half * contact.normal_y
    return ax - x, ay - y, bx + x, by + y


@kernel
def _apply(
    a: Records,
    b: Records,
    motions: Records,
    flights: Records,
    contact: Records,
    px: float,
    py: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
) -> None:
    """Apply the impulse (px, py) N s to b at its anchor and the opposite to a at its own."""
    ia = contact.body_a
    ib = contact.body_b
    turn_a = -a.inverse_inertia * (ax * py - ay * px)
    turn_b = b.inverse_inertia * (bx * py - by * px)
    _kick(motions[ia], flights[ia], -a.inverse_mass * px, -a.inverse_mass * py, turn_a)
    _kick(motions[ib], flights[ib], b.inverse_mass * px, b.inverse_mass * py, turn_b)


@kernel
def _kick(motion: Records, flight: Records, x: float, y: float, w: float) -> None:
    """Change a body's velocity at the start of the substep and everything derived from it."""
    flight.start_x += x
    flight.start_y += y
    flight.start_w += w
    flight.free_x += x
    flight.free_y += y
    flight.free_w += w
    motion.velocity_x = flight.free_x
    motion.velocity_y = flight.free_y
    motion.angular_velocity = flight.free_w
