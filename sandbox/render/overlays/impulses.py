"""What contacts push with: normal and friction as arrows to one scale, within the friction cone."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.render.overlays.scale import LONGEST, amount, lengths, reach, round_scale

SLIDING = 0.995
"""Share of the cone's half width from which a point counts as sliding."""


def _draw(look: Look) -> Marks:
    pen, color, points = Pen(look), look.palette, look.points
    pushes = points.pushing > 0.0
    at, normal = points.pixel[pushes], points.normal[pushes]
    pushing, sliding, friction = points.pushing[pushes], points.sliding[pushes], points.friction[pushes]
    scale, pixels = round_scale(pushing), reach(look)
    # Screen tangent: the engine's is the normal turned clockwise in the world, y up.
    tangent = np.column_stack([-normal[:, 1], normal[:, 0]])
    length = lengths(pushing, scale, pixels)
    slips = np.abs(sliding) >= SLIDING * friction * pushing
    if len(at) <= 3000:
        half = np.clip(friction, 0.0, 4.0)[:, None] * length[:, None] * tangent
        middle = at + length[:, None] * normal
        pen.fill(np.stack([at, middle + half, middle - half], axis=1), color.blue, 0.16)
        for side in (half, -half):
            pen.lines(at, middle + side, 1.0, color.blue, 0.8)
    pen.arrows(at, length[:, None] * normal, 2.0, color.orange)
    ink = np.where((slips & (friction > 0.0))[:, None], color.red, color.green)
    pen.arrows(at, lengths(sliding, scale, pixels)[:, None] * tangent, 2.0, ink)
    pen.dots(at, 2.0, color.orange)
    pen.legend(color.orange, f"normal force, {amount(scale, 'N')}", pixels)
    pen.legend(color.green, "friction, holding")
    pen.legend(color.red, "friction, sliding")
    pen.legend(color.blue, "friction cone")
    if (pushing > LONGEST * scale).any():
        pen.legend(color.quiet, f"cut at {amount(LONGEST * scale, 'N')}; largest {amount(float(pushing.max()), 'N')}")
    return pen.marks()


OVERLAY = Overlay("impulses", "Impulses", "Normal and friction impulses to scale, with friction cones.", _draw)
