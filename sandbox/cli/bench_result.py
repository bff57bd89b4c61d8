"""What became of one scene given to `sandbox bench`, as plain data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox.cli.document import document
from sandbox.cli.failures import HOLDS, UNUSABLE, problems

if TYPE_CHECKING:
    from sandbox.bench.race import Race, Result


@dataclass(frozen=True)
class BenchResult:
    """One scene: its `title` and `race`, or the `error` that kept it from running."""

    path: Path
    title: str = ""
    race: Race | None = None
    error: Exception | None = None


def exit_code(results: Sequence[BenchResult]) -> int:
    """2 if a scene could not be used, else 0."""
    return UNUSABLE if any(result.race is None for result in results) else HOLDS


def text(results: Sequence[BenchResult], seconds: float) -> str:
    """The whole outcome as a JSON document."""
    scenes = [_scene_entry(result) for result in results]
    return document({"seconds": round(seconds, 3), "scenes": scenes}, exit_code(results))


def _scene_entry(result: BenchResult) -> dict[str, Any]:
    entry: dict[str, Any] = {"path": result.path.as_posix()}
    race = result.race
    if race is None:
        return {**entry, "problems": problems(result.error)}
    return {
        **entry,
        "title": result.title,
        "steps": race.steps,
        "bodies": race.bodies,
        "shapes": race.shapes,
        "joints": race.joints,
        "peak_resident_bytes": race.peak_resident_bytes,
        "engines": [_engine_entry(each) for each in race.results],
    }


def _engine_entry(result: Result) -> dict[str, Any]:
    quality, own = result.quality, result.own
    entry = {
        "name": result.name,
        "label": result.label,
        "notes": list(result.notes),
        "build_ms": result.build,
        "first_step_ms": result.first,
        "ms_per_step": result.step,
        "turns_ms_per_step": list(result.turns),
        "changes_ms_per_step": result.changes,
        "sandbox_over_this": result.ratio,
        "deepest_overlap_m": quality.deepest,
        "overlapping_pairs": quality.overlapping,
        "kinetic_energy_j": quality.kinetic,
        "escaped": quality.escaped,
        "lost": quality.lost,
    }
    if own is None:
        return entry
    facts = asdict(own)
    stages = facts.pop("stages")
    return {**entry, **facts, **({"stages_ms_per_step": stages} if stages else {})}
