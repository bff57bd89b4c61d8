"""By who is awake, slow, kept awake or asleep."""

from __future__ import annotations

from dataclasses import replace

from sandbox.render.marks import Marks
from sandbox.render.overlays import sleep
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    """As the overlay of that name, without the seconds."""
    return replace(sleep.OVERLAY.draw(look), labels=())


COLORING = Overlay("sleep", "Sleep", "Who is awake, slow, kept awake or asleep.", _draw)
