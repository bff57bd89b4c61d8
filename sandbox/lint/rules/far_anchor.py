"""An anchor far from the body that it holds: mostly a place in the body's frame where one of the world is wanted."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to, reach
from sandbox.scene.finding import Finding, quoted

TIMES = 8.0
"""So many times the body's own reach is far."""
_FREE = ("prismatic", "gear", "motor", "friction")
"""Kinds whose anchor may lie anywhere."""


def check(subject: Subject) -> Iterator[Finding]:
    """Anchors of dynamic bodies, of joints whose law depends on where they are."""
    for joint in subject.flat.joints:
        if joint.kind in _FREE:
            continue
        for body, anchor in subject.ends(joint):
            away, own = dist(anchor, body.position), reach(body)
            if body.type == "dynamic" and away > TIMES * own:
                text = f"{quoted(joint.id)} holds {quoted(body.id)} {away:.3g} m away; it reaches {own:.3g} m"
                yield Finding(path_to(joint), text, "anchors are places in the world, not in the body")


RULE = Rule("far-anchor", "anchors far from the bodies that they hold", check)
