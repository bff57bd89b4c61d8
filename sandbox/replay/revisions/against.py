"""A recording run by the code of another revision and by the code that is running, side by side."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import partial
from pathlib import Path

import sandbox
from sandbox.replay.causes.engine_edits import between_folders, told
from sandbox.replay.golden.divergence import Cause, Divergence
from sandbox.replay.golden.rerun import Outcome
from sandbox.replay.golden.run import Run, run_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.compare import lay_side_by_side
from sandbox.replay.revisions.trace import Trace, trace
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
    first = before()
    found = lay_side_by_side(first, now(), run.steps, _rate(run), (before, now))
    notes: tuple[str, ...] = (f"expected is what the engine did at {commit}",) if found else ()
    if isinstance(what, Recording):
        notes += _held_against_recording(what, first, found, commit)
    if found is not None:
        found = replace(found, cause=_cause(commit, root))
    return Outcome("diverged" if found else "passed", run.steps, time.perf_counter() - begin, found, notes=notes)


def _held_against_recording(
    recording: Recording, before: Trace, found: Divergence | None, commit: Commit
) -> tuple[str, ...]:
    """Whether that revision does what was recorded; nothing if it cannot say."""
    parted = before.parts_from(recording.digests)
    if parted is None:
        return ()
    if not parted:
        return ("that is what was recorded",) if found else ()
    if found:
        return (f"that is not what was recorded either, from step {parted} on: an earlier revision may be",)
    same = f"both do the same, but not what was recorded, from step {parted} on"
    return (f"{same}: what changed came before {commit.hash[:12]}, or is not the engine",)


def _cause(commit: Commit, root: Path) -> Cause:
    edits = between_folders(root, HERE)
    if not edits:
        return Cause("unknown", (f"the engine's source is the same at {commit.hash[:12]} and now",))
    return Cause("engine", (f"its source differs from that of revision {commit.hash[:12]}:", *told(edits)))


def _rate(run: Run) -> float:
    return run.scene.settings.step_rate
