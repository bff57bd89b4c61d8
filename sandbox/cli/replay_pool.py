"""Running cases over processes; reports come in the order of the cases."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING

from sandbox.cli.pool import elsewhere
from sandbox.cli.progress import SceneProgress
from sandbox.engine.compile_first import compile_first
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
            compile_first()
        for done, report in enumerate(elsewhere(partial(examine, settings=settings), cases, workers), 1):
            progress.done(done)
            yield report


def _here(cases: Sequence[Case], settings: ReplaySettings, console: Console) -> Iterator[Report]:
    with SceneProgress(console, len(cases)) as progress:
        for case in cases:
            progress.begin(case.replay.name, None)
            yield examine(case, settings, progress.done, partial(_tell, progress, case.replay.name))


def _tell(progress: SceneProgress, name: str, words: str) -> None:
    progress.say(f"{name}: {words}")


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
