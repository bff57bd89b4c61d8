"""What became of one file given to `sandbox compare`, as plain data."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from sandbox.cli.failures import FAILED, HOLDS, UNUSABLE, problems

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sandbox.reference.comparison_result import Comparison, Disagreement
    from sandbox.scene import Scene

FileVerdict = Literal["agrees", "disagrees", "unusable"]


@dataclass(frozen=True)
class Result:
    """One file: its `scene`, `tally` and the test files `saved`, or the `error` that kept it from running."""

    path: Path
    scene: Scene | None = None
    tally: Comparison | None = None
    saved: list[Path] = field(default_factory=list)
    error: Exception | None = None

    @property
    def verdict(self) -> FileVerdict:
        """The verdict on the file in one word."""
        if self.tally is None:
            return "unusable"
        return "agrees" if self.tally.agrees else "disagrees"


def exit_code(results: Sequence[Result]) -> int:
    """2 if a file could not be used, else 1 if there is a disagreement or a missed pair, else 0."""
    words = {result.verdict for result in results}
    return UNUSABLE if "unusable" in words else FAILED if "disagrees" in words else HOLDS


def facts(results: Sequence[Result], seconds: float) -> dict[str, Any]:
    """The whole outcome, as the document of `--json` has it."""
    from sandbox.reference.ask_pymunk import PYMUNK_VERSION

    return {
        "pymunk": PYMUNK_VERSION,
        "seconds": round(seconds, 3),
        "scenes": [_scene_entry(result) for result in results],
    }


def _scene_entry(result: Result) -> dict[str, Any]:
    entry: dict[str, Any] = {"path": result.path.as_posix(), "verdict": result.verdict}
    tally = result.tally
    if tally is None or result.scene is None:
        return {**entry, "problems": problems(result.error)}
    return {
        **entry,
        "title": result.scene.title,
        "steps": tally.steps,
        "pairs": tally.pairs,
        "agreed": tally.agreed,
        "touching": tally.touching,
        "pymunk_wrong": dict(tally.pymunk_wrong),
        "disagreed": tally.disagreed,
        "missed": tally.missed,
        "other_axis": tally.other_axis,
        "worst_depth_m": tally.depth_error,
        "worst_normal_degrees": math.degrees(tally.normal_error),
        "disagreements": [_disagreement_entry(found) for found in tally.disagreements],
        "misses": [asdict(miss) for miss in tally.misses],
        "saved": [path.as_posix() for path in result.saved],
    }


def _disagreement_entry(found: Disagreement) -> dict[str, Any]:
    truth = found.ruling.truth
    return {
        "step": found.step,
        "what": found.what,
        "names": list(found.names),
        "shapes": list(found.shapes),
        "wrong": found.who_is_wrong,
        "sandbox": asdict(found.ours),
        "pymunk": asdict(found.theirs),
        "exact": asdict(truth),
        "pair": asdict(found.pair),
    }
