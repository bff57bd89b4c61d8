"""How stable piles are: what columns of soft contacts bear before they buckle, and how heavy what lies on light is.

Soft contacts give way under load, so a slender pile buckles like a column of elastic joints, and one solver pass a
substep cannot carry a heavy body through a light one. Both get better with the square of the substep rate. A column
is safe while the sum of weight * height^2 over its bodies is less than 2.5 EI (A. G. Greenhill 1881; a load at the
top is Euler's case), and contacts with the angular frequency w over a width W have EI of about m w^2 W^3. Stiffness
only holds what is a frame: a pile with fewer forces, two at each contact point, than its bodies have degrees of freedom
is a mechanism (J. C. Maxwell, "On the calculation of the equilibrium and stiffness of frames", 1864).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.hinged_weight import hangs_by_one_hinge, hinged_mass, is_hung
from sandbox.engine.active.part_weight import add_member, add_part_weights, add_stand, begin_parts
from sandbox.engine.active.pile_support import ALL, Load, share_supported, upward_force
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import has_joints
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import DYNAMIC

MAX_LEVEL = 4
"""Highest substep level: an island of level p takes 2**p times the scene's substeps."""
STIFFNESS = 0.6
"""Measured: a stack of 28 unit boxes just stands at 55 Hz."""
SAFE = 0.35
"""Largest share of the buckling load that an island bears at its level."""
KEEPS = 0.5
"""Share of what an island could bear at a level up to which it goes back to that from a higher one."""
RATIO = 60.0
"""Largest ratio of what weighs on a body to its mass at level 0; four times as much at each level more."""
SINK = 0.02
"""Largest depth, as a share of the lower body's extent, to which a body may sink into that."""
SLOP = 0.005
"""Depth (m) to which it may sink in any case but where that is more than `MOST_SLOP`: Box2D's linear slop."""
MOST_SLOP = 0.05
"""Largest `SLOP`, as a share of the lower body's extent."""
UPRIGHT = 0.5
"""Smallest cosine between a contact's normal and gravity at which one body counts as lying on the other."""

_NONE = 1e300
"""The smallest of none."""
WITH_GONE = 2
"""`weighed` while the masses may be of bodies that have gone since."""

PILE = Table(
    "pile",
    (
        Field("weight", "N", "of all bodies that joints do not hold, and what those that are held press on them with"),
        Field("hangs", "-", "1 when joints hold some of it", "i8"),
        Field("support", "N", "upward force on it from outside in the last step: of what does not move, of fields"),
        Field("moment", "N m", "weight times height above the root body"),
        Field("second_moment", "N m^2", "weight times height squared"),
        Field("bottom", "m", "lowest contact point, above the root body"),
        Field("left", "m", "first contact point across gravity, from the root body"),
        Field("right", "m", "last contact point across gravity"),
        Field("bodies", "-", "how many", "i8"),
        Field("forces", "-", "at its contacts, and three for each of its bodies that has joints", "i8"),
        Field("degrees_of_freedom", "-", "of its bodies: three each, two of what does not turn", "i8"),
        Field("heaviest", "kg", "of its bodies"),
        Field("bearer", "kg", "lightest body that another one lies on"),
        Field("slight", "m", "smallest extent of such a body"),
        Field("ratio", "1", "largest mass that weighs on a body at one contact, by its own"),
        Field("level", "-", "finest substep level that a contact of it was solved at in the last step", "i8"),
    ),
)
"""What a pile is made of; in the row of its island's root."""


@kernel
def masses_differ(bodies: Records, info: Records, gravity: float, omega: float, unit: float) -> bool:
    """Whether some dynamic body would be too heavy for some other one at level 0. All are weighed if need be: those
    that have gone may have been the heaviest or the lightest, but where masses did not differ with them, they do not
    without."""
    if info.weighed == WITH_GONE and not _would_differ(info, gravity, omega, unit):
        return False
    if info.weighed != 1:
        info.heaviest = 0.0
        info.lightest = info.slight = _NONE
        for body in bodies:
            if body.type == DYNAMIC:
                weigh(info, body)
        info.weighed = 1
    return _would_differ(info, gravity, omega, unit)


@kernel
def _would_differ(info: Records, gravity: float, omega: float, unit: float) -> bool:
    return bool(info.heaviest > info.lightest * bearable(info.slight, gravity, omega, unit))


@inlined_kernel
def weigh(info: Records, body: Records) -> None:
    """Another dynamic body is there."""
    info.heaviest = body.mass if body.mass > info.heaviest else info.heaviest
    info.lightest = body.mass if body.mass < info.lightest else info.lightest
    info.slight = body.extent if body.extent < info.slight else info.slight


@kernel
def bearable(slight: float, gravity: float, omega: float, unit: float) -> float:
    """Largest ratio of a body's mass to that of one of that extent below it, at level 0, where a metre is so many units
    of length."""
    slop = SLOP * unit
    slop = slop if MOST_SLOP * slight > slop else MOST_SLOP * slight
    deep = SINK * slight if SINK * slight > slop else slop
    if deep * omega * omega < RATIO * gravity:
        return deep * omega * omega / gravity
    return RATIO


@kernel
def measure_bodies(
    bodies: Records, rows: Integers, islands: Integers, piles: Records, joints: JointWork, load: Load
) -> None:
    """Weight and height of piles of two or more; of all else what is worst for each."""
    jointed = has_joints(joints)
    down_x = load.down_x
    down_y = load.down_y
    for i in rows:
        piles[i].bodies = 1
    for i in rows:
        if islands[i] != i:
            piles[islands[i]].bodies += 1
    for i in rows:
        root = islands[i]
        pile = piles[root]
        if pile.bodies < 2:
            continue
        if root == i:  # the first of its pile
            pile.weight = pile.moment = pile.second_moment = pile.heaviest = 0.0
            pile.hangs = 0
            pile.forces = pile.degrees_of_freedom = 0
            pile.bottom = pile.left = pile.bearer = pile.slight = _NONE
            pile.right = -_NONE
            pile.support = ALL
        body = bodies[i]
        x = body.center_x - bodies[root].center_x
        y = body.center_y - bodies[root].center_y
        height = -(x * down_x + y * down_y)
        if jointed and is_hung(joints, i):
            pile.hangs = 1
        else:
            _add_weight(
                pile, body.mass * load.gravity * (body.gravity_scale if body.gravity_scale > 0.0 else 0.0), height
            )
        _widen(pile, x * down_y - y * down_x)
        pile.bottom = height - body.extent if height - body.extent < pile.bottom else pile.bottom
        pile.heaviest = body.mass if body.mass > pile.heaviest else pile.heaviest
        pile.bearer = body.mass if body.mass < pile.bearer else pile.bearer
        pile.slight = body.extent if body.extent < pile.slight else pile.slight


@inlined_kernel
def _add_weight(pile: Records, weight: float, height: float) -> None:
    pile.weight += weight
    pile.moment += weight * height
    pile.second_moment += weight * height * height


@kernel
def _widen(pile: Records, across: float) -> None:
    pile.left = across if across < pile.left else pile.left
    pile.right = across if across > pile.right else pile.right


@kernel
def some_pile_may_fall(rows: Integers, islands: Integers, piles: Records, load: Load) -> bool:
    """Whether some pile of two or more would need a higher level, or be overloaded, if it were as bad as its bodies
    allow. What hangs may weigh on what does not."""
    for i in rows:
        if islands[i] == i and piles[i].bodies > 1:
            piles[i].ratio = piles[i].heaviest / piles[i].bearer
            if level_for(piles[i], load) > 0 or (piles[i].hangs == 1 and piles[i].weight > 0.0):
                return True
    return False


@kernel
def measure_contacts(
    bodies: Records,
    rows: Integers,
    islands: Integers,
    piles: Records,
    contacts: Contacts,
    joints: JointWork,
    load: Load,
) -> None:
    """Width, foot, bearing bodies and ratio of piles as they are (see `is_stacked`); contacts add to their support, and
    what hangs to their weight."""
    jointed = has_joints(joints)
    down_x = load.down_x
    down_y = load.down_y
    _begin_contacts(bodies, rows, islands, piles, joints)
    for slot in contacts.active[1 : 1 + contacts.active[0].contact]:
        contact = contacts.now[slot.contact]
        a = bodies[contact.body_a]
        b = bodies[contact.body_b]
        if not (is_active(a) or is_active(b)):
            continue
        root = islands[contact.body_a] if is_active(a) else islands[contact.body_b]
        pile = piles[root]
        pile.level = contact.substep_level if contact.substep_level > pile.level else pile.level
        pile.forces += 2 * contact.point_count + (1 if contact.rolling_resistance > 0.0 else 0)
        x = a.center_x - bodies[root].center_x
        y = a.center_y - bodies[root].center_y
        _add_point(pile, x + contact.anchor_ax1, y + contact.anchor_ay1, down_x, down_y)
        if contact.point_count == 2:
            _add_point(pile, x + contact.anchor_ax2, y + contact.anchor_ay2, down_x, down_y)
        upward = upward_force(contact, load)
        if not (is_active(a) and is_active(b)):
            pile.support += upward if is_active(b) else -upward
        elif jointed and is_hung(joints, contact.body_a) != is_hung(joints, contact.body_b):
            pressed = upward if is_hung(joints, contact.body_b) else -upward
            height = -((x + contact.anchor_ax1) * down_x + (y + contact.anchor_ay1) * down_y)
            _add_weight(pile, pressed if pressed > 0.0 else 0.0, height)
        _add_lying(pile, bodies, contact, joints, load)
    if jointed:
        add_part_weights(joints, piles)


@kernel
def _begin_contacts(bodies: Records, rows: Integers, islands: Integers, piles: Records, joints: JointWork) -> None:
    """Nothing is known of the contacts of piles yet, but how many degrees of freedom they and joints have to hold."""
    jointed = has_joints(joints)
    for i in rows:
        pile = piles[i]
        pile.ratio = 0.0
        pile.level = pile.forces = pile.degrees_of_freedom = 0
        pile.bottom = pile.left = pile.bearer = pile.slight = _NONE
        pile.right = -_NONE
    if jointed:
        begin_parts(joints)
    for i in rows:
        pile = piles[islands[i]]
        pile.degrees_of_freedom += 3 if bodies[i].inverse_inertia > 0.0 else 2
        if jointed and joints.part_of[i] >= 0:
            pile.forces += 3
            add_member(joints, i, bodies[i].mass, islands[i])


@kernel
def _add_lying(pile: Records, bodies: Records, contact: Records, joints: JointWork, load: Load) -> None:
    """Note what one body of a contact bears of the other, if that lies on it."""
    jointed = has_joints(joints)
    upright = contact.normal_x * load.down_x + contact.normal_y * load.down_y
    if abs(upright) < UPRIGHT:
        return
    above = contact.body_a if upright > 0.0 else contact.body_b
    below = contact.body_b if upright > 0.0 else contact.body_a
    upper = bodies[above]
    lower = bodies[below]
    if jointed and is_active(upper):
        add_stand(joints, above, upper, lower)
    if is_active(upper) and is_active(lower):
        weighs = upper.mass
        if jointed and hangs_by_one_hinge(joints, above):
            weighs = hinged_mass(joints, bodies, contact, above, load.down_x, load.down_y)
        _add_bearer(pile, lower, weighs)


@kernel
def is_stacked(pile: Records) -> bool:
    """Whether, by `measure_contacts`, some body of a pile is on top of another, or stands on it by joints."""
    return bool(pile.bearer < _NONE or pile.ratio > 0.0)


@kernel
def _add_point(pile: Records, x: float, y: float, down_x: float, down_y: float) -> None:
    height = -(x * down_x + y * down_y)
    pile.bottom = height if height < pile.bottom else pile.bottom
    _widen(pile, x * down_y - y * down_x)


@kernel
def _add_bearer(pile: Records, lower: Records, weighs: float) -> None:
    """Note a body that another one lies on with so much of its mass (kg)."""
    ratio = weighs * lower.inverse_mass
    pile.ratio = ratio if ratio > pile.ratio else pile.ratio
    pile.bearer = lower.mass if lower.mass < pile.bearer else pile.bearer
    pile.slight = lower.extent if lower.extent < pile.slight else pile.slight


@inlined_kernel
def is_frame(pile: Records) -> bool:
    """Whether a pile has as many forces as can hold its bodies, by `measure_contacts`: a column of discs has not."""
    return bool(pile.forces >= pile.degrees_of_freedom)


@kernel
def level_for(pile: Records, load: Load) -> int:
    """How many times the substeps have to be doubled for this pile.

    By one time less than in the last step at least: springs that bear a heavy load of now would throw up what is left
    when it goes, if they became much softer at once. And by none less while it bears a good part of what asks for so
    many: a tower that bounces would have stiff springs below and soft ones above, and swing itself up.
    """
    width = pile.right - pile.left
    width = width if width > 0.5 * pile.slight else 0.5 * pile.slight
    foot = pile.bottom
    buckles = pile.second_moment - 2.0 * foot * pile.moment + foot * foot * pile.weight
    buckles = buckles * share_supported(pile) if is_frame(pile) else 0.0
    heaviest = pile.ratio if pile.support > 0.0 else 0.0  # what falls freely presses on nothing
    bears = SAFE * STIFFNESS * pile.bearer * load.omega * load.omega * width * width * width
    ratio = bearable(pile.slight, load.gravity, load.omega, load.unit)
    level = pile.level - 1 if pile.level > 1 else 0
    for _ in range(level):
        bears = 4.0 * bears
        ratio = 4.0 * ratio
    while level < MAX_LEVEL and (buckles > _limit(bears, level, pile) or heaviest > _limit(ratio, level, pile)):
        bears = 4.0 * bears
        ratio = 4.0 * ratio
        level += 1
    return level


@inlined_kernel
def _limit(bears: float, level: int, pile: Records) -> float:
    """What a pile may bear at a level: at most `KEEPS` of what it could, to go back to that from a higher one."""
    return KEEPS * bears if level < pile.level else bears
