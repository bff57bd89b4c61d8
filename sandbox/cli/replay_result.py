"""The reports, as the document of `--json` has them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from sandbox.cli.replay_messages import advice, reasons
from sandbox.replay.golden.examine import Report


def facts(reports: Sequence[Report], seconds: float) -> dict[str, Any]:
    """The whole outcome."""
    return {"seconds": round(seconds, 3), "replays": [_entry(report) for report in reports]}


def _entry(report: Report) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "path": report.case.replay.as_posix(),
        "scene": report.scene or None,
        "verdict": report.verdict,
        "action": report.action or None,
        "where": report.where or None,
        "reasons": reasons(report),
        "advice": advice(report),
    }
    if report.problems:
        elsewhere = report.source if report.source != entry["path"] else ""
        entry["problems"] = [asdict(problem) | {"source": problem.source or elsewhere} for problem in report.problems]
    if report.outcome is not None:
        found = asdict(report.outcome)
        entry |= {key: found[key] for key in ("steps", "divergence", "drifts", "edits", "notes")}
        entry["seconds"] = round(report.outcome.seconds, 3)
    return entry
