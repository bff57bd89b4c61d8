"""Fill an empty kernel cache with two processes at once: each compiles a part of the step.

`python -m sandbox.engine.compile_step` is the other process: this one compiles `solve`, which with joints takes as long
as all else that a step needs, and without them `finish` too; the other one the other parts. Its last one is
`solve_continuous`, which few steps need: who needs it before it is there waits then. It may fail, for then this process
compiles everything.
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

from sandbox import _compiling
from sandbox._jit import cache_is_cold
from sandbox._kernel_cache import can_keep
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatShape
from sandbox.world.build import build_state

PARTS: tuple[Callable[..., Any], ...] = (collide, begin, solve, finish, solve_continuous)
"""The entry points of a step, in order. The last one is left out where nothing is fast."""
_JOINTS = "joints"
_Parts: TypeAlias = tuple[Callable[..., Any], ...]


def _halves(joints: bool) -> tuple[_Parts, _Parts]:
    """What a step needs: the parts that this process compiles, and those of the other one."""
    return ((solve,), (collide, begin, finish)) if joints else ((solve, finish), (collide, begin))


@cache
def compile_step(joints: bool) -> None:
    """Compile the step on a cold cache, in half the time if there are two processors. At once on a warm one.

    With `joints` it is the step of worlds that have some: another version of the machine code.
    """
    if not cache_is_cold() or (os.cpu_count() or 1) < 2 or not can_keep():
        return
    helper = _start_helper(joints)
    for part in _halves(joints)[0]:
        _run_once(part, joints)
    if helper is not None:
        _compiling.patiently(helper.wait_for_step)
        _helpers.append(helper)


def compile_continuous() -> None:
    """Wait until the other process has compiled `solve_continuous`, if there is one at it."""
    while _helpers:
        _compiling.patiently(_helpers.pop().wait)


def compile_parts() -> None:
    """Compile all parts of the step one after another, with joints and without."""
    for part in PARTS:
        _run_once(part)
        _run_once(part, joints=True)  # at once for those that joints do not change


class _Helper:
    """The other process, and what it tells of its work."""

    def __init__(self, process: subprocess.Popen[str], parts: int) -> None:
        """`parts` is how many of those that it compiles a step needs."""
        self._process = process
        self._left = parts
        self._work = _compiling.Process()
        self._step = threading.Event()
        _compiling.processes.append(self._work)
        threading.Thread(target=self._listen, daemon=True).start()

    def wait_for_step(self) -> None:
        """Wait for what every step needs. What comes then is waited for by nobody yet."""
        self._step.wait()

    def wait(self) -> None:
        """Wait for all."""
        self._work.show(True)
        self._process.wait()

    def _listen(self) -> None:
        for line in self._process.stdout or ():
            self._work.hear(line)
            self._left -= line.startswith("end")
            if self._left == 0 and not self._step.is_set():
                self._work.show(False)
                self._step.set()
        self._step.set()  # it may have failed
        _compiling.processes.remove(self._work)


_helpers: list[_Helper] = []


def _start_helper(joints: bool) -> _Helper | None:
    if not sys.executable:  # an embedded Python
        return None
    home = str(Path(__file__).parents[2])
    paths = [home, os.environ.get("PYTHONPATH", "")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-m", "sandbox.engine.compile_step", *([_JOINTS] if joints else [])]
    quiet: dict[str, Any] = dict.fromkeys(("stdin", "stderr"), subprocess.DEVNULL)
    try:
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True, **quiet)
    except OSError:
        return None
    return _Helper(process, len(_halves(joints)[1]))


def _run_once(part: Any, joints: bool = False) -> None:
    """Call one part of the step on the smallest world, for the sake of compiling it."""
    ball = FlatBody("ball", "dynamic", shapes=(FlatShape("circle", ((0.0, 0.0),), 0.5),))
    pin = FlatJoint("pin", "revolute", None, "ball")
    state = build_state(FlatScene(bodies=(ball,), joints=(pin,) if joints else ()))
    part(*bind(part, state, Scratch.for_state(state, len(state.contacts))))


def _tell(line: str) -> None:
    """Tell the first process, as long as it is there: what is compiled is kept for the next one."""
    try:
        print(line, flush=True)
    except OSError:
        _compiling.tell = _compiling.here.hear


if __name__ == "__main__":
    gc.disable()  # it ends before its memory is needed
    _compiling.tell = _tell
    jointed = _JOINTS in sys.argv
    for each in _halves(jointed)[1]:
        _run_once(each, jointed)
    _run_once(solve_continuous)
