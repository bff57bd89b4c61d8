"""A run in a process of its own, as users have it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def of_users(**environment: str) -> dict[str, str]:
    """The environment in which kernels are as users have them: not callable one by one."""
    ours = {name: value for name, value in os.environ.items() if name != "SANDBOX_CALLABLE_KERNELS"}
    return ours | environment


def other_process(program: str, **environment: str) -> list[str]:
    """What the module `program` prints in a new process of a user."""
    command, surroundings = [sys.executable, "-m", program], of_users(**environment)
    done = subprocess.run(command, cwd=ROOT, env=surroundings, capture_output=True, text=True, check=True)
    return done.stdout.split()
