"""Gravity that points up: mostly y points down where the author comes from, as on a screen."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.finding import Finding


def check(subject: Subject) -> Iterator[Finding]:
    """The scene's own gravity."""
    right, up = subject.flat.gravity
    if right == 0.0 < up and any(body.type == "dynamic" for body in subject.flat.bodies):
        mend = "y points up here: turn its sign round, and that of each y if they are those of a screen"
        yield Finding(("gravity",), "gravity points up", mend)


RULE = Rule("upside-down", "gravity that points up", check)
