"""Bodies that start inside each other: the first steps push them apart, or they stay stuck."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import FlatBody

SHARE = 0.1
"""Of the thinner one's box: overlaps that are less deep settle by themselves."""


def check(subject: Subject) -> Iterator[Finding]:
    """From the contacts of the first step: filters, joints, seams and one-way shapes have had their say."""
    if len(subject.flat.bodies) < 2:
        return
    depths = _depths(subject)
    for (a, b), depth in depths.items():
        one, two = subject.flat.bodies[a], subject.flat.bodies[b]
        if depth > SHARE * min(filter(None, (_thickness(subject, one), _thickness(subject, two))), default=0.0):
            late = two if two.type != "static" else one
            text = f"{quoted(one.id)} and {quoted(two.id)} start {depth:.3g} m deep in each other"
            yield Finding(path_to(late), text, "move one of them, or let them pass through each other by their masks")


def _depths(subject: Subject) -> dict[tuple[int, int], float]:
    """The deepest contact of each pair of bodies, m."""
    contacts: Any = subject.world.contacts
    owners = np.asarray(subject.world.state.shapes.body)
    found: dict[tuple[int, int], float] = {}
    two = np.where(contacts.point_count > 1, contacts.separation2, 0.0)
    deepest = -np.minimum(contacts.separation1, two)
    pairs = zip(owners[contacts.shape_a].tolist(), owners[contacts.shape_b].tolist(), deepest.tolist(), strict=True)
    for a, b, depth in pairs:
        found[a, b] = max(depth, found.get((a, b), 0.0))
    return found


def _thickness(subject: Subject, body: FlatBody) -> float:
    left, bottom, right, top = subject.boxes[body.id]
    return min(right - left, top - bottom)


RULE = Rule("overlap", "bodies that start inside each other", check)
