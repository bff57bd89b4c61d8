"""What piles are made of: their weight and height, their width, and who bears whom at their contacts."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.bearable_mass import NONE
from sandbox.engine.active.hinged_weight import hangs_by_one_hinge, hinged_mass, is_hung
from sandbox.engine.active.part_weight import add_member, add_part_weights, add_stand, begin_parts
from sandbox.engine.active.pile_support import ALL, Load, upward_force
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import has_joints
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Field, Integers, Records, Table

UPRIGHT = 0.5
"""Smallest cosine between a contact's normal and gravity at which one body counts as lying on the other."""
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
            pile.bottom = pile.left = pile.bearer = pile.slight = NONE
            pile.right = -NONE
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
        pile.bottom = pile.left = pile.bearer = pile.slight = NONE
        pile.right = -NONE
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
def _add_bearer(pile: Records, lower: Records, weighs: float) -> None:
    """Note a body that another one lies on with so much of its mass (kg)."""
    ratio = weighs * lower.inverse_mass
    pile.ratio = ratio if ratio > pile.ratio else pile.ratio
    pile.bearer = lower.mass if lower.mass < pile.bearer else pile.bearer
    pile.slight = lower.extent if lower.extent < pile.slight else pile.slight


@kernel
def _add_point(pile: Records, x: float, y: float, down_x: float, down_y: float) -> None:
    height = -(x * down_x + y * down_y)
    pile.bottom = height if height < pile.bottom else pile.bottom
    _widen(pile, x * down_y - y * down_x)


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
def is_stacked(pile: Records) -> bool:
    """Whether, by `measure_contacts`, some body of a pile is on top of another, or stands on it by joints."""
    return bool(pile.bearer < NONE or pile.ratio > 0.0)


@inlined_kernel
def is_frame(pile: Records) -> bool:
    """Whether a pile has as many forces as can hold its bodies, by `measure_contacts`: a column of discs has not."""
    return bool(pile.forces >= pile.degrees_of_freedom)
