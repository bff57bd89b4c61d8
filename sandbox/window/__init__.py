"""The window: a pygame-ce window with OpenGL in which scenes run and can be touched."""

from __future__ import annotations

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # pygame greets on stdout otherwise
