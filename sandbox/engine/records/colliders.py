"""What the broad phase knows of shapes, and where the grid keeps them."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

BOX = Table(
    "box",
    (
        Field("lower_x", "m", "bounds of the shape, its margin and its displacement during the step"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
    ),
)
"""One row a shape: pairs whose boxes overlap are decided."""

GRID_BOX = Table(
    "grid_box",
    (
        Field("shape_index", "-", "row of the shape", "i8"),
        Field("level", "-", "cells of its grid are 2**level m wide", "i8"),
        Field("cell_x", "-", "cell of the box's middle, on the grid of its level", "i8"),
        Field("cell_y", "-", "", "i8"),
        Field("lower_x", "m", "bounds of a box, or of the fat box in which it may move"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
    ),
)
"""One row a box in the grid, one cache line: all that is looked at before an overlap is found. It does not begin as a
`BOX` does: numba would take it for one, and say so."""

FILTER = Table(
    "filter",
    (
        Field("body", "-", "index of the body", "i8"),
        Field("moves", "-", "`ACTIVE`, `SLEEPS`, `DRIVEN` or 0, see `proxies`", "i8"),
        Field("category", "-", "", "i8"),
        Field("mask", "-", "", "i8"),
        Field("group", "-", "", "i8"),
        Field(
            "may_stop",
            "-",
            "1 when something may stop it during the step: what is immovable, or what it runs into",
            "i8",
        ),
    ),
)
"""One row a shape: what decides whether two overlapping boxes are a pair."""

PROXY = Table(
    "proxy",
    (
        Field("center_x", "m", "centre of mass of its body"),
        Field("center_y", "m", "centre of mass of its body"),
        Field("velocity_x", "m/s", "of its body"),
        Field("velocity_y", "m/s", "of its body"),
        Field("speed", "m/s", "of its body"),
        Field("swing", "m/s", "fastest that its core can turn"),
        Field("margin", "m", "half of the speculative margin of its pairs at low speed"),
        Field("extent", "m", "of its body"),
        Field("traits", "-", "bits of the shape and of how it moves, see `proxies`", "i4"),
        Field("body", "-", "index of the body", "i4"),
        Field("vertex_start", "-", "", "i8"),
        Field("vertex_count", "-", "", "i8"),
        Field("radius", "m", ""),
        Field("friction", "1", ""),
        Field("restitution", "1", ""),
        Field("rolling_resistance", "m", ""),
        Field("surface_speed", "m/s", ""),
    ),
)
"""One row a shape, two cache lines: all that the narrow phase asks of the shapes of a slow pair and their bodies."""

GRID_INFO = Table(
    "grid_info",
    (
        Field("cell", "m", "width of the cells of level 0"),
        Field("used", "-", "levels with many boxes", "i8"),
        Field("sparse", "-", "boxes on other levels", "i8"),
        Field("shapes", "-", "boxes in it", "i8"),
        Field("known", "-", "boxes of shapes that are still in their rows: the later ones have gone or moved", "i8"),
        Field("moved", "-", "boxes that have moved since it was built", "i8"),
        Field("others", "-", "those of them on levels that had few boxes", "i8"),
        Field("lower_x", "m", "bounds of all boxes when it was built"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
    ),
)
"""One row: what is known of the grid."""

PAIR = Table("pair", (Field("shape_b", "-", "", "i4"), Field("shape_a", "-", "", "i4")))
"""Two shapes, the lower row first. It does not begin as `CONTACT` does: numba would take a contact for one, and say
so."""

PAIR_CACHE = Table(
    "pair_cache",
    (
        Field("count", "-", "pairs in it", "i8"),
        Field("valid", "-", "1 while it has all pairs of boxes that lie in their fat boxes", "i8"),
        Field("selected", "-", "pairs whose boxes overlapped in the last step", "i8"),
        Field("ahead", "-", "for how many further steps fat boxes cover what velocities lead to; 0: they have no fat"),
        Field("age", "-", "steps since the grid was built", "i8"),
        Field("wait", "-", "how often it is to be built until it is tried again to look ahead", "i8"),
    ),
)
"""One row: what is known of the pairs that are kept from step to step."""


class Colliders(NamedTuple):
    """Shapes in the world, a row each; `cores` has a row for each core vertex, in world axes from the body's centre."""

    cores: Records
    boxes: Records
    filters: Records
    proxies: Records


class PairCache(NamedTuple):
    """The pairs of fat boxes, which are kept from step to step: `info` is one row, `pairs` are sorted, `spare` is
    scratch for as many."""

    info: Records
    pairs: Records
    spare: Records


class Grid(NamedTuple):
    """The uniform grid and the pairs that it proposes.

    `info` is one row. `fat_boxes` has a row for each shape, `outgrown` a 1 for each that has left its fat box or has
    other pairs than before; `enlarged` lists these. `ordered` has the boxes as the grid was built, bucket by bucket,
    `heads` where each bucket begins, `levels` the levels in use. `moved_heads` has the first of the boxes of each
    bucket that have moved since, `moved_next` which one follows, `moved_on` how many of them are on each level
    (`moved_boxes.py`). `pairs` are those that are decided in this step, sorted. `counts` is scratch.
    """

    info: Records
    fat_boxes: Records
    outgrown: Integers
    enlarged: Integers
    ordered: Records
    heads: Integers
    levels: Integers
    moved_heads: Integers
    moved_next: Integers
    moved_on: Integers
    counts: Integers
    cache: PairCache
    pairs: Records
