"""A wheel that cannot roll: the second body of a wheel joint is the wheel."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, dist, sin

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import FlatBody, Vec

_SWAP = "the second of its bodies is the wheel: swap them"


def check(subject: Subject) -> Iterator[Finding]:
    """Wheels that are not dynamic, never turn, or are what the other body has about the axle."""
    for joint in subject.flat.joints:
        if joint.kind != "wheel":
            continue
        frame, wheel = subject.bodies.get(joint.body_a or ""), subject.bodies.get(joint.body_b or "")
        if wheel is None or wheel.type != "dynamic":
            name = "the world" if wheel is None else f"{quoted(wheel.id)}, which is {wheel.type}"
            text = f"the wheel of {quoted(joint.id)} is {name}"
            yield Finding(path_to(joint), text, _SWAP)
        elif frame is not None and _is_round(frame, joint.anchor_a) and not _is_round(wheel, joint.anchor_b):
            text = f"the wheel of {quoted(joint.id)} is {quoted(wheel.id)}, and {quoted(frame.id)} is round about it"
            yield Finding(path_to(joint), text, _SWAP)
        elif wheel.fixed_rotation:
            text = f"the wheel of {quoted(joint.id)} is {quoted(wheel.id)}, whose rotation is fixed"
            yield Finding(path_to(joint), text, 'leave out its "fixed_rotation"')


def _is_round(body: FlatBody, axle: Vec) -> bool:
    """Whether it has a disc about a place in the world."""
    c, s, (x, y) = cos(body.angle), sin(body.angle), body.position
    discs = [(shape.vertices[0], shape.radius) for shape in body.shapes if shape.kind == "circle"]
    return any(dist((x + c * u - s * v, y + s * u + c * v), axle) < radius / 2 for (u, v), radius in discs)


RULE = Rule("static-wheel", "wheels that cannot roll", check)
