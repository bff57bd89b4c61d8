"""Contact points and their normals."""

from __future__ import annotations

from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen

NORMAL_PIXELS = 20.0


def _draw(look: Look) -> Marks:
    pen, color, points = Pen(look), look.palette, look.points
    long = NORMAL_PIXELS * look.mark_scale
    crowded = len(points) > 3000
    on, off = points.touching, ~points.touching
    pen.dots(points.pixel[off], 2.0, color.blue, 0.9)
    if not crowded:
        pen.lines(points.pixel[off], points.pixel[off] + 0.6 * long * points.normal[off], 1.0, color.blue, 0.9)
        pen.arrows(points.pixel[on], long * points.normal[on], 1.5, color.orange)
    else:
        pen.lines(points.pixel[on], points.pixel[on] + 0.5 * long * points.normal[on], 1.0, color.orange)
    pen.dots(points.pixel[on], 2.0 if crowded else 3.0, color.orange)
    pen.legend(color.orange, f"touching: {counted(int(on.sum()), 'point')}, normals from a to b")
    if off.any():
        pen.legend(color.blue, f"not yet touching (speculative): {int(off.sum())}")
    return pen.marks()


OVERLAY = Overlay("contacts", "Contact points", "Contact points with their normals; blue ones do not touch yet.", _draw)
