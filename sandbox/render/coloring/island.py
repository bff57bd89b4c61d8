"""By the islands that contacts and joints make."""

from __future__ import annotations

from sandbox.render.overlays import islands
from sandbox.render.overlays.look import Overlay

COLORING = Overlay("island", "Island", "Bodies held together by contacts and joints.", islands.OVERLAY.draw)
