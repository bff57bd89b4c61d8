"""The active set: which bodies and shapes a step has to look at."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

ACTIVE_SET = Table(
    "active_set",
    (
        Field("stale", "-", "1 when anybody may have changed since the lists were made", "i8"),
        Field("shifted", "-", "1 when some of the loose bodies have woken, fallen asleep or changed since", "i8"),
        Field("posed", "-", "1 when somebody was put somewhere before they were made", "i8"),
        Field("bodies", "-", "bodies in them: later rows have come since", "i8"),
        Field("fixed", "-", "loose bodies that neither moved nor slept then, but had come or were touched", "i8"),
        Field("static", "-", "static bodies", "i8"),
        Field("asleep", "-", "dynamic bodies that slept when they were made", "i8"),
        Field("generation", "-", "counts how often they were made", "i8"),
        Field("fixed_generation", "-", "its value when it was last asked who stays where it is", "i8"),
        Field("shapes_generation", "-", "its value when the shapes were put in order", "i8"),
        Field("shapes", "-", "shapes in that order", "i8"),
        Field("moving", "-", "shapes of bodies that may move", "i8"),
        Field("loose", "-", "shapes of bodies that may move or sleep", "i8"),
        Field("substep_levels", "-", "bit set of the levels that some body has in this step", "i8"),
        Field("fastest", "m2/s2", "square of the highest speed of a point of any body at its beginning"),
        Field("impact_speed", "m/s", "past which two points without restitution that meet in it have an impact"),
    ),
)
"""One row: what is known of the lists."""


class ActiveSet(NamedTuple):
    """The lists: `info` is one row of `ACTIVE_SET`.

    `bodies[1:]` are the rows of the bodies that a step may move, ascending; `bodies[0]` is how many those are.
    `loose[1:]`, `loose[0]` of them, are the same with those that sleep: all but those that stay where they are until
    something is changed from outside. `touched[1:]`, `touched[0]` of them, are those that were changed so since the
    lists were made, ascending; they are loose from then on. `activity` tells for every body whether it is `AWAKE`,
    `ASLEEP` or stays where it is (0). `shapes` are the rows of the loose shapes, those that may move first;
    `loose_shapes` are the same, ascending.
    """

    info: Records
    bodies: Integers
    loose: Integers
    touched: Integers
    activity: Integers
    shapes: Integers
    loose_shapes: Integers
