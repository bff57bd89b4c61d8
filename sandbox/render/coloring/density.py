"""By mass per area."""

from __future__ import annotations

import numpy as np

from sandbox.render.coloring.paint import by_size, dynamic
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    first = [body.shapes[0].density if body.shapes else 0.0 for body in look.frame.roster.items]
    return by_size(look, np.array(first, np.float64), "kg/m²", dynamic(look))


COLORING = Overlay("density", "Density", "Mass per area of the first shape, on a scale of powers.", _draw)
