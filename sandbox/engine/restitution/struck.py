"""Whom a hard impact without restitution concerns: what is struck, and what it will be pressed on.

A body that is struck goes on with what struck it, and closes in on what is in its way, which comes along in turn, ever
slower as there is more mass; as long as the next one is closed in on at more than `HARD`, it takes part. Contacts are
gone through until that reaches nobody else; one is looked at again only if one of its bodies has been reached since.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.contact_solver.closing_speed import HARD, closes_hard, closing_speed
from sandbox.engine.records.ccd import STRUCK
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records

IMMOVABLE = 1e30
"""Mass (kg) of what does not give way."""
FASTER = 1.01
"""Ratio of the squares of two speeds that an impact gives a body, for the faster to be followed further from there."""
_NEVER = -(1 << 60)


@kernel
def flag_struck(
    bodies: Records, contacts: Contacts, ccd_bodies: Records, reached_at: Integers, slots: Records, fastest: float
) -> None:
    """Give all bodies that a hard impact reaches the bit `STRUCK` of `ccd_bodies.unsettled`.

    `fastest` is the square of the highest speed (m/s) of a point. `reached_at`, with a row for each body, and `slots`,
    with one for each contact, are scratch.
    """
    if fastest <= 0.25 * HARD * HARD or not _strike(bodies, contacts, ccd_bodies):
        return
    count = _list_inelastic(contacts, slots)
    for k in range(count):
        for i in (slots[k].body_a, slots[k].body_b):
            reached_at[i] = 0 if ccd_bodies[i].unsettled & STRUCK else _NEVER
    look = 0
    spreads = True
    while spreads:
        spreads = False
        for k in range(count):
            a = slots[k].body_a
            b = slots[k].body_b
            before = look - count  # when this contact was looked at in the sweep before
            if reached_at[a] >= before or reached_at[b] >= before:
                contact = contacts.now[slots[k].contact]
                if _spread(bodies, ccd_bodies, contact, -1.0):
                    reached_at[b] = look
                    spreads = True
                if _spread(bodies, ccd_bodies, contact, 1.0):
                    reached_at[a] = look
                    spreads = True
            look += 1


@kernel
def _strike(bodies: Records, contacts: Contacts, ccd_bodies: Records) -> bool:
    """Flag the bodies that strike each other; return whether there are any."""
    strikes = False
    for k in range(1, contacts.impact_candidates[0] + 1):
        contact = contacts.now[contacts.impact_candidates[k]]
        a = bodies[contact.body_a]
        b = bodies[contact.body_b]
        if contact.restitution == 0.0 and closes_hard(a, b, contact):
            strikes = True
            first = closing_speed(a, b, contact, 1)
            second = closing_speed(a, b, contact, 2)
            speed = first if first > second else second
            _reach(bodies, ccd_bodies, contact, -1.0, speed, a.mass if is_active(a) else IMMOVABLE)
            _reach(bodies, ccd_bodies, contact, 1.0, speed, b.mass if is_active(b) else IMMOVABLE)
    return strikes


@kernel
def _list_inelastic(contacts: Contacts, slots: Records) -> int:
    """List the active contacts without restitution; returns how many."""
    count = 0
    for row in contacts.active[1 : 1 + contacts.active[0]]:
        contact = contacts.now[row]
        if contact.restitution == 0.0:
            slots[count].contact = row
            slots[count].body_a = contact.body_a
            slots[count].body_b = contact.body_b
            count += 1
    return count


@kernel
def _spread(bodies: Records, ccd_bodies: Records, contact: Records, side: float) -> bool:
    """Go on from a struck body to the other of a contact, b if `side` is -1; return whether that is news for it."""
    here = ccd_bodies[contact.body_a if side < 0.0 else contact.body_b]
    if here.unsettled & STRUCK == 0:
        return False
    gain = -side * (here.struck_x * contact.normal_x + here.struck_y * contact.normal_y)
    if gain <= 0.0:
        return False
    speed = gain + closing_speed(bodies[contact.body_a], bodies[contact.body_b], contact, 1)
    return _reach(bodies, ccd_bodies, contact, side, speed, here.struck_mass)


@kernel
def _reach(bodies: Records, ccd_bodies: Records, contact: Records, side: float, speed: float, mass: float) -> bool:
    """So much mass (kg) closes in on a body of a contact at so many m/s, on b if `side` is -1; return whether the
    impact goes on from there."""
    i = contact.body_b if side < 0.0 else contact.body_a
    if speed < HARD or not is_active(bodies[i]):
        return False
    here = ccd_bodies[i]
    gain = speed * (mass / (mass + bodies[i].mass))
    if here.unsettled & STRUCK and gain * gain <= FASTER * (
        here.struck_x * here.struck_x + here.struck_y * here.struck_y
    ):
        return False
    here.unsettled |= STRUCK
    here.struck_x = -side * gain * contact.normal_x
    here.struck_y = -side * gain * contact.normal_y
    here.struck_mass = mass + bodies[i].mass
    return True
