"""A joint that lets nothing move, though its kind should: what it joins is welded, or cannot turn."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import INFINITE, FlatJoint

_TURNING = ("revolute", "wheel")
_LIMITED = ("revolute", "prismatic")


def check(subject: Subject) -> Iterator[Finding]:
    """Joints between parts of one rigid whole, and hinges between bodies that never turn."""
    whole = _wholes(subject)
    for joint in subject.flat.joints:
        if joint.joints is not None or not joint.enabled:
            continue
        a, b = whole.get(joint.body_a or "", ""), whole.get(joint.body_b or "", "")
        if a == b and not _is_rigid(subject, joint):
            text = f"{quoted(joint.id)} moves nothing: rigid welds hold both of its ends together"
            yield Finding(path_to(joint), text, "take it out, or one of the welds")
        elif joint.kind in _LIMITED and joint.lower == joint.upper and not subject.is_driven(joint):
            text = f'{quoted(joint.id)} cannot move: its "lower" is its "upper"'
            yield Finding(path_to(joint), text, "a weld holds as well; or give it room")
        elif joint.kind in _TURNING and not any(_turns(subject, name) for name in (joint.body_a, joint.body_b)):
            text = f"{quoted(joint.id)} cannot turn: neither of its bodies does"
            yield Finding(path_to(joint), text, 'a weld holds them as well; or leave out "fixed_rotation"')


def _turns(subject: Subject, name: str | None) -> bool:
    body = subject.bodies.get(name or "")
    return body is not None and not body.fixed_rotation and (body.type == "dynamic" or body.angular_velocity != 0.0)


def _is_rigid(subject: Subject, joint: FlatJoint) -> bool:
    """Whether it is a weld that nothing bends, breaks or switches off."""
    soft = joint.hertz or joint.angular_hertz
    lasting = joint.enabled and min(joint.break_force, joint.break_torque) == INFINITE
    return joint.kind == "weld" and not soft and lasting and not subject.is_driven(joint)


def _wholes(subject: Subject) -> dict[str, str]:
    """For each body the name of the rigid whole that it is of; "" is the world with all that is static."""
    whole = {body.id: "" if body.type == "static" else body.id for body in subject.flat.bodies}
    for joint in subject.flat.joints:
        if _is_rigid(subject, joint):
            a, b = whole.get(joint.body_a or "", ""), whole.get(joint.body_b or "", "")
            low, high = sorted((a, b))
            whole = {name: low if of == high else of for name, of in whole.items()}
    return whole


RULE = Rule("stuck-joint", "joints that let nothing move", check)
