"""Compile what a step lacks with two processes at once: each a half of its parts.

`python -m sandbox.engine.compile_step PARTS` is the other process. On an empty kernel cache each has about half of what
the first step needs; where the parts of worlds without joints are there, this one has the joint solver. The other one
ends with what few steps need, such as `solve_continuous` and `strike_batch`: who needs that before it is there waits
then. It may fail, for then this process compiles everything.
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from sandbox import _compiling
from sandbox._kernel_cache import can_keep
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.joints.nets import do_nets
from sandbox.engine.joints.solve import do_joints
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape
from sandbox.world.build import build_state

Part: TypeAlias = Callable[..., Any]
PARTS: tuple[Part, ...] = (
    collide,
    begin,
    solve,
    finish,
    solve_continuous,
    strike_batch,
    do_joints,
    do_nets,
    strike_through_joints,
)
"""The entry points of a step: the rows of a table of calls from `COLLIDE` on (`records/calls.py`)."""


def compile_step(lacking: Mapping[Part, int], later: Sequence[Part]) -> None:
    """Compile what a step lacks, of these weights, in half the time if there are two processors and two parts; the
    other process goes on with what may be needed `later`, in this order."""
    here, there = halves(lacking)
    if not (there or later) or (os.cpu_count() or 1) < 2 or not can_keep():
        return
    helper = _start_helper([*there, *later])
    for part in here:
        _run_once(part)
    if helper is not None:
        helper.wait_for(there)
        _helpers.append(helper)


def halves(weights: Mapping[Part, int]) -> tuple[list[Part], list[Part]]:
    """Parts of these weights for two processes, which take about as long: the heaviest first, each for the one that has
    less to do."""
    found: tuple[list[Part], list[Part]] = [], []
    loads = [0, 0]
    for part in sorted(weights, key=weights.__getitem__, reverse=True):
        which = 0 if loads[0] <= loads[1] else 1
        found[which].append(part)
        loads[which] += weights[part]
    return found


def wait_for_others(part: Callable[..., Any]) -> None:
    """Wait until the other process has compiled that part, if there is one at it."""
    for helper in _helpers:
        helper.wait_for([part])


def wait_for_all() -> None:
    """Wait until the other process has compiled everything, if there is one at it."""
    while _helpers:
        _helpers.pop().wait_for_end()


def compile_parts() -> None:
    """Compile all parts of the step one after another."""
    for part in PARTS:
        _run_once(part)


class _Helper:
    """The other process, and what it tells of its work."""

    def __init__(self, process: subprocess.Popen[str], parts: Sequence[Part]) -> None:
        """`parts` are what it compiles."""
        self._process = process
        self._done = {part.__name__: threading.Event() for part in parts}
        self._work = _compiling.Process()
        _compiling.processes.append(self._work)
        threading.Thread(target=self._listen, daemon=True).start()

    def wait_for(self, parts: Sequence[Part]) -> None:
        """Wait for those of some parts that it compiles. What comes then is waited for by nobody yet."""
        self._wait_for([self._done[part.__name__] for part in parts if part.__name__ in self._done])

    def wait_for_end(self) -> None:
        """Wait for all."""
        self._wait_for(list(self._done.values()))
        self._process.wait()

    def _wait_for(self, done: Sequence[threading.Event]) -> None:
        def wait() -> None:
            for each in done:
                each.wait()

        self._work.show(True)
        _compiling.patiently(wait)
        self._work.show(False)

    def _listen(self) -> None:
        for line in self._process.stdout or ():
            match line.split():
                case ["done", name] if name in self._done:
                    self._done[name].set()
                case _:
                    self._work.hear(line)
        for each in self._done.values():  # it may have failed
            each.set()
        _compiling.processes.remove(self._work)


_helpers: list[_Helper] = []


def _start_helper(parts: Sequence[Part]) -> _Helper | None:
    if not sys.executable:  # an embedded Python
        return None
    home = str(Path(__file__).parents[2])
    paths = [home, os.environ.get("PYTHONPATH", "")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-m", "sandbox.engine.compile_step", *(part.__name__ for part in parts)]
    quiet: dict[str, Any] = dict.fromkeys(("stdin", "stderr"), subprocess.DEVNULL)
    try:
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True, **quiet)
    except OSError:
        return None
    return _Helper(process, parts)


def _run_once(part: Any) -> None:
    """Call one part of the step on the smallest world, in which it calls no other one, for the sake of compiling it."""
    ball = FlatBody("ball", "dynamic", shapes=(FlatShape("circle", ((0.0, 0.0),), 0.5),))
    state = build_state(FlatScene(bodies=(ball,)))
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
    named = {part.__name__: part for part in PARTS}
    for word in sys.argv[1:]:
        if word in named:
            _run_once(named[word])
            _tell(f"done {word}")
