"""Fill an empty kernel cache with two processes at once: each compiles a part of the step.

`python -m sandbox.engine.compile_step` is the other process: this one compiles `solve`, which with joints takes as long
as all else that a step needs, and without them `finish` too; the other one the other parts. Its last ones are
`solve_continuous` and `strike_batch`, which few steps need, the second one before the first where something has
restitution: who needs them before they are there waits then. It may fail, for then this process compiles everything.
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

from sandbox import _compiling
from sandbox._jit import cache_is_cold
from sandbox._kernel_cache import can_keep
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatShape
from sandbox.world.build import build_state

PARTS: tuple[Callable[..., Any], ...] = (collide, begin, solve, finish, solve_continuous)
"""The entry points of a step, in order. The last one is left out where nothing is fast."""
_JOINTS, _IMPACTS = "joints", "impacts"
_Parts: TypeAlias = tuple[Callable[..., Any], ...]


def _halves(joints: bool, impacts: bool) -> tuple[_Parts, _Parts]:
    """What is compiled, in order: the parts of a step by this process, by the other one those and what few steps
    need."""
    here, there = ((solve,), (collide, begin, finish)) if joints else ((solve, finish), (collide, begin))
    few = (strike_batch, solve_continuous) if impacts else (solve_continuous, strike_batch)
    return here, there + few


@cache
def compile_step(joints: bool, impacts: bool) -> None:
    """Compile the step on a cold cache, in half the time if there are two processors. At once on a warm one.

    With `joints` it is the step of worlds that have some: another version of the machine code. `impacts` says whether
    something has restitution.
    """
    if not cache_is_cold() or (os.cpu_count() or 1) < 2 or not can_keep():
        return
    here, there = _halves(joints, impacts)
    helper = _start_helper(joints, impacts)
    for part in here:
        _run_once(part, joints)
    if helper is not None:
        helper.wait_for([part for part in there if part in PARTS[:-1]])
        _helpers.append(helper)


def wait_for_others(part: Callable[..., Any]) -> None:
    """Wait until the other process has compiled that part, if there is one at it."""
    for helper in _helpers:
        helper.wait_for([part])


def wait_for_all() -> None:
    """Wait until the other process has compiled everything, if there is one at it."""
    while _helpers:
        _helpers.pop().wait_for_end()


def compile_parts() -> None:
    """Compile all parts of the step one after another, with joints and without."""
    for part in (*PARTS, strike_batch):
        _run_once(part)
        _run_once(part, joints=True)  # at once for those that joints do not change


class _Helper:
    """The other process, and what it tells of its work."""

    def __init__(self, process: subprocess.Popen[str], parts: _Parts) -> None:
        """`parts` are what it compiles, in order."""
        self._process = process
        self._parts = {part: threading.Event() for part in parts}
        self._work = _compiling.Process()
        _compiling.processes.append(self._work)
        threading.Thread(target=self._listen, daemon=True).start()

    def wait_for(self, parts: Sequence[Callable[..., Any]]) -> None:
        """Wait for some parts. What comes then is waited for by nobody yet."""
        self._work.show(True)
        _compiling.patiently(lambda: self._wait_for(parts))
        self._work.show(False)

    def _wait_for(self, parts: Sequence[Callable[..., Any]]) -> None:
        for part in parts:
            self._parts[part].wait()

    def wait_for_end(self) -> None:
        """Wait for all."""
        self.wait_for(list(self._parts))
        self._process.wait()

    def _listen(self) -> None:
        left = iter(self._parts.values())
        for line in self._process.stdout or ():
            self._work.hear(line)
            if line.startswith("end"):
                next(left).set()
        for each in left:  # it may have failed
            each.set()
        _compiling.processes.remove(self._work)


_helpers: list[_Helper] = []


def _start_helper(joints: bool, impacts: bool) -> _Helper | None:
    if not sys.executable:  # an embedded Python
        return None
    home = str(Path(__file__).parents[2])
    paths = [home, os.environ.get("PYTHONPATH", "")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    words = [word for word, given in ((_JOINTS, joints), (_IMPACTS, impacts)) if given]
    command = [sys.executable, "-m", "sandbox.engine.compile_step", *words]
    quiet: dict[str, Any] = dict.fromkeys(("stdin", "stderr"), subprocess.DEVNULL)
    try:
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True, **quiet)
    except OSError:
        return None
    return _Helper(process, _halves(joints, impacts)[1])


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
    for each in _halves(jointed, _IMPACTS in sys.argv)[1]:
        _run_once(each, jointed)
