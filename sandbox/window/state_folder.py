"""Where the window keeps what it remembers between runs."""

from __future__ import annotations

import os
from pathlib import Path

import platformdirs


def state_folder() -> Path:
    """The folder for states of programs, or `SANDBOX_STATE_DIR`."""
    chosen = os.environ.get("SANDBOX_STATE_DIR")
    return Path(chosen) if chosen else platformdirs.user_state_path("sandbox2d")
