"""Running cases over processes; reports come in the order of the cases."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from functools import partial
from multiprocessing import get_context
from typing import TYPE_CHECKING

from sandbox.cli.progress import SceneProgress
from sandbox.errors import SandboxError
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import ReplaySettings, Report, examine

if TYPE_CHECKING:
    from rich.console import Console

_SWITCH = "NUMBA_DISABLE_JIT"


def reports_of(
    cases: Sequence[Case], settings: ReplaySettings, jobs: int, no_jit: bool, console: Console
) -> Iterator[Report]:
    """Examine all cases: in this process for one job, else in others. Without the compiler only others will do."""
    workers = min(jobs or os.cpu_count() or 1, len(cases))
    if workers == 1 and not no_jit:
        yield from _here(cases, settings, console)
        return
    with _environment(no_jit), SceneProgress(console, 1, "files") as progress:
        progress.begin("replays", len(cases))
        if not no_jit:
            _compile_first()
        for done, report in enumerate(_elsewhere(cases, settings, workers), 1):
            progress.done(done)
            yield report


def _here(cases: Sequence[Case], settings: ReplaySettings, console: Console) -> Iterator[Report]:
    with SceneProgress(console, len(cases)) as progress:
        for case in cases:
            progress.begin(case.replay.name, None)
            yield examine(case, settings, progress.done, partial(_tell, progress, case.replay.name))


def _tell(progress: SceneProgress, name: str, words: str) -> None:
    progress.say(f"{name}: {words}")


def _elsewhere(cases: Sequence[Case], settings: ReplaySettings, workers: int) -> Iterator[Report]:
    # Fresh processes: a fork would copy locks of threads that it has not got.
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
    try:
        yield from pool.map(partial(examine, settings=settings), cases)
    except BrokenProcessPool:
        text = "a process was killed from outside, as a system does that is short of memory; try fewer with -j"
        raise SandboxError(text) from None
    finally:
        pool.shutdown(cancel_futures=True)  # whoever interrupts does not wait for the rest


def _compile_first() -> None:
    """Fill an empty kernel cache once, or every process would."""
    from sandbox._jit import cache_is_cold
    from sandbox.engine.world import World
    from sandbox.scene import Scene

    if cache_is_cold():
        World(Scene()).step()


@contextmanager
def _environment(no_jit: bool) -> Iterator[None]:
    """For processes that start meanwhile, the compiler is off."""
    before = os.environ.get(_SWITCH)
    if no_jit:
        os.environ[_SWITCH] = "1"
    try:
        yield
    finally:
        os.environ.pop(_SWITCH, None)
        if before is not None:
            os.environ[_SWITCH] = before
