"""A run in a process of its own, as users have it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def other_process(program: str, **environment: str) -> list[str]:
    """What the module `program` prints in a new process, with the kernels as users have them: not callable there."""
    user = {name: value for name, value in os.environ.items() if name != "SANDBOX_CALLABLE_KERNELS"}
    done = subprocess.run(
        [sys.executable, "-m", program],
        cwd=ROOT, env={**user, **environment}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return done.stdout.split()
