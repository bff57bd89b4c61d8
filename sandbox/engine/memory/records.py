"""The tables of scratch memory: what the stages of a step hand to each other, row by row."""

from __future__ import annotations

from sandbox.tables import Field, Table

MOTION = Table(
    "motion",
    (
        Field("velocity_x", "m/s", "what the solver works on"),
        Field("velocity_y", "m/s", "what the solver works on"),
        Field("angular_velocity", "rad/s", "what the solver works on"),
        Field("delta_x", "m", "way of the centre since the step began"),
        Field("delta_y", "m", "way of the centre since the step began"),
        Field("delta_cos", "1", "rotation since the step began"),
        Field("delta_sin", "1", "rotation since the step began"),
        Field("delta_angle", "rad", "rotation since the step began"),
    ),
)
"""One row a body, one cache line: all that the solver gathers and scatters."""

FLIGHT = Table(
    "flight",
    (
        Field("start_x", "m/s", "velocity when the substep began"),
        Field("start_y", "m/s", "velocity when the substep began"),
        Field("start_w", "rad/s", "velocity when the substep began"),
        Field("free_x", "m/s", "velocity at its end if nothing touches the body"),
        Field("free_y", "m/s", "velocity at its end if nothing touches the body"),
        Field("free_w", "rad/s", "velocity at its end if nothing touches the body"),
        Field("island", "-", "root of its island", "i8"),
        Field("pace", "-", "its island takes 2**pace times the substeps of the scene", "i8"),
        Field("buoyed", "-", "1 when it floats at rest", "i8"),
        Field("was_awake", "-", "before the step woke anybody", "i8"),
        Field("was_island", "-", "before the step woke anybody", "i8"),
        Field("was_slow", "s", "sleep time before the step woke anybody"),
    ),
)
"""One row a body: where an unhindered body would go, and its place in the constraint graph."""

PULL = Table(
    "pull",
    (
        Field("push_x", "m/s", "what gravity and forces add to the velocity in a substep"),
        Field("push_y", "m/s", "the same"),
        Field("push_w", "rad/s", "what torques add to it"),
        Field("slow", "1", "share of the velocity that damping leaves"),
        Field("brake", "1", "share of the angular velocity that damping leaves"),
        Field("extent", "m", "that of the body"),
        Field("moves", "-", "1 when the solver moves it, 2 when it is driven, 0 for the others", "i8"),
        Field("spare", "-", "fills the cache line", "i8"),
    ),
)
"""One row a body, one cache line: all that the substeps ask of the body itself."""

HOLD = Table(
    "hold",
    (
        Field("thin", "m", "half the smallest width of its thinnest shape"),
        Field("linked", "-", "1 when a joint is at it", "i8"),
        Field("deep", "-", "1 when it overlaps something immovable more than a little", "i8"),
        Field("fresh", "-", "1 when it touches something that it was not even near to a step before", "i8"),
        Field("fast", "-", "1 when its way in the step has to be looked at", "i8"),
        Field("hemmed", "-", "1 when something immovable may stop it during the step", "i8"),
    ),
)
"""One row a body: what `continuous` asks of it. By itself, as most steps hardly look at it."""

STOP = Table(
    "stop",
    (
        Field("time", "1", "when it is stopped, as a share of the step; 1 is not at all"),
        Field("bounces", "-", "1 when what stops it bounces it", "i8"),
        Field("struck", "-", "1 when it has touched what stops it from the start of the step on", "i8"),
        Field("normal_x", "1", "of what stops it, towards the body"),
        Field("normal_y", "1", "of what stops it, towards the body"),
        Field("arm_x", "m", "where it is stopped, from the centre of the body"),
        Field("arm_y", "m", "where it is stopped, from the centre of the body"),
        Field("restitution", "1", "of the body and what stops it"),
        Field("friction", "1", "of the body and what stops it"),
        Field("surface_speed", "m/s", "of the body and what stops it"),
    ),
)
"""One row a body: where `continuous` stops it."""

BOX = Table(
    "box",
    (
        Field("lower_x", "m", "bounds of the shape, its margin and its way during the step"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
        Field("cell_x", "-", "cell of the box's middle, on the grid of its level", "i8"),
        Field("cell_y", "-", "", "i8"),
        Field("level", "-", "cells of its grid are 2**level m wide", "i8"),
        Field("shape_index", "-", "row of the shape", "i8"),
    ),
)
"""One row a shape, one cache line: all that the grid looks at before it finds an overlap."""

OWNER = Table(
    "owner",
    (
        Field("body", "-", "index of the body", "i8"),
        Field("moves", "-", "`ACTIVE`, `SLEEPS`, `DRIVEN` or 0, see `bounds`", "i8"),
        Field("category", "-", "", "i8"),
        Field("mask", "-", "", "i8"),
        Field("group", "-", "", "i8"),
        Field("hemmed", "-", "1 when it may meet something immovable during the step", "i8"),
    ),
)

PROXY = Table(
    "proxy",
    (
        Field("center_x", "m", "centre of mass of its body"),
        Field("center_y", "m", "centre of mass of its body"),
        Field("velocity_x", "m/s", "of its body"),
        Field("velocity_y", "m/s", "of its body"),
        Field("speed", "m/s", "of its body"),
        Field("swing", "m/s", "fastest that its core can turn"),
        Field("margin", "m", "half of what its pairs look ahead at low speed"),
        Field("traits", "-", "bits of the shape and of how it moves, see `bounds`", "i8"),
        Field("vertex_start", "-", "", "i8"),
        Field("vertex_count", "-", "", "i8"),
        Field("radius", "m", ""),
        Field("body", "-", "index of the body", "i8"),
        Field("friction", "1", ""),
        Field("restitution", "1", ""),
        Field("rolling_resistance", "m", ""),
        Field("surface_speed", "m/s", ""),
    ),
)
"""One row a shape, two cache lines: all that the narrow phase asks of the shapes of a slow pair and their bodies."""

PAIR = Table("pair", (Field("shape_a", "-", "", "i8"), Field("shape_b", "-", "", "i8")))

SLOT = Table(
    "slot",
    (
        Field("contact", "-", "row in the contact table", "i8"),
        Field("body_a", "-", "", "i8"),
        Field("body_b", "-", "", "i8"),
    ),
)
"""Contacts in the order they are solved in: colour by colour."""

BLOCK = Table(
    "block",
    (
        Field("first", "-", "its first slot", "i8"),
        Field("count", "-", "lanes in use, 1..64", "i8"),
        Field(
            "stride",
            "-",
            "lanes from contact to contact; more than 1 when they share bodies and go one by one",
            "i8",
        ),
        Field("rolling", "-", "1 when some contact has rolling resistance", "i8"),
    ),
)


REPORT = Table(
    "report",
    (
        Field("total_impulse", "N s", "normal impulse over the whole step, impacts included, both points"),
        Field("hit_speed", "m/s", "at which points that did not push before closed in during the step; 0 if none"),
    ),
)
"""What a contact did during the step; same row as the contact."""
