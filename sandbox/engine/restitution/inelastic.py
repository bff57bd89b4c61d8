"""Blows without restitution: both points of a contact stop at once, while friction brakes what slides.

Friction turns the bodies, which changes the speeds along the normal again; so both are found in rounds, with impulses
that accumulate and never pull. A normal round is the last, so that nothing leaves that should stay.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.restitution.apply_impulse import push, rub
from sandbox.engine.restitution.two_point_block import pair_impulses
from sandbox.tables import Records

_ROUNDS = 16
_SLOW = 0.2
"""Speed (m/s) below which a point is left to the solver."""


@kernel
def speed_to_lose(gap: float, start: float, other_end: float, seconds: float) -> float:
    """Change of normal velocity (m/s) that brings a point to the touch and no farther; 0 if the solver may do it.

    Within the coming substep it may close its `gap` (m); `other_end` is what would be left of that. When `seconds` are
    negative it has gone, and stops where it is near the touch.
    """
    near = gap <= _SLOW * abs(seconds)
    if other_end > 0.0 if seconds > 0.0 else not near:
        return 0.0
    speed = -gap / seconds if seconds > 0.0 and gap > 0.0 else 0.0
    return float(speed - start) if speed - start > _SLOW else 0.0


@kernel
def halt(
    a: Records, b: Records, motions: Records, flights: Records, contact: Records, change1: float, change2: float
) -> None:
    """Apply the normal impulses that give the wanted changes, and the friction that belongs to them."""
    load1 = load2 = drag1 = drag2 = 0.0
    for turn in range(_ROUNDS):
        new1, new2 = pair_impulses(a, b, contact, change1, change2)
        push(a, b, motions, flights, contact, new1 - load1, 1)
        push(a, b, motions, flights, contact, new2 - load2, 2)
        load1 = new1
        load2 = new2
        if contact.friction <= 0.0 or turn == _ROUNDS - 1:
            break
        before1 = _normal_speed(flights, contact, 1)
        before2 = _normal_speed(flights, contact, 2)
        drag1 = rub(a, b, motions, flights, contact, load1, drag1, 1)
        drag2 = rub(a, b, motions, flights, contact, load2, drag2, 2)
        if change1 > 0.0:
            change1 += before1 - _normal_speed(flights, contact, 1)
        if change2 > 0.0:
            change2 += before2 - _normal_speed(flights, contact, 2)
    contact.impact_impulse += load1 + load2


@kernel
def _normal_speed(flights: Records, contact: Records, point: int) -> float:
    """Speed (m/s) at which a point of b leaves that of a."""
    first = point == 1
    ax = contact.anchor_ax1 if first else contact.anchor_ax2
    ay = contact.anchor_ay1 if first else contact.anchor_ay2
    bx = contact.anchor_bx1 if first else contact.anchor_bx2
    by = contact.anchor_by1 if first else contact.anchor_by2
    fa = flights[contact.body_a]
    fb = flights[contact.body_b]
    x = fb.start_x - fb.start_w * by - fa.start_x + fa.start_w * ay
    y = fb.start_y + fb.start_w * bx - fa.start_y - fa.start_w * ax
    return float(x * contact.normal_x + y * contact.normal_y)
