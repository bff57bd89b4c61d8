"""A wheel that cannot roll: the second body of a wheel joint is the wheel."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted


def check(subject: Subject) -> Iterator[Finding]:
    """Wheels that are not dynamic, or never turn."""
    for joint in subject.flat.joints:
        if joint.kind != "wheel":
            continue
        wheel = subject.bodies.get(joint.body_b or "")
        if wheel is None or wheel.type != "dynamic":
            name = "the world" if wheel is None else f"{quoted(wheel.id)}, which is {wheel.type}"
            text = f"the wheel of {quoted(joint.id)} is {name}"
            yield Finding(path_to(joint), text, "the second of its bodies is the wheel: swap them")
        elif wheel.fixed_rotation:
            text = f"the wheel of {quoted(joint.id)} is {quoted(wheel.id)}, whose rotation is fixed"
            yield Finding(path_to(joint), text, 'leave out its "fixed_rotation"')


RULE = Rule("static-wheel", "wheels that cannot roll", check)
