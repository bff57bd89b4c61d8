"""By the names of materials."""

from __future__ import annotations

from sandbox.render.body_colors import material_of
from sandbox.render.coloring.paint import by_names
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    return by_names(look, [material_of(body) for body in look.frame.roster.items], "no material")


COLORING = Overlay("material", "Material", "The name of the material.", _draw)
