"""Which corners meet at a contact point: its feature id, by which impulses are carried to the next step."""

from __future__ import annotations

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.scene.limits import MAX_VERTICES


def _draw(look: Look) -> Marks:
    pen, color, points = Pen(look), look.palette, look.points
    pen.dots(points.pixel, 2.5 if len(points) < 2000 else 1.0, color.purple)
    texts = [feature_text(feature) for feature in points.feature.tolist()]
    pen.labels(texts, points.pixel, color.purple, gap=7.0, ranks=points.pushing)
    pen.legend(color.purple, "vertex of a, vertex of b (numbers of their cores)")
    return pen.marks()


def feature_text(feature: int) -> str:
    """`a3 b0` for 64 * 3 + 0; a dash if the point has none."""
    return f"a{feature // MAX_VERTICES} b{feature % MAX_VERTICES}" if feature >= 0 else "-"


OVERLAY = Overlay("features", "Feature ids", "Feature id of each contact point: the vertices that meet there.", _draw)
