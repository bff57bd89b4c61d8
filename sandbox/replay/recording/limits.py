"""The stated limits of a recording. A file past one of them is refused before memory is taken for it."""

from __future__ import annotations

SUFFIX = ".replay.json"

MAX_BYTES = 64 * 1024 * 1024
"""Size of a recording."""

MAX_STEPS = 1_000_000
"""Steps of a recording: more than four hours at 60 a second."""

MAX_COMMANDS = 1_000_000
"""Commands of a recording."""
