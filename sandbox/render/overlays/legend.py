"""What the colours of the overlays mean, in a corner of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from sandbox.render.label import LETTER, Box, Label
from sandbox.render.marks import LegendEntry, Marks
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.pen import Pen, box_corners

Corner = Literal["lower left", "upper left", "upper right", "lower right"]
CORNERS: tuple[Corner, ...] = ("lower left", "upper left", "upper right", "lower right")
_SHARE = 0.34, 0.26
"""Of the picture's width and height that a card takes about."""
LINE, EDGE, TEXT = 18.0, 14.0, 12.5
_SWATCH = 14.0


def quiet_corner(look: Look, corners: Sequence[Corner] = CORNERS) -> Corner:
    """The corner where a card would cover least of what moves, and then of all; the first of equals."""
    width, height = look.camera.size
    low, high = look.camera.to_screen(look.shape_boxes[:, :2]), look.camera.to_screen(look.shape_boxes[:, 2:])
    weight = np.where(look.frame.type[look.world.state.shapes.body] > 0, 100.0, 1.0)

    def covered(corner: Corner) -> float:
        left = 0.0 if corner.endswith("left") else (1.0 - _SHARE[0]) * width
        top = 0.0 if corner.startswith("upper") else (1.0 - _SHARE[1]) * height
        across = np.minimum(high[:, 0], left + _SHARE[0] * width) - np.maximum(low[:, 0], left)
        down = np.minimum(low[:, 1], top + _SHARE[1] * height) - np.maximum(high[:, 1], top)
        return float((weight * np.clip(across, 0.0, None) * np.clip(down, 0.0, None)).sum())

    return min(corners, key=covered)


def legend_card(entries: Sequence[LegendEntry], look: Look, corner: Corner) -> tuple[Marks, Sequence[Box]]:
    """A card with a line for each entry, as many as the picture has room for, and the room that it takes."""
    width, height = look.camera.size
    scale = look.scale
    line, swatch, text = LINE * scale, _SWATCH * scale, TEXT * scale
    fitting = entries[: max(int((0.6 * height - 2 * EDGE) / line), 0)]
    if not fitting:
        return Marks(), ()
    pen = Pen(look, look.scale)
    wide = max(max(entry.length, swatch) for entry in fitting)
    words = max(len(entry.text) for entry in fitting) * LETTER * text
    left = EDGE if corner.endswith("left") else width - EDGE - wide - words - 8.0
    top = EDGE if corner.startswith("upper") else height - EDGE - line * len(fitting)
    box = left - 8.0, top - 6.0, left + wide + words + 16.0, top + line * len(fitting) + 6.0
    pen.fill(box_corners(np.array([box[:2]]), np.array([box[2:]])), look.palette.halo, 0.78)
    labels = []
    for k, entry in enumerate(fitting):
        y = top + line * (k + 0.5)
        _swatch(pen, entry, left, y)
        labels.append(Label(entry.text, (left + wide + 8.0, y), look.palette.text, text))
    return replace(pen.marks(calm=False), labels=labels), (box,)


def _swatch(pen: Pen, entry: LegendEntry, left: float, y: float) -> None:
    scale = pen.look.scale
    start, way = np.array([[left, y]]), np.array([[entry.length or _SWATCH * scale, 0.0]])
    if entry.length:
        pen.arrows(start, way, 2.0, entry.color)
    else:
        pad = np.array([4.0 * scale, 0.0])
        pen.lines(start + pad, start + way - pad, 8.0, entry.color)
