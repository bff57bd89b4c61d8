"""Whom impacts without restitution concern: what is struck, and what it will be pressed on.

A body that is struck goes on with what struck it, and closes in on what is in its way, which comes along in turn, ever
slower as there is more mass; as long as the next one is closed in on at more than some speed, it takes part. Impacts
past `SLOW` are followed down to `SLOWEST` where they reach so few bodies that they cost little, as when something falls
on a stack; elsewhere, as in a heap that is poured, only what closes in faster than `HARD` counts. Contacts are gone
through until that reaches nobody else; one is looked at again only if one of its bodies has been reached since.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.contact_solver.closing_speed import HARD, SLOW, fastest_closing, mean_closing, stops_by_several
from sandbox.engine.records.ccd import STRUCK
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records

IMMOVABLE = 1e30
"""Mass (kg) of what does not give way."""
FEW = 128
"""Bodies: where impacts reach more, only hard ones are followed."""
SLOWEST = 0.1 * SLOW
"""Speed (m/s): a box dropped by 1 cm on ten others rebounds with 4 % of its speed, if followed to 0.05 with 8 %."""
FASTER = 1.1
"""Ratio of the squares of two speeds that an impact gives a body, for the faster to be followed further from there."""
ACROSS = 1e-9
"""Share of the speed that an impact gives a body up to which it does not lead along the normal of a contact: sides of a
box are perpendicular but for rounding."""
_NEVER = -(1 << 60)


@kernel
def flag_struck(
    bodies: Records,
    contacts: Contacts,
    ccd_bodies: Records,
    reached_at: Integers,
    slots: Records,
    fastest: float,
    unit: float,
) -> float:
    """Give all bodies that impacts reach the bit `STRUCK` of `ccd_bodies.unsettled`; returns the speed (m/s) past which
    contacts that stop by several impulses have one.

    `fastest` is the square of the highest speed (m/s) of a point; a metre is so many units of length. `reached_at`,
    with a row for each body, and `slots`, with one for each contact, are scratch.
    """
    slow = SLOW * unit
    hard = HARD * unit
    slowest = SLOWEST * unit
    if fastest <= 0.25 * slow * slow or _follow(bodies, contacts, ccd_bodies, reached_at, slots, slow, slowest, FEW):
        return slow
    if fastest > 0.25 * hard * hard:
        _follow(bodies, contacts, ccd_bodies, reached_at, slots, hard, hard, bodies.shape[0])
    return hard


@kernel
def _follow(
    bodies: Records,
    contacts: Contacts,
    ccd_bodies: Records,
    reached_at: Integers,
    slots: Records,
    slowest: float,
    least: float,
    most: int,
) -> bool:
    """Flag the bodies that impacts past `slowest` (m/s) reach, followed as long as they close in at more than `least`.
    False, and nobody is flagged, if they are more than `most`."""
    reached = _strike(bodies, contacts, ccd_bodies, slowest, most)
    if reached == 0:
        return True
    count = _list_inelastic(contacts, slots) if reached <= most else 0
    for k in range(count):
        for i in (slots[k].body_a, slots[k].body_b):
            reached_at[i] = 0 if ccd_bodies[i].unsettled & STRUCK else _NEVER
    before = look = 0
    spreads = count > 0
    while spreads and reached <= most:
        spreads = False
        for k in range(count):
            a = slots[k].body_a
            b = slots[k].body_b
            if reached_at[a] >= before or reached_at[b] >= before:
                contact = contacts.now[slots[k].contact]
                for side, other in ((-1.0, b), (1.0, a)):
                    if _spread(bodies, ccd_bodies, contact, side, least):
                        reached += 1 if reached_at[other] == _NEVER else 0
                        reached_at[other] = look
                        spreads = True
            look += 1
            before = look - count  # when the next contact was looked at in the sweep before
    if reached <= most:
        return True
    _forget(contacts, ccd_bodies, slots, count)
    return False


@kernel
def _forget(contacts: Contacts, ccd_bodies: Records, slots: Records, count: int) -> None:
    """Flag nobody: neither those that strike each other nor those whose `count` contacts are listed."""
    for row in contacts.impact_candidates[1 : 1 + contacts.impact_candidates[0]]:
        ccd_bodies[contacts.now[row].body_a].unsettled &= ~STRUCK
        ccd_bodies[contacts.now[row].body_b].unsettled &= ~STRUCK
    for slot in slots[:count]:
        ccd_bodies[slot.body_a].unsettled &= ~STRUCK
        ccd_bodies[slot.body_b].unsettled &= ~STRUCK


@kernel
def _strike(bodies: Records, contacts: Contacts, ccd_bodies: Records, slowest: float, most: int) -> int:
    """Flag the bodies that strike each other; returns how many, or, once there are more than `most`, so many."""
    reached = 0
    for row in contacts.impact_candidates[1 : 1 + contacts.impact_candidates[0]]:
        contact = contacts.now[row]
        if contact.restitution > 0.0 or not stops_by_several(contact.point_count, contact.rolling_resistance):
            continue
        a = bodies[contact.body_a]
        b = bodies[contact.body_b]
        speed = fastest_closing(a, b, contact)
        if speed <= slowest:
            continue
        was = _struck(ccd_bodies, contact)
        _reach(bodies, ccd_bodies, contact, -1.0, speed, a.mass if is_active(a) else IMMOVABLE, slowest)
        _reach(bodies, ccd_bodies, contact, 1.0, speed, b.mass if is_active(b) else IMMOVABLE, slowest)
        reached += _struck(ccd_bodies, contact) - was
        if reached > most:
            break
    return reached


@inlined_kernel
def _struck(ccd_bodies: Records, contact: Records) -> int:
    """How many bodies of a contact are flagged."""
    a = 1 if ccd_bodies[contact.body_a].unsettled & STRUCK else 0
    b = 1 if ccd_bodies[contact.body_b].unsettled & STRUCK else 0
    return a + b


@kernel
def _list_inelastic(contacts: Contacts, slots: Records) -> int:
    """List the active contacts without restitution; returns how many."""
    count = 0
    for slot in contacts.active[1 : 1 + contacts.active[0].contact]:
        if contacts.now[slot.contact].restitution == 0.0:
            slots[count] = slot
            count += 1
    return count


@kernel
def _spread(bodies: Records, ccd_bodies: Records, contact: Records, side: float, least: float) -> bool:
    """Go on from a struck body to the other of a contact, b if `side` is -1; return whether that is news for it."""
    here = ccd_bodies[contact.body_a if side < 0.0 else contact.body_b]
    if here.unsettled & STRUCK == 0:
        return False
    gain = -side * (here.struck_x * contact.normal_x + here.struck_y * contact.normal_y)
    if gain <= ACROSS * (abs(here.struck_x) + abs(here.struck_y)):
        return False
    speed = gain + mean_closing(bodies[contact.body_a], bodies[contact.body_b], contact)
    return _reach(bodies, ccd_bodies, contact, side, speed, here.struck_mass, least)


@kernel
def _reach(
    bodies: Records,
    ccd_bodies: Records,
    contact: Records,
    side: float,
    speed: float,
    mass: float,
    least: float,
) -> bool:
    """So much mass (kg) closes in on a body of a contact at so many m/s, on b if `side` is -1; return whether the
    impact goes on from there: it does if that is more than `least` (m/s)."""
    i = contact.body_b if side < 0.0 else contact.body_a
    if speed < least or not is_active(bodies[i]):
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
