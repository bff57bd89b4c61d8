"""When a region or thruster acts, in the words of a file: seconds from the start of the scene."""

from __future__ import annotations

from typing import Any

from sandbox.world.export.present import Present
from sandbox.world.field_records import NEVER

LAST = 1e6
"""The latest second that a scene can name."""


def write_schedule(present: Present, words: dict[str, Any], row: Any, first: Any, name: str) -> None:
    """Put the schedule that holds from now on into the words of `row`, which began as `first`."""
    found = present.rescheduled(row, first)
    if found is None:
        return
    start, end = found
    for key in ("start", "end"):
        words.pop(key, None)
    if start == NEVER:
        present.remarks.note("what is over or switched off begins after a million seconds, so that it is there", name)
    if start > 0:
        words["start"] = _seconds(present, start)
    if end < NEVER:
        words["end"] = _seconds(present, end)


def _seconds(present: Present, steps: int) -> float:
    return min(steps / present.step_rate, LAST)
