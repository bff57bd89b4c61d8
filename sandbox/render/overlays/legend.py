"""What the colours of the overlays mean, in the lower left corner of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sandbox.render.label import LETTER, Box, Label
from sandbox.render.marks import LegendEntry, Marks
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.pen import Pen, box_corners

LINE, EDGE, TEXT = 18.0, 14.0, 12.5
_SWATCH = 14.0


def legend_card(entries: Sequence[LegendEntry], look: Look) -> tuple[Marks, Sequence[Box]]:
    """A card with a line for each entry, as many as the picture has room for, and the room that it takes."""
    height = look.camera.size[1]
    fitting = entries[: max(int((0.6 * height - 2 * EDGE) / LINE), 0)]
    if not fitting:
        return Marks(), ()
    pen = Pen(look)
    wide = max(max(entry.length, _SWATCH) for entry in fitting)
    words = max(len(entry.text) for entry in fitting) * LETTER * TEXT
    left, top = EDGE, height - EDGE - LINE * len(fitting)
    box = left - 8.0, top - 6.0, left + wide + words + 16.0, height - EDGE + 6.0
    pen.fill(box_corners(np.array([box[:2]]), np.array([box[2:]])), look.palette.halo, 0.78)
    labels = []
    for k, entry in enumerate(fitting):
        y = top + LINE * (k + 0.5)
        _swatch(pen, entry, left, y)
        labels.append(Label(entry.text, (left + wide + 8.0, y), look.palette.text, TEXT))
    return replace(pen.marks(calm=False), labels=labels), (box,)


def _swatch(pen: Pen, entry: LegendEntry, left: float, y: float) -> None:
    start, way = np.array([[left, y]]), np.array([[entry.length or _SWATCH, 0.0]])
    if entry.length:
        pen.arrows(start, way, 2.0, entry.color)
    else:
        pad = np.array([4.0, 0.0])
        pen.lines(start + pad, start + way - pad, 8.0, entry.color)
