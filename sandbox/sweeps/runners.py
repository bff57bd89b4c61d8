"""Who makes the runs of a study: this process, several processes, or the workers of a Dask cluster.

Each gives outcomes as they finish, in whatever order: a run depends on its values alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TypeAlias

from sandbox._fresh_processes import fresh_processes
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
    """Over fresh processes. Raises `SandboxError` where one of them was killed."""
    from sandbox.engine.compile_first import compile_first

    compile_first()
    waiting: set[Future[Outcome]] = set()
    queue = iter(jobs)
    with fresh_processes(processes, _begin, study) as pool:
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


_study: Study | None = None
"""What this process makes runs of, if it is one of a pool."""


def _begin(study: Study) -> None:
    global _study
    _study = study


def _run(job: Job) -> Outcome:
    assert _study is not None
    return make_run(_study, *job)
