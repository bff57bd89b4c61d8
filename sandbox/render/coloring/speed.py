"""By how fast bodies are."""

from __future__ import annotations

from sandbox.render.coloring.paint import by_amount
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.world.records import STATIC


def _draw(look: Look) -> Marks:
    return by_amount(look, look.frame.speed, "m/s", look.frame.type != STATIC)


COLORING = Overlay("speed", "Speed", "How fast the fastest point of a body is.", _draw)
