"""What the broad phase left in the memory of a world, checked against where the shapes are now.

After a restore, or before the first step, the memory is of another time: a box counts only if its body
is where the last step led.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Floats
from sandbox.render.geometry import Ints
from sandbox.render.overlays.look import Look
from sandbox.tables import plain

_SLACK, _ROUNDING = 0.01, 1e-6
"""Share of its way in a step, and metres, by which a body may be elsewhere than that way leads from its box."""


@dataclass(frozen=True)
class GridCells:
    """The occupied cells: `level` (c,), `low` and `high` (c, 2) in metres, `count` (c,) boxes in it."""

    level: Ints
    low: Floats
    high: Floats
    count: Ints


def step_boxes(look: Look) -> tuple[Floats, NDArray[np.bool_]]:
    """The boxes (s, 4) that the broad phase had of all shapes in the last step, metres, and which are of this time."""
    scratch, count = look.world.scratch, len(look.shape_boxes)
    table = plain(scratch.colliders.boxes)[:count]
    boxes = np.column_stack([table[name] for name in ("lower_x", "lower_y", "upper_x", "upper_y")])
    proxies, bodies = plain(scratch.colliders.proxies)[:count], plain(look.world.state.bodies)
    body = plain(look.world.state.shapes)["body"]
    motions = plain(scratch.solver.motions)[body]
    gone = np.hypot(*(bodies[f"center_{axis}"][body] - proxies[f"center_{axis}"] for axis in "xy"))
    way = np.hypot(motions["delta_x"], motions["delta_y"])
    known: NDArray[np.bool_] = (boxes[:, 2] > boxes[:, 0]) & (gone <= (1.0 + _SLACK) * way + _ROUNDING)
    return boxes, known


def proposed_pairs(look: Look) -> Ints:
    """The pairs of shapes (p, 2) that the grid proposed in the last step."""
    count = int(look.world.state.counters[0].pair_count)
    table = plain(look.world.scratch.grid.pairs)[:count]
    pairs = np.column_stack([table["shape_a"], table["shape_b"]])
    _, trusted = step_boxes(look)
    pairs = pairs[(pairs < len(trusted)).all(axis=1)]
    sound: Ints = pairs[trusted[pairs].all(axis=1)]
    return sound


def grid_cells(look: Look) -> GridCells:
    """The cells of the uniform grid that hold boxes, as they were laid and have moved since."""
    _, trusted = step_boxes(look)
    grid = look.world.scratch.grid
    boxes = plain(grid.fat_boxes)[: len(trusted)][trusted]
    keys = np.column_stack([boxes["level"], boxes["cell_x"], boxes["cell_y"]])
    cells, count = np.unique(keys, axis=0, return_counts=True)
    size = np.ldexp(float(plain(grid.info)["cell"][0]), cells[:, 0])[:, None]
    return GridCells(cells[:, 0], cells[:, 1:] * size, (cells[:, 1:] + 1.0) * size, count)
