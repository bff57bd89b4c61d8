"""A recording run by the code of another revision and by the code that is running, side by side."""

from __future__ import annotations

import time
from functools import partial
from pathlib import Path

import sandbox
from sandbox.replay.golden.rerun import Outcome
from sandbox.replay.golden.run import Run, run_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.compare import lay_side_by_side
from sandbox.replay.revisions.trace import trace
from sandbox.replay.revisions.worktree import Commit
from sandbox.scene import Scene

HERE = Path(sandbox.__file__).resolve().parents[1]
"""The folder that the running code was imported from."""


def against(what: Recording | Scene, commit: Commit, root: Path, no_jit: bool = False) -> Outcome:
    """What the running code does (got) held against what the code of `commit`, checked out in `root`, does (expected).

    The scene is that of now, for both. Raises `RevisionError` if one of the two cannot run it.
    """
    begin = time.perf_counter()
    run = run_of(what)
    before, now = (partial(trace, folder, run, no_jit=no_jit) for folder in (root, HERE))
    found = lay_side_by_side(before(), now(), run.steps, _rate(run), (before, now))
    notes = (f"expected is what the engine did at {commit}",) if found else ()
    return Outcome("diverged" if found else "passed", run.steps, time.perf_counter() - begin, found, notes=notes)


def _rate(run: Run) -> float:
    return run.scene.settings.step_rate
