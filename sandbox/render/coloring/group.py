"""By what bodies are made after: their prefab, or else the family of their ids."""

from __future__ import annotations

from sandbox.render.body_colors import family
from sandbox.render.coloring.paint import by_names
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    return by_names(look, [body.prefab or family(body.id) for body in look.frame.roster.items], "")


COLORING = Overlay("group", "Group", "The prefab, or else the family of ids: crate-1 and crate-2 are of one.", _draw)
