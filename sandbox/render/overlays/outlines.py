"""Only the outlines of the bodies, so that overlaps show."""

from __future__ import annotations

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay


def _draw(look: Look) -> Marks:
    return Marks(hollow=True)


OVERLAY = Overlay("outlines", "Outlines", "Bodies as outlines only, so that overlaps show.", _draw)
