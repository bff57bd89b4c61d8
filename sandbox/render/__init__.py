"""From a world to pictures: camera, theme, frames, the draw list and the painters that read it."""

from __future__ import annotations

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # pygame greets on stdout otherwise
