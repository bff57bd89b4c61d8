"""By mass."""

from __future__ import annotations

import numpy as np

from sandbox.render.coloring.paint import by_size, dynamic
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.tables import plain


def _draw(look: Look) -> Marks:
    return by_size(look, np.array(plain(look.world.state.bodies)["mass"]), "kg", dynamic(look))


COLORING = Overlay("mass", "Mass", "How heavy bodies are, on a scale of powers.", _draw)
