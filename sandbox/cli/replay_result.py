"""The reports as the JSON document that `--json` prints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from sandbox._version import __version__
from sandbox.cli.replay_messages import advice, reasons
from sandbox.replay.golden.examine import Report


def document(reports: Sequence[Report], code: int, seconds: float) -> dict[str, Any]:
    """The whole outcome; its keys only ever grow in number."""
    return {
        "format": 1,
        "sandbox": __version__,
        "exit_code": code,
        "seconds": round(seconds, 3),
        "replays": [_entry(report) for report in reports],
    }


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
        entry["problems"] = [asdict(problem) for problem in report.problems]
    if report.outcome is not None:
        found = plain(asdict(report.outcome))
        entry |= {key: found[key] for key in ("steps", "divergence", "drifts", "edits", "notes")}
        entry["seconds"] = round(report.outcome.seconds, 3)
    return entry


def plain(value: Any) -> Any:
    """Data that JSON can say: numbers that are not finite become null."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    return [plain(entry) for entry in value] if isinstance(value, (list, tuple)) else value
