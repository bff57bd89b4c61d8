"""The active set: which bodies and shapes a step has to look at."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

ACTIVE_SET = Table(
    "active_set",
    (
        Field("stale", "-", "1 when somebody may have woken, slept, come or changed since the lists were made", "i8"),
        Field("asleep", "-", "dynamic bodies that slept when they were made", "i8"),
        Field("generation", "-", "counts how often they were made", "i8"),
        Field("shapes_generation", "-", "its value when the shapes were put in order", "i8"),
        Field("moving", "-", "shapes of bodies that may move", "i8"),
        Field("split", "-", "1 when resting shapes have a grid of their own, see `resting_grid`", "i8"),
        Field("cell", "m", "width of the cells of its level 0"),
        Field("used", "-", "its levels with many boxes", "i8"),
        Field("sparse", "-", "its boxes on other levels", "i8"),
    ),
)
"""One row: what is known of the lists."""


class ActiveSet(NamedTuple):
    """The lists: `info` is one row of `ACTIVE_SET`.

    `bodies[1:]` are the rows of the bodies that a step may move, ascending; `bodies[0]` is how many those are.
    `activity` tells for every body whether it is `AWAKE`, `ASLEEP` or stays where it is (0). `shapes` are the rows of
    all shapes, those that may move first.
    """

    info: Records
    bodies: Integers
    activity: Integers
    shapes: Integers
