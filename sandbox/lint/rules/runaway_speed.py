"""A body so fast that nobody sees it: it leaves the scene within a few steps, and nothing is in its way."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, inf

from sandbox.lint.meeting import can_push
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Box, Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import FlatBody, Vec

STEPS = 3
"""Of the scene: who crosses all of it in fewer is gone before one looks."""


def check(subject: Subject) -> Iterator[Finding]:
    """Speeds at the start against the box about everything."""
    boxes = subject.boxes.values()
    if not boxes:
        return
    left, bottom = min(box[0] for box in boxes), min(box[1] for box in boxes)
    right, top = max(box[2] for box in boxes), max(box[3] for box in boxes)
    across, rate = hypot(right - left, top - bottom), subject.flat.settings.step_rate
    for body in subject.flat.bodies:
        speed = hypot(*body.velocity)
        if body.type != "static" and speed * STEPS > across * rate and not _is_stopped(subject, body):
            text = f"{quoted(body.id)} is off at {speed:.4g} m/s and out of the scene, {across:.3g} m, in no time"
            yield Finding(path_to(body), text, "speeds are in m/s")


def _is_stopped(subject: Subject, body: FlatBody) -> bool:
    """Whether the way of its middle leads into the box of something that it collides with."""
    others = (other for other in subject.flat.bodies if can_push(body, other))
    return any(_meets(body.position, body.velocity, subject.boxes[other.id]) for other in others)


def _meets(start: Vec, way: Vec, box: Box) -> bool:
    """Whether a ray meets a box (the slab method)."""
    first, last = 0.0, inf
    for at, along, low, high in zip(start, way, box[:2], box[2:], strict=True):
        if along == 0.0:
            first, last = (first, last) if low <= at <= high else (inf, 0.0)
        else:
            ends = sorted(((low - at) / along, (high - at) / along))
            first, last = max(first, ends[0]), min(last, ends[1])
    return first <= last


RULE = Rule("runaway-speed", "bodies that leave the scene at once", check)
