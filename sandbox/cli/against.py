"""`sandbox replay --against REV`: recordings held against what another revision of the engine does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from sandbox.cli.progress import SceneProgress
from sandbox.errors import FileError, Problem, SandboxError
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import Report
from sandbox.replay.golden.source_location import divergence_location, location_in_scene
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.against import against
from sandbox.replay.revisions.worktree import Repository, Worktree
from sandbox.scene import Scene, load_scene

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.report.failure import Failure


class Against:
    """A context manager: the code of a git revision, checked out for as long as it is needed.

    Raises `SandboxError` if there is no such code.
    """

    def __init__(self, revision: str, engine: Path | None, no_jit: bool) -> None:
        repository = Repository(engine)
        self._commit = repository.commit(revision)
        self._tree = Worktree(repository)
        self._no_jit = no_jit

    def __enter__(self) -> Self:
        self._root = self._tree.__enter__().checkout(self._commit)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._tree.__exit__(kind, error, trace)

    def reports(self, cases: Sequence[Case], console: Console) -> Iterator[Report]:
        """One report a case: passed if both do the same, else diverged."""
        with SceneProgress(console, 1, "files") as progress:
            progress.begin(f"against {self._commit.hash[:12]}", len(cases))
            for done, case in enumerate(cases, 1):
                yield self._report(case)
                progress.done(done)

    def failure(self, report: Report, most: int) -> Failure | None:
        """What a page shows of a report. Raises `SandboxError` or `OSError`."""
        from sandbox.report.failure_against import failure_against

        return failure_against(report, self._commit, self._root, self._no_jit, most)

    def _report(self, case: Case) -> Report:
        try:
            what = load_scene(case.scene) if case.scene is not None else Recording.load(case.replay)
            outcome = against(what, self._commit, self._root, self._no_jit)
        except FileError as error:
            return Report(case, "unusable", source=error.source, problems=tuple(error.problems))
        except (SandboxError, OSError) as error:
            return Report(case, "unusable", source=str(case.scene or case.replay), problems=(Problem(str(error)),))
        report = Report(case, outcome.verdict, outcome, scene=str(case.scene or ""))
        if isinstance(what, Recording):
            return replace(report, where=divergence_location(what, outcome))
        return replace(report, where=_where(what, report))


def _where(scene: Scene, report: Report) -> str:
    parted = report.outcome.divergence if report.outcome else None
    return location_in_scene(scene, parted.detail.body) if parted and parted.detail else ""
