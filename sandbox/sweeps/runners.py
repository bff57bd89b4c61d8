"""Who makes the runs of a study: this process, several processes, or the workers of a Dask cluster.

Each gives outcomes as they finish, in whatever order: a run depends on its values alone.
"""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from typing import TypeAlias

from sandbox.errors import SandboxError
from sandbox.sweeps.design import Values
from sandbox.sweeps.study import Outcome, Study, make_run

Job: TypeAlias = tuple[int, Values]
"""The number of a run, and its values."""
_AHEAD = 4
"""Runs that wait for each process, so that none waits for work."""


def run_here(study: Study, jobs: Iterable[Job]) -> Iterator[Outcome]:
    """One after another, in this process."""
    for run, values in jobs:
        yield make_run(study, run, values)


def run_in_processes(study: Study, jobs: Iterable[Job], processes: int) -> Iterator[Outcome]:
    """Over fresh processes: a fork would copy locks of threads that it has not got.

    Raises `SandboxError` where one of them was killed.
    """
    compile_first()
    pool = ProcessPoolExecutor(processes, get_context("spawn"), _begin, (study,))
    waiting: set[Future[Outcome]] = set()
    queue = iter(jobs)
    try:
        while True:
            for job in queue:
                waiting.add(pool.submit(_run, job))
                if len(waiting) >= _AHEAD * processes:
                    break
            if not waiting:
                return
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            for future in done:
                yield future.result()
    except BrokenProcessPool:
        text = "a process was killed from outside, as a system does that is short of memory; try fewer with -j"
        raise SandboxError(text) from None
    finally:
        pool.shutdown(wait=False, cancel_futures=True)  # whoever interrupts does not wait for the rest


def compile_first() -> None:
    """Fill an empty kernel cache once, or every process would."""
    from sandbox._jit import cache_is_cold
    from sandbox.engine.world import World
    from sandbox.scene import Scene

    if cache_is_cold():
        World(Scene()).step()


_study: Study | None = None
"""What this process makes runs of, if it is one of a pool."""


def _begin(study: Study) -> None:
    global _study
    _study = study
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that began this one says what is to end
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """Not to wait for ever for work from a process that was killed."""
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _run(job: Job) -> Outcome:
    assert _study is not None
    return make_run(_study, *job)
