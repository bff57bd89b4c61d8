"""How far apart or how deep contact points are, in millimetres."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen


def _draw(look: Look) -> Marks:
    pen, color, points = Pen(look), look.palette, look.points
    deep = points.separation < 0.0
    for rows, ink in ((~deep, color.blue), (deep, color.red)):
        pen.dots(points.pixel[rows], 2.5 if len(points) < 2000 else 1.0, ink)
        texts = [millimetres(value) for value in points.separation[rows].tolist()]
        pen.labels(texts, points.pixel[rows], ink, gap=7.0, ranks=np.abs(points.separation[rows]) + deep[rows])
    pen.legend(color.red, "overlap, mm")
    pen.legend(color.blue, "gap, mm")
    return pen.marks()


def millimetres(value: float) -> str:
    """A length in metres as signed millimetres with three digits: `-0.12`, `+34.5`; `0` if these show nothing."""
    size = abs(1000.0 * value)
    digits = 0 if size >= 100 else 1 if size >= 10 else 2
    text = f"{1000.0 * value:+.{digits}f}"
    return text if text.strip("+-0.") else "0"


OVERLAY = Overlay("separations", "Separations", "Gap (blue, +) or overlap (red, -) of each contact point in mm.", _draw)
