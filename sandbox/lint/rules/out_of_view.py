"""A view that shows nothing of what can move."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Box, Subject
from sandbox.scene.finding import Finding

WIDTHS = 4.0
"""So many times its height a view is wide at most."""


def check(subject: Subject) -> Iterator[Finding]:
    """Where the author says how high the picture is, and no body follows."""
    view = subject.scene.view
    if view is None or view.height is None or view.follow is not None:
        return
    (x, y), half = view.center, view.height / 2
    shown = x - WIDTHS * half, y - half, x + WIDTHS * half, y + half
    moving = [body for body in subject.flat.bodies if body.type != "static"] or subject.flat.bodies
    if moving and not subject.spawned and not any(_meet(shown, subject.boxes[body.id]) for body in moving):
        mend = "look at where they are, or leave the view out"
        yield Finding(("view",), "the view shows no body that can move at the start", mend)


def _meet(a: Box, b: Box) -> bool:
    return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]


RULE = Rule("out-of-view", "views that show nothing that can move", check)
