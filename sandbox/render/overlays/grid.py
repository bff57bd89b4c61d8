"""The uniform grid as the broad phase has it: occupied cells by level, and how many boxes are in each."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.number_text import counted, metres
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.memory import GridCells, grid_cells
from sandbox.render.overlays.pen import Pen, box_corners

_NUMBER_PIXELS = 26.0
"""Cells smaller than this have no number."""
_MOST_LEGEND = 6


def _draw(look: Look) -> Marks:
    pen = Pen(look)
    cells = grid_cells(look)
    if len(cells.level) == 0:
        return pen.marks()
    seen = look.visible_boxes(np.hstack([cells.low, cells.high]))
    own = np.unique(cells.level)
    colors = look.palette.categories(np.searchsorted(own, cells.level))
    low, high = look.camera.to_screen(cells.low[seen]), look.camera.to_screen(cells.high[seen])
    share = np.clip(np.log2(1.0 + cells.count[seen]) / 4.0, 0.1, 1.0)
    small = np.abs(high - low).max(axis=1) < 3.0
    pen.fill(box_corners(low, high), colors[seen], np.where(small, 0.6, 0.06 + 0.24 * share))
    pen.boxes(low[~small], high[~small], 1.0, colors[seen][~small], 0.75)
    _number(look, pen, cells, seen)
    _explain(pen, cells, own)
    return pen.marks()


def _number(look: Look, pen: Pen, cells: GridCells, seen: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> None:
    """The number of boxes, in the upper left corner of each cell that has room for it."""
    wide = seen & ((cells.high[:, 0] - cells.low[:, 0]) * look.camera.scale >= _NUMBER_PIXELS * look.scale)
    corner = look.camera.to_screen(np.column_stack([cells.low[wide, 0], cells.high[wide, 1]]))
    # A cell that begins outside shows its number at the edge of the picture.
    corner = np.maximum(corner, 2.0) + look.scale * np.array([9.0, 9.0])
    for at, count in zip(corner.tolist(), cells.count[wide].tolist(), strict=True):
        pen.words(str(count), at, look.palette.text, rank=count)


def _explain(pen: Pen, cells: GridCells, own: np.ndarray[tuple[int], np.dtype[np.int64]]) -> None:
    for k, level in enumerate(own[:_MOST_LEGEND].tolist()):
        rows = cells.level == level
        size = float((cells.high - cells.low)[rows, 0].max())
        boxes, count = int(cells.count[rows].sum()), int(rows.sum())
        color = pen.palette.categories(np.array([k]))[0]
        pen.legend(color, f"level {level}: cells of {metres(size)}, {counted(boxes, 'box', 'boxes')} in {count}")


OVERLAY = Overlay("grid", "Uniform grid", "Cells of the broad phase by level, with the number of boxes in each.", _draw)
