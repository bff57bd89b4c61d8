"""What became of one file given to `sandbox check`, as plain data."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from sandbox.cli.failures import FAILED, HOLDS, UNUSABLE, problems

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sandbox.replay.expectations import Verdict
    from sandbox.replay.headless_run import HeadlessRun
    from sandbox.scene import Scene

FileVerdict = Literal["holds", "failed", "unusable"]


@dataclass(frozen=True)
class Result:
    """One file: its `scene` and `run`, or the `error` that kept it from running.

    `lacking`: it expects nothing, and was asked to.
    """

    path: Path
    scene: Scene | None = None
    run: HeadlessRun | None = None
    error: Exception | None = None
    lacking: bool = False

    @property
    def verdict(self) -> FileVerdict:
        """The verdict on the file in one word."""
        if self.run is None:
            return "unusable"
        return "holds" if self.run.holds and not self.lacking else "failed"

    def text(self, verdict: Verdict) -> str:
        """The expectation that `verdict` is about, as its author wrote it, on one line."""
        assert self.scene is not None
        return author_text(self.scene, verdict.index)

    def line(self, verdict: Verdict) -> int:
        """The line of that expectation in its file."""
        assert self.scene is not None
        return _place(self.scene, verdict.index)[0]


def author_text(scene: Scene, index: int) -> str:
    """Expectation `index` as its author wrote it, on one line."""
    if scene.text is None:
        return json.dumps(scene.expect[index].given(), ensure_ascii=False)
    line, column = _place(scene, index)
    rest = "\n".join(scene.text.split("\n")[line - 1 :])[column - 1 :]
    end = json.JSONDecoder().raw_decode(rest)[1]
    return " ".join(rest[:end].split())


def _place(scene: Scene, index: int) -> tuple[int, int]:
    return scene.locate(f"/expect/{index}") or (0, 0)


def exit_code(results: Sequence[Result]) -> int:
    """2 if a file could not be used, else 1 if one failed, else 0."""
    words = {result.verdict for result in results}
    return UNUSABLE if "unusable" in words else FAILED if "failed" in words else HOLDS


def facts(results: Sequence[Result], seconds: float) -> dict[str, Any]:
    """The whole outcome, as the document of `--json` has it."""
    return {"seconds": round(seconds, 3), "scenes": [_scene_entry(result) for result in results]}


def _scene_entry(result: Result) -> dict[str, Any]:
    entry: dict[str, Any] = {"path": result.path.as_posix(), "verdict": result.verdict}
    if result.run is None or result.scene is None:
        return {**entry, "problems": problems(result.error)}
    run = result.run
    return {
        **entry,
        "title": result.scene.title,
        "steps": run.steps,
        "ms_per_step": round(run.milliseconds, 6),
        "digest": run.digest,
        "expectations": [_expectation_entry(result, verdict) for verdict in run.verdicts],
        "unreached": run.unreached,
        "frozen": [{"body": body, "step": step} for body, step in run.frozen],
    }


def _expectation_entry(result: Result, verdict: Verdict) -> dict[str, Any]:
    return {"text": result.text(verdict), "line": result.line(verdict), **asdict(verdict)}
