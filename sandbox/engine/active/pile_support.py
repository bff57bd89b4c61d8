"""What holds piles up: one that falls freely bears nothing, however high it is.

Forces within a pile cancel each other, so what contacts with bodies that do not move and forces of fields put on it
is all that it stands on, but for joints and the hand that drags a body.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import has_joints
from sandbox.tables import Integers, Records

ALL = 1e300
"""More than any weight (N)."""


class Load(NamedTuple):
    """What bears down on piles: the direction of gravity, its size (m/s^2), the contacts' angular frequency (rad/s),
    the length of a substep (s), 0 in a world's first step, and how many units of length a metre is."""

    down_x: float
    down_y: float
    gravity: float
    omega: float
    seconds: float
    unit: float


@kernel
def measure_support(
    bodies: Records,
    rows: Integers,
    islands: Integers,
    piles: Records,
    joints: JointWork,
    drags: Records,
    load: Load,
) -> None:
    """Write what holds each pile up but for contacts; `ALL` where nothing is known, or joints or a hand hold it."""
    jointed = has_joints(joints)
    for i in rows:
        piles[i].support = 0.0
    for i in rows:
        body = bodies[i]
        pile = piles[islands[i]]
        if load.seconds == 0.0 or (jointed and _is_held(joints, i)):
            pile.support = ALL
        pile.support -= body.force_x * load.down_x + body.force_y * load.down_y
    for k in range(drags.shape[0]):
        if drags[k].body >= 0:
            piles[islands[drags[k].body]].support = ALL


@kernel
def _is_held(joints: JointWork, body: int) -> bool:
    """Whether joints hold the body, or a body that it is joined to, at something that does not move."""
    return bool(joints.part_of[body] >= 0 and joints.parts[joints.part_of[body]].anchored == 1)


@kernel
def upward_force(contact: Records, load: Load) -> float:
    """The force (N) against gravity that a contact put on its second body in the last substep."""
    along = contact.normal_impulse1
    across = contact.tangent_impulse1
    if contact.point_count == 2:
        along += contact.normal_impulse2
        across += contact.tangent_impulse2
    x = contact.normal_x * along + contact.normal_y * across
    y = contact.normal_y * along - contact.normal_x * across
    return float(-(x * load.down_x + y * load.down_y) / load.seconds) if load.seconds > 0.0 else 0.0


@kernel
def share_supported(pile: Records) -> float:
    """The share of its weight that a pile stands with on what holds it up."""
    if pile.support >= pile.weight:
        return 1.0
    return float(pile.support / pile.weight) if pile.support > 0.0 else 0.0
