"""A run in a process of its own, as users have it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def other_process(program: str, **environment: str) -> list[str]:
    """What the module `program` prints in a new process of a user."""
    command = [sys.executable, "-m", program]
    done = subprocess.run(command, cwd=ROOT, env=os.environ | environment, capture_output=True, text=True, check=True)
    return done.stdout.split()
