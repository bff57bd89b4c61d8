"""Whether joints bear the weight of a body, and how much of it one that hangs by one hinge can put on what it touches:
the law of the lever."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records
from sandbox.world.joint_records import REVOLUTE


@kernel
def is_hung(work: JointWork, body: int) -> bool:
    """Whether joints bear the weight of a body, whatever it touches."""
    return bool(work.part_of[body] >= 0 and work.parts[work.part_of[body]].hung == 1)


@kernel
def hangs_by_one_hinge(work: JointWork, body: int) -> bool:
    """Whether the only joint of a body is a hinge at something that does not move."""
    if work.part_of[body] < 0:
        return False
    part = work.parts[work.part_of[body]]
    if part.anchored == 0 or part.constraint_end - part.first_constraint != 1:
        return False
    return bool(work.joints[work.constraints[part.first_constraint].joint].kind == REVOLUTE)


@kernel
def hinged_mass(work: JointWork, bodies: Records, contact: Records, body: int, down_x: float, down_y: float) -> float:
    """The mass (kg) whose weight such a body puts on a contact if nothing else bears it; at most its own.

    (down_x, down_y) is the direction of gravity. A drum that hangs by its middle weighs on nothing.
    """
    x, y = _hinge(work, bodies, body)
    offset = abs(x * down_y - y * down_x)
    lever = _lever(contact, 1, contact.body_a == body, x, y)
    if contact.point_count == 2:
        other = _lever(contact, 2, contact.body_a == body, x, y)
        lever = other if other < lever else lever
    mass = bodies[body].mass
    return float(mass if offset >= lever else mass * offset / lever)


@kernel
def _hinge(work: JointWork, bodies: Records, body: int) -> tuple[float, float]:
    """Its hinge (m), from its centre, world axes."""
    row = bodies[body]
    joint = work.joints[work.constraints[work.parts[work.part_of[body]].first_constraint].joint]
    first = joint.body_a == body
    x = joint.anchor_ax if first else joint.anchor_bx
    y = joint.anchor_ay if first else joint.anchor_by
    return row.rotation_cos * x - row.rotation_sin * y, row.rotation_sin * x + row.rotation_cos * y


@kernel
def _lever(contact: Records, point: int, of_a: bool, hinge_x: float, hinge_y: float) -> float:
    """Arm (m) of the normal force at a point about the hinge, which is given from the centre of the body."""
    r = anchors_of(contact, point)
    x = (r.ax if of_a else r.bx) - hinge_x
    y = (r.ay if of_a else r.by) - hinge_y
    return float(abs(x * contact.normal_y - y * contact.normal_x))
