"""The active set: which bodies and shapes a step has to look at."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

ACTIVE_SET = Table(
    "active_set",
    (
        Field("stale", "-", "1 when anybody may have changed since the lists were made", "i8"),
        Field("shifted", "-", "1 when some of the bodies that may move have fallen asleep or changed since", "i8"),
        Field("posed", "-", "1 when somebody was put somewhere before they were made", "i8"),
        Field("bodies", "-", "bodies in them: later rows have come since", "i8"),
        Field("static", "-", "static bodies", "i8"),
        Field("asleep", "-", "dynamic bodies that slept when they were made", "i8"),
        Field("generation", "-", "counts how often they were made", "i8"),
        Field("anew", "-", "its value when everybody was last looked at", "i8"),
        Field("era", "-", "counts how often everybody was looked at, or rows have gone", "i8"),
        Field("shapes_generation", "-", "its value when the shapes were put in order", "i8"),
        Field("moving", "-", "shapes of bodies that may move", "i8"),
        Field("listed", "-", "those and, behind them, others that are to be looked at", "i8"),
        Field("weighed", "-", "1 while the three that follow hold for all dynamic bodies; `WITH_GONE`", "i8"),
        Field("heaviest", "kg", "largest mass"),
        Field("lightest", "kg", "smallest mass"),
        Field("slight", "m", "smallest extent"),
        Field("substep_levels", "-", "bit set of the levels that some body has in this step", "i8"),
        Field("fastest", "m2/s2", "square of the highest speed of a point of any body at its beginning"),
        Field("turning", "-", "1 when some body turns notably in half of it", "i8"),
        Field("impact_speed", "m/s", "past which two points without restitution that meet in it have an impact"),
    ),
)
"""One row: what is known of the lists."""


class ActiveSet(NamedTuple):
    """The lists: `info` is one row of `ACTIVE_SET`.

    `bodies[1:]` are the rows of the bodies that a step may move, ascending; `bodies[0]` is how many those are.
    `touched[1:]`, `touched[0]` of them, are those that have woken or were changed from outside since the shapes were
    put in order. `settled[1:]` is a ring of those that were touched and do not move, `settled[0]` counts them: it tells
    whoever keeps something of what rests who may have come to lie elsewhere. `activity` tells for every body whether it
    is `AWAKE`, `ASLEEP` or stays where it is (0). `shapes` are the rows of the shapes that may move, ascending, and
    behind them those of touched bodies. `last_member` has for the root of each sleeping island its last member,
    `member_before` for every member the one before it.
    """

    info: Records
    bodies: Integers
    touched: Integers
    settled: Integers
    activity: Integers
    shapes: Integers
    last_member: Integers
    member_before: Integers
