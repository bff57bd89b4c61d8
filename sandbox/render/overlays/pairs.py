"""The pairs that the grid proposed: those that touch, and those that the separating-axis test turned down."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.geometry import Ints
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.memory import proposed_pairs
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain

_LONG = 3.0
"""In a box so many times longer than the other, the place beside that stands for the middle."""


def _draw(look: Look) -> Marks:
    pen, color = Pen(look), look.palette
    contacts: Any = plain(look.world.contacts)
    touching = contacts[contacts["touching"] == 1]
    met = np.column_stack([touching["shape_a"], touching["shape_b"]])
    proposed = proposed_pairs(look)
    count = max(len(look.shape_boxes), 1)
    alone = proposed[~np.isin(_keys(proposed, count), _keys(met, count))]
    for pairs, ink, width in ((alone, color.blue, 1.2), (met, color.orange, 2.0)):
        start, end = _ends(look, pairs)
        seen = look.visible(start) | look.visible(end)
        pen.lines(start[seen], end[seen], width, ink, halo=True)
        pen.dots(start[seen], width, ink)
        pen.dots(end[seen], width, ink)
    pen.legend(color.orange, f"touching: {len(met)}")
    pen.legend(color.blue, f"proposed by the grid, apart: {len(alone)}")
    return pen.marks()


def _keys(pairs: Ints, count: int) -> Ints:
    keys: Ints = pairs[:, 0].astype(np.int64) * count + pairs[:, 1]  # from columns of four bytes
    return keys


def _ends(look: Look, pairs: Ints) -> tuple[Floats, Floats]:
    """From where to where the line of each pair goes, in pixels."""
    a, b = look.shape_boxes[pairs[:, 0]], look.shape_boxes[pairs[:, 1]]
    return look.camera.to_screen(_anchor(a, b)), look.camera.to_screen(_anchor(b, a))


def _anchor(own: Floats, other: Floats) -> Floats:
    """The middle of each box (n, 4); of one much longer than the other, the place beside the other's middle."""
    middle, place = 0.5 * (own[:, :2] + own[:, 2:]), 0.5 * (other[:, :2] + other[:, 2:])
    long = own[:, 2:] - own[:, :2] > _LONG * (other[:, 2:] - other[:, :2])
    return np.where(long, np.clip(place, own[:, :2], own[:, 2:]), middle)


OVERLAY = Overlay("pairs", "Pairs", "Pairs that touch, and those that the grid proposed and the test rejected.", _draw)
