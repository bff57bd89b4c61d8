"""Bodies that start inside each other: the first steps push them apart, or they stay stuck."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.world import World
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted

SHARE = 0.1
"""Of the thinner shape: overlaps that are less deep settle by themselves."""


def check(subject: Subject) -> Iterator[Finding]:
    """From the contacts of the first step: filters, joints, seams and one-way shapes have had their say."""
    if len(subject.flat.bodies) < 2:
        return
    for (a, b), depth in _depths(subject).items():
        one, two = subject.flat.bodies[a], subject.flat.bodies[b]
        late = two if two.type != "static" else one
        text = f"{quoted(one.id)} and {quoted(two.id)} start {depth:.3g} m deep in each other"
        yield Finding(path_to(late), text, "move one of them, or let them pass through each other by their masks")


def _depths(subject: Subject) -> dict[tuple[int, int], float]:
    """The deepest contact of each pair of bodies of which one is deep for the shapes that touch there, m."""
    contacts: Any = subject.world.contacts
    owners, widths = np.asarray(subject.world.state.shapes.body), _widths(subject.world)
    found: dict[tuple[int, int], float] = {}
    two = np.where(contacts.point_count > 1, contacts.separation2, 0.0)
    deepest = -np.minimum(contacts.separation1, two)
    deep = deepest > SHARE * np.minimum(widths[contacts.shape_a], widths[contacts.shape_b])
    ends = (owners[shapes[deep]].tolist() for shapes in (contacts.shape_a, contacts.shape_b))
    for a, b, depth in zip(*ends, deepest[deep].tolist(), strict=True):
        found[a, b] = max(depth, found.get((a, b), 0.0))
    return found


def _widths(world: World) -> NDArray[np.float64]:
    """How thick each shape is where it is thinnest, m; a line without a radius is as thick as what it meets."""
    shapes, vertices = world.state.shapes, world.state.vertices
    corners = np.stack([vertices.x, vertices.y], axis=1)
    normals = np.stack([vertices.normal_x, vertices.normal_y], axis=1)
    found = 2.0 * np.asarray(shapes.radius)
    for k in np.flatnonzero(np.asarray(shapes.vertex_count) > 2).tolist():
        rows = slice(int(shapes.vertex_start[k]), int(shapes.vertex_start[k] + shapes.vertex_count[k]))
        found[k] += np.ptp(normals[rows] @ corners[rows].T, axis=1).min()
    return np.where(found > 0.0, found, np.inf)


RULE = Rule("overlap", "bodies that start inside each other", check)
