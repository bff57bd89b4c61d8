"""Which jointed bodies are worth finer substeps: small parts that swing freely, such as pendulums.

The method is of second order: the period of a swing of angular frequency w errs by (w h)^2 / 24, which four times as
many substeps make a sixteenth. That is cheap for a few bodies that touch nothing, and pointless where soft contacts
decide what happens, and for a wheel that turns about its centre, a lift, what friction slows down as the ground does in
a view from above, or what flies on a slack rope: those move as they should in any substeps.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.laws import turned
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records
from sandbox.world.joint_records import DISTANCE, FRICTION, PRISMATIC, REVOLUTE, WELD
from sandbox.world.records import STATIC

FINE = 2
"""Substep level of such a part: four times the scene's substeps."""
SMALL = 2
"""Most bodies of such a part."""
FEW = 256
"""Most bodies of a world with such parts: every substep goes through all bodies."""
_CENTERED = 1e-12
"""Share of its moment of inertia that a lever may add to it for a body to turn about its centre."""
_SLACK = 1e-3
"""Share of its bounds by which a rope is within them when it is slack."""


@kernel
def refine_small_parts(work: JointWork, bodies: Records, free_motions: Records) -> int:
    """Give every small part of which no body has a contact the substep level `FINE`; return the levels given, as bits.

    As it has no contact, such a part is an island by itself.
    """
    if bodies.shape[0] > FEW:
        return 0
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        part.fine = part.direct * part.free if _is_small(part) and _swings(work, part, bodies) else 0
    used = 0
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        if member.part >= 0 and work.parts[member.part].fine == 1 and is_active(bodies[member.body]):
            free_motions[member.body].substep_level = FINE
            used = 1 << FINE
    return used


@kernel
def _is_small(part: Records) -> bool:
    return bool(part.member_end - part.first_member <= SMALL)


@kernel
def _swings(work: JointWork, part: Records, bodies: Records) -> bool:
    """Whether a small part moves otherwise than by turning about its own centre, sliding along a fixed axis, being
    slowed down by friction, or as if its ropes were not there."""
    if part.member_end - part.first_member > 1:
        return True
    own = work.members[part.first_member].body
    for k in range(part.first_constraint, part.constraint_end):
        joint = work.joints[work.constraints[k].joint]
        other = joint.body_b if joint.body_a == own else joint.body_a
        sprung = joint.hertz > 0.0 or joint.angular_hertz > 0.0
        if sprung or (other >= 0 and bodies[other].type != STATIC):
            return True
        if joint.kind == REVOLUTE:
            x = joint.anchor_ax if joint.body_a == own else joint.anchor_bx
            y = joint.anchor_ay if joint.body_a == own else joint.anchor_by
            if (x * x + y * y) * bodies[own].inverse_inertia > _CENTERED * bodies[own].inverse_mass:
                return True
        elif joint.kind == DISTANCE:
            if not _is_slack(joint, bodies):
                return True
        elif joint.kind != PRISMATIC and joint.kind != WELD and joint.kind != FRICTION:
            return True
    return False


@kernel
def _is_slack(joint: Records, bodies: Records) -> bool:
    """Whether a joint without a spring that keeps a distance within bounds is well within them."""
    ax, ay = _anchor(bodies, joint.body_a, joint.anchor_ax, joint.anchor_ay)
    bx, by = _anchor(bodies, joint.body_b, joint.anchor_bx, joint.anchor_by)
    length = math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
    return bool(joint.limit == 1 and joint.lower < (1.0 - _SLACK) * length and length < (1.0 - _SLACK) * joint.upper)


@kernel
def _anchor(bodies: Records, body: int, x: float, y: float) -> tuple[float, float]:
    """Where an anchor of a body is in the world, or one of the world itself (-1), m."""
    if body < 0:
        return x, y
    b = bodies[body]
    turned_x, turned_y = turned(b.rotation_cos, b.rotation_sin, x, y)
    return b.center_x + turned_x, b.center_y + turned_y
