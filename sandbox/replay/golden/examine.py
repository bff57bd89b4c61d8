"""One case of a whole set: run it, judge it, and renew its recording where that is asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from sandbox._lent import is_lent
from sandbox.errors import FileError, Problem, RefusedCommandError, SandboxError
from sandbox.replay.causes.explain import explained
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.rerun import Outcome, rerun
from sandbox.replay.golden.source_location import divergence_location
from sandbox.replay.golden.tolerance import Tolerance
from sandbox.replay.recording.command_file import refused_in
from sandbox.replay.recording.recorder import record
from sandbox.replay.recording.recording import Recording
from sandbox.scene import Scene, load_scene

Verdict = Literal["passed", "diverged", "missing", "stale", "orphaned", "unusable"]
Update = Literal["", "missing", "changed", "all"]


@dataclass(frozen=True)
class ReplaySettings:
    """How to compare, and what may be written: `update` recordings that are missing, or have changed too, or all;
    `prune` away those whose scene is gone.
    """

    tolerance: Tolerance | None = None
    heavy: bool = False
    update: Update = ""
    prune: bool = False


@dataclass(frozen=True)
class Report:
    """What became of a case, its `verdict`, and what was done about it: "", "written" or "removed".

    `outcome` is there if it ran, `problems` if it could not be used; `scene` is its scene's file, if known; `where`
    says where the body stands that parted. `recording` is what was run, if that is not what the file holds.
    """

    case: Case
    verdict: Verdict
    outcome: Outcome | None = None
    action: Literal["", "written", "removed"] = ""
    source: str = ""
    problems: tuple[Problem, ...] = ()
    scene: str = ""
    where: str = ""
    recording: Recording | None = None

    @property
    def fine(self) -> bool:
        """Whether nothing is left to be looked at."""
        return self.verdict == "passed" or bool(self.action)


def examine(
    case: Case,
    settings: ReplaySettings,
    on_steps: Callable[[int], None] | None = None,
    tell: Callable[[str], None] | None = None,
) -> Report:
    """Run and judge one case. What is wrong with its files comes back in the report, never as an exception.

    `on_steps` hears now and then how many steps are done, `tell` what is being done after that.
    """
    try:
        return _missing(case, settings) if case.scene is not None else _recorded(case, settings, on_steps, tell)
    except FileError as error:
        return Report(case, "unusable", source=error.source, problems=tuple(error.problems))
    except OSError as error:
        return _unusable(case, error.strerror or str(error), str(error.filename or case.replay))
    except SandboxError as error:
        return _unusable(case, str(error), str(case.replay))


def _unusable(case: Case, text: str, source: str) -> Report:
    return Report(case, "unusable", source=source, problems=(Problem(text),))


def _missing(case: Case, settings: ReplaySettings) -> Report:
    assert case.scene is not None
    scene = load_scene(case.scene)
    report = Report(case, "missing", scene=str(case.scene))
    if not settings.update:
        return report
    record(scene).save(case.replay)
    return replace(report, action="written")


def _recorded(
    case: Case, settings: ReplaySettings, on_steps: Callable[[int], None] | None, tell: Callable[[str], None] | None
) -> Report:
    recording = Recording.load(case.replay)
    if recording.scene.gone:
        return _orphaned(case, recording, settings)
    outcome = rerun(recording, tolerance=settings.tolerance, heavy=settings.heavy, on_steps=on_steps)
    report = Report(case, outcome.verdict, outcome, scene=str(recording.scene.path or ""))
    if settings.update == "all" or (settings.update == "changed" and not outcome.passed):
        _renew(recording, recording.load_scene(), case)
        return replace(report, action="written")
    outcome = explained(recording, outcome, tell)
    return replace(report, outcome=outcome, where=divergence_location(recording, outcome))


def _orphaned(case: Case, recording: Recording, settings: ReplaySettings) -> Report:
    report = Report(case, "orphaned", scene=str(recording.scene.path))
    if not settings.prune or is_lent(case.replay):
        return report
    case.replay.unlink()
    return replace(report, action="removed")


def _renew(recording: Recording, scene: Scene, case: Case) -> None:
    """Record the same commands anew. Raises `RecordingError` if the scene refuses one."""
    embed = recording.scene.content is not None
    try:
        renewed = record(scene, recording.steps, recording.commands)
    except RefusedCommandError as error:
        raise refused_in(case.replay, error) from None
    renewed.save(case.replay, embed=embed)
