"""Stage: islands that the usual substeps cannot hold are given more of them.

Soft contacts give way under load, so a slender pile buckles like a column of elastic joints, and one solver pass a
substep cannot carry a heavy body through a light one. Both get better with the square of the substep rate. A column
is safe while the sum of weight * height^2 over its bodies is less than 2.5 EI (A. G. Greenhill 1881; a load at the
top is Euler's case), and contacts with the angular frequency w over a width W have EI of about m w^2 W^3.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.active.body_flags import is_active
from sandbox.engine.active.islands import find_islands
from sandbox.engine.joints.fine_substeps import refine_small_parts
from sandbox.engine.joints.records import JointWork
from sandbox.geometry.trig import PI
from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import DYNAMIC

MOST = 4
"""Highest pace: an island of pace p takes 2**p times the scene's substeps."""
STIFFNESS = 0.6
"""Measured: a stack of 28 unit boxes just stands at 55 Hz."""
SAFE = 0.35
"""Largest share of the buckling load that an island bears at its pace."""
RATIO = 30.0
"""Largest ratio of a body's mass to that of one below it at pace 0; four times as much at each pace more."""
SINK = 0.02
"""Largest depth, as a share of the lower body's extent, to which a body may sink into that."""
EVERY = 8
"""Steps from one look at piles to the next, while no pile needs a pace and none can come to bear a heavy body."""
SELDOM = 1
"""`counter.pace_watch`: look every so many steps."""
ALWAYS = 2
"""`counter.pace_watch`: look at every step."""
UPRIGHT = 0.5
"""Smallest cosine between a contact's normal and gravity at which one body counts as lying on the other."""

PILE = Table(
    "pile",
    (
        Field("weight", "N", "of all bodies"),
        Field("moment", "N m", "weight times height above the root body"),
        Field("second_moment", "N m^2", "weight times height squared"),
        Field("bottom", "m", "lowest contact point, above the root body"),
        Field("left", "m", "first contact point across gravity, from the root body"),
        Field("right", "m", "last contact point across gravity"),
        Field("bodies", "-", "how many", "i8"),
        Field("heaviest", "kg", "of its bodies"),
        Field("bearer", "kg", "lightest body that another one lies on"),
        Field("slight", "m", "smallest extent of such a body"),
        Field("ratio", "1", "largest mass of a body by that of one below it"),
    ),
)
"""What a pile is made of; in the row of its island's root."""


@kernel
def assign_paces(
    bodies: Records,
    movers: Integers,
    flights: Records,
    piles: Records,
    contacts: Records,
    live: Integers,
    joints: JointWork | None,
    counter: Records,
    gravity_x: float,
    gravity_y: float,
    hertz: float,
) -> int:
    """Write every body's `flight.pace`: that of an island which needs one, or 0. Returns the paces in use, as bits.

    Piles need one that might fall, small jointed parts that swing freely get one for the sake of truth.
    """
    used = _assign_to_piles(
        bodies, movers, flights, piles, contacts, live, joints, counter, gravity_x, gravity_y, hertz
    )  # fmt: skip
    if joints is not None:
        used |= refine_small_parts(joints, bodies, flights, contacts, live)
    return used


@kernel
def _assign_to_piles(
    bodies: Records,
    movers: Integers,
    flights: Records,
    piles: Records,
    contacts: Records,
    live: Integers,
    joints: JointWork | None,
    counter: Records,
    gravity_x: float,
    gravity_y: float,
    hertz: float,
) -> int:
    """The paces that piles need.

    A look at the piles costs a pass over all contacts, and piles buckle slowly: where masses are alike and no pile
    needs a pace, every eighth step is enough. `counter.pace_watch` remembers that; commands set it to 0, unknown.
    """
    for i in movers:
        flights[i].pace = 0
    if counter.pace_watch == SELDOM and counter.step_count % EVERY != 0:
        return 1
    gravity = math.sqrt(gravity_x * gravity_x + gravity_y * gravity_y)
    omega = 2.0 * PI * hertz
    used = 1
    if gravity > 0.0:
        find_islands(bodies, movers, flights, contacts, live, joints)
        down_x = gravity_x / gravity
        down_y = gravity_y / gravity
        used = _look(bodies, movers, flights, piles, contacts, live, down_x, down_y, gravity, omega)
    counter.pace_watch = ALWAYS if used > 1 or _masses_differ(bodies, gravity, omega) else SELDOM
    return used


@kernel
def _look(
    bodies: Records,
    movers: Integers,
    flights: Records,
    piles: Records,
    contacts: Records,
    live: Integers,
    down_x: float,
    down_y: float,
    gravity: float,
    omega: float,
) -> int:
    """Bodies alone show that most islands are safe; only if one may not be, contacts are looked at too."""
    _measure_bodies(bodies, movers, flights, piles, down_x, down_y, gravity)
    if not _some_pile_may_fall(movers, flights, piles, omega, gravity):
        return 1
    _measure_contacts(bodies, movers, flights, piles, contacts, live, down_x, down_y)
    used = 1
    for i in movers:
        pile = piles[flights[i].island]
        if is_active(bodies[i]) and pile.ratio > 0.0:
            flights[i].pace = _pace(pile, omega, gravity)
            used |= 1 << flights[i].pace
    return used


@kernel
def _masses_differ(bodies: Records, gravity: float, omega: float) -> bool:
    """Whether some dynamic body would be too heavy for some other one at pace 0."""
    heaviest = 0.0
    lightest = slight = 1e300
    for i in range(bodies.shape[0]):
        body = bodies[i]
        if body.type == DYNAMIC:
            heaviest = body.mass if body.mass > heaviest else heaviest
            lightest = body.mass if body.mass < lightest else lightest
            slight = body.extent if body.extent < slight else slight
    return heaviest > lightest * _bearable(slight, gravity, omega)


@kernel
def _bearable(slight: float, gravity: float, omega: float) -> float:
    """Largest ratio of a body's mass to that of one of that extent below it, at pace 0."""
    if SINK * slight * omega * omega < RATIO * gravity:
        return SINK * slight * omega * omega / gravity
    return RATIO


@kernel
def contact_pace(bodies: Records, flights: Records, contact: Records) -> int:
    """The pace a contact is solved at; -1 among bodies that are not moved."""
    if is_active(bodies[contact.body_a]):
        pace: int = flights[contact.body_a].pace
        return pace
    if is_active(bodies[contact.body_b]):
        other: int = flights[contact.body_b].pace
        return other
    return -1


@kernel
def _measure_bodies(
    bodies: Records, movers: Integers, flights: Records, piles: Records, down_x: float, down_y: float, gravity: float
) -> None:
    """Weight and height of every pile; of its width, foot, bearing body and ratio what is worst for it."""
    for i in movers:
        pile = piles[i]
        pile.bodies = 0
        pile.weight = pile.moment = pile.second_moment = pile.heaviest = 0.0
        pile.bottom = pile.left = pile.bearer = pile.slight = 1e300
        pile.right = -1e300
    for i in movers:
        body = bodies[i]
        if not is_active(body):
            continue
        root = flights[i].island
        pile = piles[root]
        x = body.center_x - bodies[root].center_x
        y = body.center_y - bodies[root].center_y
        height = -(x * down_x + y * down_y)
        weight = body.mass * gravity * (body.gravity_scale if body.gravity_scale > 0.0 else 0.0)
        pile.bodies += 1
        pile.weight += weight
        pile.moment += weight * height
        pile.second_moment += weight * height * height
        _widen(pile, x * down_y - y * down_x)
        pile.bottom = height - body.extent if height - body.extent < pile.bottom else pile.bottom
        pile.heaviest = body.mass if body.mass > pile.heaviest else pile.heaviest
        pile.bearer = body.mass if body.mass < pile.bearer else pile.bearer
        pile.slight = body.extent if body.extent < pile.slight else pile.slight


@kernel
def _widen(pile: Records, across: float) -> None:
    pile.left = across if across < pile.left else pile.left
    pile.right = across if across > pile.right else pile.right


@kernel
def _some_pile_may_fall(movers: Integers, flights: Records, piles: Records, omega: float, gravity: float) -> bool:
    """Whether some pile of two or more would need a higher pace if it were as bad as its bodies allow."""
    for i in movers:
        if flights[i].island == i and piles[i].bodies > 1:
            piles[i].ratio = piles[i].heaviest / piles[i].bearer
            if _pace(piles[i], omega, gravity) > 0:
                return True
    return False


@kernel
def _measure_contacts(
    bodies: Records,
    movers: Integers,
    flights: Records,
    piles: Records,
    contacts: Records,
    live: Integers,
    down_x: float,
    down_y: float,
) -> None:
    """Width, foot, bearing bodies and ratio of every pile, as they are; the ratio stays 0 where nothing is borne."""
    for i in movers:
        pile = piles[i]
        pile.ratio = 0.0
        pile.bottom = pile.left = pile.bearer = pile.slight = 1e300
        pile.right = -1e300
    for i in live:
        contact = contacts[i]
        a = bodies[contact.body_a]
        b = bodies[contact.body_b]
        if not (is_active(a) or is_active(b)):
            continue
        root = flights[contact.body_a].island if is_active(a) else flights[contact.body_b].island
        pile = piles[root]
        x = a.center_x - bodies[root].center_x
        y = a.center_y - bodies[root].center_y
        _add_point(pile, x + contact.anchor_ax1, y + contact.anchor_ay1, down_x, down_y)
        if contact.point_count == 2:
            _add_point(pile, x + contact.anchor_ax2, y + contact.anchor_ay2, down_x, down_y)
        upright = contact.normal_x * down_x + contact.normal_y * down_y
        if is_active(a) and is_active(b) and abs(upright) >= UPRIGHT:
            _add_bearer(pile, b if upright > 0.0 else a, a if upright > 0.0 else b)


@kernel
def _add_point(pile: Records, x: float, y: float, down_x: float, down_y: float) -> None:
    height = -(x * down_x + y * down_y)
    pile.bottom = height if height < pile.bottom else pile.bottom
    _widen(pile, x * down_y - y * down_x)


@kernel
def _add_bearer(pile: Records, lower: Records, upper: Records) -> None:
    ratio = upper.mass * lower.inverse_mass
    pile.ratio = ratio if ratio > pile.ratio else pile.ratio
    pile.bearer = lower.mass if lower.mass < pile.bearer else pile.bearer
    pile.slight = lower.extent if lower.extent < pile.slight else pile.slight


@kernel
def _pace(pile: Records, omega: float, gravity: float) -> int:
    """How many times the substeps have to be doubled for this pile."""
    width = pile.right - pile.left
    width = width if width > 0.5 * pile.slight else 0.5 * pile.slight
    foot = pile.bottom
    load = pile.second_moment - 2.0 * foot * pile.moment + foot * foot * pile.weight
    bears = SAFE * STIFFNESS * pile.bearer * omega * omega * width * width * width
    ratio = _bearable(pile.slight, gravity, omega)
    pace = 0
    while pace < MOST and (load > bears or pile.ratio > ratio):
        bears = 4.0 * bears
        ratio = 4.0 * ratio
        pace += 1
    return pace
