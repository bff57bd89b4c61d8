"""Where moving bodies came from in the last seconds."""

from __future__ import annotations

import numpy as np

from sandbox.render.body_colors import mix
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen

WIDTH, OPACITY = 2.2, 0.8


def _draw(look: Look) -> Marks:
    pen = Pen(look)
    if look.trails is None:
        return pen.marks(calm=False)
    start, end, rows = look.trails.lines(look.frame, look.camera)
    pieces = start.shape[1]
    if len(rows) == 0 or pieces == 0:
        return pen.marks(calm=False)
    colors = mix(look.colors[rows], look.theme.light, 0.15)
    share = (np.arange(pieces) + 1.0) / pieces
    opacity = np.broadcast_to(OPACITY * share**1.5, (len(rows), pieces)).ravel()
    width = np.broadcast_to(0.6 + (WIDTH - 0.6) * share, (len(rows), pieces)).ravel()
    a, b = start.reshape(-1, 2), end.reshape(-1, 2)
    drawn = np.isfinite(a).all(axis=1) & np.isfinite(b).all(axis=1) & (look.visible(a) | look.visible(b))
    ink = np.repeat(colors, pieces, axis=0)
    pen.lines(a[drawn], b[drawn], width[drawn], ink[drawn], opacity[drawn])
    return pen.marks(calm=False)


OVERLAY = Overlay(
    "trails", "Trails", "Where moving bodies, or the selected ones, came from in the last seconds.", _draw
)
