"""As the scene looks by itself: known materials like themselves, other bodies by the family of their ids."""

from __future__ import annotations

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    return Marks()


COLORING = Overlay("theme", "As they look", "Known materials like themselves, others by the families of ids.", _draw)
