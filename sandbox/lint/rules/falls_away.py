"""A body that falls for ever: nothing lies below it, nothing holds it, and nothing is expected of it."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin

from sandbox.lint.meeting import can_push
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Box, Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import FlatBody
from sandbox.scene.flat_rules import FlatExplode, FlatGravity

_MEND = "put something under it, or look at its mask, and at which side of what lies there is solid"


def check(subject: Subject) -> Iterator[Finding]:
    """Where gravity pulls straight down, and nothing but bodies and joints is there to stop it.

    A body counts as caught if anything that it collides with has a part below it: in the column under it, or, if
    either of them moves sideways, anywhere.
    """
    right, up = subject.flat.gravity
    pulls = any(isinstance(action, (FlatExplode, FlatGravity)) for action in subject.actions)
    if right or up >= 0.0 or subject.flat.regions or pulls:
        return
    held = {name for joint in subject.flat.joints for name in (joint.body_a, joint.body_b)}
    for body in subject.flat.bodies:
        free = body.type == "dynamic" and body.gravity_scale > 0.0 and not body.thrusters
        falls = free and not subject.is_played(body.id)
        if falls and body.id not in held and not _is_expected(subject, body) and not _is_caught(subject, body):
            mend = _MEND
            yield Finding(path_to(body), f"{quoted(body.id)} falls for ever: nothing below could stop it", mend)


def _is_caught(subject: Subject, body: FlatBody) -> bool:
    box = subject.boxes[body.id]
    others = (other for other in subject.flat.bodies if can_push(body, other) and _can_bear(other))
    return any(_is_below(box, subject.boxes[other.id], bool(body.velocity[0] or other.velocity[0])) for other in others)


def _can_bear(body: FlatBody) -> bool:
    """Whether anything of it is solid from above; what moves may turn over."""
    c, s = cos(body.angle), sin(body.angle)
    solid = [shape for shape in body.shapes if not shape.sensor]
    passes = [any(shape.one_way) and s * shape.one_way[0] + c * shape.one_way[1] <= 0.0 for shape in solid]
    return body.type != "static" or not all(passes)


def _is_below(box: Box, other: Box, sideways: bool) -> bool:
    in_column = other[0] <= box[2] and box[0] <= other[2]
    return other[1] < box[3] and (sideways or in_column)


def _is_expected(subject: Subject, body: FlatBody) -> bool:
    """Whether an expectation says where it is, so that a check tells when it falls out of the picture."""
    for expectation in subject.scene.expect:
        if any(getattr(expectation, kind, None) is not None for kind in ("inside", "above", "below", "near")):
            ids = getattr(expectation, "of", None)
            if ids is None or body.id in subject.named(ids):
                return True
    return False


RULE = Rule("falls-away", "bodies that fall for ever, as nothing lies below them", check)
