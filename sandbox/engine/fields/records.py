"""Scratch memory of the fields: never hashed, never saved."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox.tables import Field, Integers, Records, Table, plain
from sandbox.world.field_records import NEVER
from sandbox.world.state import State

MAX_PIECES = 1024
"""More than a rounded core of 64 corners has after it is cut by a disc and 65 half-planes."""

PIECE = Table(
    "piece",
    (
        Field("start_x", "m", "from the body's centre, world axes"),
        Field("start_y", "m", ""),
        Field("end_x", "m", ""),
        Field("end_y", "m", ""),
        Field("center_x", "m", "of an arc"),
        Field("center_y", "m", ""),
        Field("radius", "m", "of an arc; 0 is straight"),
        Field("own", "-", "1 on the shape's own boundary, 0 where the region's cuts through it", "i8"),
    ),
)
"""A piece of the boundary of a shape, counter-clockwise: a straight one, or an arc of less than half a circle."""

PUSH = Table(
    "push",
    (
        Field("active", "-", "1 for dynamic bodies that are awake", "i8"),
        Field("held", "-", "1 when something touches it or is joined to it", "i8"),
        Field("wet", "-", "1 when it lies in water that stands", "i8"),
        Field("x", "m", "where its centre is in mid-step if nothing hinders it"),
        Field("y", "m", ""),
        Field("cos", "1", "its rotation in mid-step"),
        Field("sin", "1", ""),
        Field("gravity_x", "m/s^2", "where it is"),
        Field("gravity_y", "m/s^2", ""),
        Field("force_x", "N", "of all fields but drag"),
        Field("force_y", "N", ""),
        Field("torque", "N m", ""),
        Field("drag_xx", "kg/s", "drag is -D (q - medium), with q = (velocity, angular velocity)"),
        Field("drag_xy", "kg/s", ""),
        Field("drag_yy", "kg/s", ""),
        Field("drag_xw", "kg m/s", ""),
        Field("drag_yw", "kg m/s", ""),
        Field("drag_ww", "kg m^2/s", ""),
        Field("carry_x", "N", "D times the velocity of the medium"),
        Field("carry_y", "N", ""),
        Field("carry_w", "N m", ""),
    ),
)
"""One row a body: what the fields of this step do to it."""


SPAN = Table("span", (Field("lower", "m", "where a region begins along an axis, or before"), Field("upper", "m", "")))

AXIS = Table(
    "axis",
    (
        Field("lower", "m", "where the first strip begins"),
        Field("per_metre", "1/m", "strips"),
        Field("count", "-", "how many there are", "i8"),
        Field("words", "-", "of the set of regions of each", "i8"),
        Field("first", "-", "where their sets begin", "i8"),
    ),
)
"""Two rows: how x and y are cut into strips."""

STRIPS, BITS = 256, 62
"""So many strips of an axis at most, and regions in a word of their sets."""


def has_fields(state: State) -> bool:
    """Whether a world has regions or thrusters."""
    return len(state.regions) > 0 or len(state.thrusters) > 0


class Fields(NamedTuple):
    """The regions, their edges and the thrusters of a world, and what working them out needs.

    `pushes` has a row a body, and spare ones; `pieces` and `spare` are the boundary at hand, and where it is cut to.
    `spans` has a row a region, and spare ones, `axes` has two; `strips` has the sets of regions, strip by strip, and
    `found` that of the body at hand.
    """

    regions: Records
    edges: Records
    thrusters: Records
    pushes: Records
    pieces: Records
    spare: Records
    spans: Records
    axes: Records
    strips: Integers
    found: Integers

    @classmethod
    def for_state(cls, state: State, bodies: int) -> Fields:
        """The tables of `state`, and memory for so many bodies: empty in a world without any."""
        pieces = MAX_PIECES if len(state.regions) else 0
        pushes = PUSH.zeros(bodies if has_fields(state) else 0)
        tables = (state.regions, state.edges, state.thrusters)
        spans = SPAN.zeros(len(state.regions))
        found = np.zeros(1 + len(spans) // BITS, np.int64)
        strips = np.zeros(2 * STRIPS * len(found), np.int64)
        return cls(*tables, pushes, PIECE.zeros(pieces), PIECE.zeros(pieces), spans, AXIS.zeros(2), strips, found)


def last_switch(state: State) -> int:
    """The last step in which a region or a thruster begins or ceases to act; -1 if none ever does."""
    tables = [plain(table) for table in (state.regions, state.thrusters) if len(table)]
    if not tables:
        return -1
    steps = np.concatenate([table[f"{end}_step"] for table in tables for end in ("start", "end")])
    return int(steps[(steps > 0) & (steps < NEVER)].max(initial=-1))
