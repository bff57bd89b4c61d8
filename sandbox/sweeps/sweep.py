"""A sweep from Python, and the table that is made of outcomes."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from sandbox.arguments import check_kind, checked_count, checked_list, shown
from sandbox.errors import ArgumentError
from sandbox.scene import Scene
from sandbox.sweeps.design import Design, grid, sample
from sandbox.sweeps.runners import Job, run_here, run_in_processes
from sandbox.sweeps.study import Outcome, Study, study_of
from sandbox.sweeps.table import SweepTable

MOST_STEPS = 10_000_000
"""Steps of a run."""
_SHORT = 1.0
"""Seconds that a process takes to begin, about."""


def sweep(
    scene: Scene,
    vary: Mapping[str, Any],
    steps: int | None = None,
    collect: Sequence[str] = (),
    draw: tuple[int, int] | None = None,
    on: int | str | None = 1,
) -> SweepTable:
    """Run a scene once for every combination of the values in `vary`; a row for each, in the order of the grid.

    `vary` gives for paths into the scene's document (`"gravity.1"`, `"bodies.crate.position.0"`, `"seed"`) a list of
    values or a text: `"0.1:0.9:9"`, `"0:100"` (both ends included), `"wood,ice"`. `draw` takes a random sample of
    (count, seed) instead. `collect` are expressions such as `"max(body('crate').speed)"`; angles are in radians.
    `steps` are the scene's own by default. `on` says who runs: so many processes (None: one for each processor), or
    the Dask scheduler at that address; the rows are the same, byte for byte.

    A run that fails has its error as `status` and NaN for what was collected. Raises `ArgumentError`, `SceneError`
    before anything runs if something cannot be used, and `SandboxError` if processes or a cluster were lost.
    """
    check_kind("sweep", "a Scene; load_scene reads one from a file", scene, Scene)
    check_kind("sweep", "a dictionary of paths and values to vary", vary, Mapping)
    count, seed = _drawn(draw)
    design = grid(vary) if draw is None else sample(vary, count, seed)
    steps = None if steps is None else checked_count("sweep", steps, most=MOST_STEPS)
    wanted = "expressions, or a list of them, to collect"
    expressions = [collect] if isinstance(collect, str) else checked_list("sweep", wanted, collect)
    study = study_of(scene, design, steps, expressions)
    outcomes = outcomes_of(study, list(enumerate(design.runs)), on)
    return table_of(study, design, outcomes)


def outcomes_of(study: Study, jobs: Sequence[Job], on: int | str | None) -> Iterator[Outcome]:
    """Make runs, on so many processes or the cluster at that address; outcomes come as runs finish."""
    if isinstance(on, str):
        from sandbox.sweeps.cluster import run_on_cluster

        return run_on_cluster(study, jobs, on)
    if on is None:
        return _by_default(study, jobs)
    processes = min(checked_count("sweep", on, "processes", 1), len(jobs))
    return run_here(study, jobs) if processes <= 1 else run_in_processes(study, jobs, processes)


def _by_default(study: Study, jobs: Sequence[Job]) -> Iterator[Outcome]:
    """A process for each processor, but what this one does in a second is done before others would have begun."""
    start, done = time.monotonic(), 0
    for outcome in run_here(study, jobs):
        done += 1
        yield outcome
        if time.monotonic() - start > _SHORT:
            break
    processes = min(os.cpu_count() or 1, len(jobs) - done)
    if processes > 1:
        yield from run_in_processes(study, jobs[done:], processes)
    else:
        yield from run_here(study, jobs[done:])


def table_of(study: Study, design: Design, outcomes: Iterable[Outcome]) -> SweepTable:
    """The table of a sweep, of outcomes in any order."""
    found = sorted(outcomes, key=lambda outcome: outcome.run)
    columns: dict[str, list[Any]] = {}
    for k, path in enumerate(design.paths):
        columns[path] = [design.runs[outcome.run][k] for outcome in found]
    for k, name in enumerate(study.columns):
        columns[name] = [outcome.values[k] for outcome in found]
    for name in ("digest", "steps", "status"):
        columns[name] = [getattr(outcome, name) for outcome in found]
    return SweepTable(columns)


def _drawn(draw: Any) -> tuple[int, int]:
    if draw is None:
        return 0, 0
    several = isinstance(draw, Iterable) and getattr(draw, "shape", None) != ()  # an array may have no dimensions
    pair = tuple(islice(draw, 3)) if several else ()
    if len(pair) != 2:
        raise ArgumentError(f"sweep: draw is a pair (count, seed), not {shown(draw)}")
    return checked_count("sweep", pair[0], "runs", 1), checked_count("sweep", pair[1], "the seed")
