"""Fill an empty kernel cache with two processes at once: each compiles a part of the step.

`python -m sandbox.engine.compile_step [joints]` is the other process; it says when `solve` is there, and goes on to
`solve_continuous`, which few steps need: who needs it before waits then. It may fail, for then this process compiles
everything.
"""

from __future__ import annotations

import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

from sandbox._jit import cache_is_cold
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.step import collide, solve
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatShape
from sandbox.world.build import build_state


@cache
def compile_step(joints: bool) -> None:
    """Compile the step on a cold cache, in half the time if there are two processors. At once on a warm one.

    With `joints` it is the step of worlds that have some: another version of the machine code.
    """
    if not cache_is_cold() or (os.cpu_count() or 1) < 2:
        return
    helper = _start_helper(joints)
    _run_once(collide)
    if helper is not None and helper.stdout is not None:
        helper.stdout.readline()
        _helpers.append(helper)


def compile_continuous() -> None:
    """Wait until the other process has compiled `solve_continuous`, if there is one at it."""
    while _helpers:
        _helpers.pop().communicate()


_helpers: list[subprocess.Popen[bytes]] = []


def _start_helper(joints: bool) -> subprocess.Popen[bytes] | None:
    if not sys.executable:  # an embedded Python
        return None
    home = str(Path(__file__).parents[2])
    paths = [home, os.environ.get("PYTHONPATH", "")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-m", "sandbox.engine.compile_step", *(["joints"] if joints else [])]
    quiet: dict[str, Any] = dict.fromkeys(("stdin", "stderr"), subprocess.DEVNULL)
    try:
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, **quiet)
    except OSError:
        return None


def _run_once(part: Any, joints: bool = False) -> None:
    """Call one part of the step on the smallest world, for the sake of compiling it."""
    ball = FlatBody("ball", "dynamic", shapes=(FlatShape("circle", ((0.0, 0.0),), 0.5),))
    pin = FlatJoint("pin", "revolute", None, "ball")
    state = build_state(FlatScene(bodies=(ball,), joints=(pin,) if joints else ()))
    part(*bind(part, state, Scratch.for_state(state, len(state.contacts))))


if __name__ == "__main__":
    _run_once(solve, "joints" in sys.argv[1:])
    print("solve", flush=True)
    _run_once(solve_continuous)
