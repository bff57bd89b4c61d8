"""`sandbox replay --against REV`: recordings held against what another revision of the engine does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from sandbox.cli.progress import SceneProgress
from sandbox.errors import FileError, Problem, SandboxError
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import Report
from sandbox.replay.golden.whereabouts import place_in_scene, whereabouts
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.against import against
from sandbox.replay.revisions.worktree import Commit, Repository, Worktree
from sandbox.scene import Scene, load_scene

if TYPE_CHECKING:
    from rich.console import Console


def reports_against(
    cases: Sequence[Case], revision: str, engine: Path | None, no_jit: bool, console: Console
) -> Iterator[Report]:
    """One report a case: passed if both do the same, else diverged. Raises `SandboxError` if there is no such code."""
    repository = Repository(engine)
    commit = repository.commit(revision)
    with Worktree(repository) as tree, SceneProgress(console, 1, "files") as progress:
        root = tree.checkout(commit)
        progress.begin(f"against {commit.hash[:12]}", len(cases))
        for done, case in enumerate(cases, 1):
            yield _report(case, commit, root, no_jit)
            progress.done(done)


def _report(case: Case, commit: Commit, root: Path, no_jit: bool) -> Report:
    try:
        what = load_scene(case.scene) if case.scene is not None else Recording.load(case.replay)
        outcome = against(what, commit, root, no_jit)
    except FileError as error:
        return Report(case, "unusable", source=error.source, problems=tuple(error.problems))
    except (SandboxError, OSError) as error:
        return Report(case, "unusable", source=str(case.scene or case.replay), problems=(Problem(str(error)),))
    report = Report(case, outcome.word, outcome, scene=str(case.scene or ""))
    if isinstance(what, Recording):
        return replace(report, where=whereabouts(what, outcome))
    return replace(report, where=_where(what, report))


def _where(scene: Scene, report: Report) -> str:
    parted = report.outcome.divergence if report.outcome else None
    return place_in_scene(scene, parted.detail.body) if parted and parted.detail else ""
