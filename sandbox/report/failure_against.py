"""A run that another revision of the engine takes otherwise, with all that a report shows of it."""

from __future__ import annotations

from pathlib import Path

from sandbox.replay.golden.examine import Report
from sandbox.replay.golden.run import RunStepper, run_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.trace import trace
from sandbox.replay.revisions.trace_playback import TracePlayback, film_samples
from sandbox.replay.revisions.worktree import Commit
from sandbox.report.failure import Failure
from sandbox.report.filming import MOST_POSES, film_run
from sandbox.report.pairs import first_pair
from sandbox.scene import load_scene


def failure_against(report: Report, commit: Commit, root: Path, no_jit: bool, most: int = MOST_POSES) -> Failure | None:
    """The failure behind a report on two revisions: the code of `commit`, checked out in `root`, did what is expected.

    None if both did the same. Raises `SandboxError`.
    """
    parted = report.outcome.divergence if report.outcome is not None else None
    if report.fine or parted is None:
        return None
    case = report.case
    recording = Recording.load(case.replay) if case.scene is None else None
    run = run_of(recording if recording is not None else load_scene(case.scene or case.replay))
    film = film_run(run, most=most)
    past = trace(root, run, [parted.step], no_jit, film_samples(film.end, film.every))
    ghost = film_run(run, most=most, stepper=TracePlayback(run, past))
    pair = first_pair(RunStepper(run.scene, run.commands), TracePlayback(run, past), parted)
    return Failure(recording, parted.step, film, ghost, f"the engine of {commit}", pair=pair)
