"""A motor that does nothing: no strength, or a strength and no speed."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import INFINITE, FlatJoint

_DRIVEN = ("revolute", "prismatic", "wheel")
_HOLDING = ("motor", "friction")


def check(subject: Subject) -> Iterator[Finding]:
    """Joints that rules and controls leave as they are."""
    for joint in subject.flat.joints:
        told = _trouble(joint)
        if told is not None and not subject.is_driven(joint):
            text, mend = told
            yield Finding(path_to(joint), f"{quoted(joint.id)} {text}", mend)


def _trouble(joint: FlatJoint) -> tuple[str, str] | None:
    """What is wrong with a motor, and the mend."""
    strength = "max_force" if joint.kind == "prismatic" else "max_torque"
    if joint.kind in _HOLDING and joint.max_force == joint.max_torque == 0.0:
        return "has neither force nor torque", 'give it a "max_force" or a "max_torque"'
    if joint.kind not in _DRIVEN:
        return None
    if joint.motor_speed is None:
        unread = f'has a "{strength}" and no "motor_speed": nothing uses it'
        return (unread, 'give it a "motor_speed"; 0 is a brake') if joint.max_motor < INFINITE else None
    if joint.max_motor == 0.0:
        return f'has a motor of "{strength}" 0: it gives nothing', f'leave "{strength}" out for one without limit'
    if joint.motor_speed == 0.0 and joint.max_motor == INFINITE:
        return "has a motor at speed 0 without limit: it holds still", f'a weld says so; with a "{strength}" it brakes'
    return None


RULE = Rule("idle-motor", "motors that do nothing", check)
