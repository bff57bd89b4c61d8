"""Shapes that repeat the position of their body: mostly places in the world, not in its frame."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted


def check(subject: Subject) -> Iterator[Finding]:
    """Bodies away from the origin of the world by more than twice their extent, and from their own by about as much."""
    for body in subject.flat.bodies:
        (x, y), (left, bottom, right, top) = body.position, subject.boxes[body.id]
        extent = max(right - left, top - bottom)
        own = (left + right) / 2 - x, (bottom + top) / 2 - y
        if dist(own, body.position) <= extent and dist(body.position, (0.0, 0.0)) > 2.0 * extent:
            place = f"[{x + own[0]:.3g}, {y + own[1]:.3g}]"
            text = f"the shapes of {quoted(body.id)} repeat its position: they are at {place}"
            yield Finding(path_to(body), text, "places in a shape count from the body: leave one of the two out")


RULE = Rule("twice-placed", "bodies whose position their shapes repeat", check)
