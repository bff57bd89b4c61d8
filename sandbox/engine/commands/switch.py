"""Switching a region or a thruster on or off, whatever its schedule was."""

from __future__ import annotations

from typing import Any

from sandbox.world.field_records import NEVER
from sandbox.world.state import State


def switch(row: Any, enabled: bool | None, state: State) -> None:
    """Let a region or a thruster act from the coming step on, or no more; None leaves its schedule as it is."""
    step = int(state.counters[0].step_count)
    acts = row.start_step <= step < row.end_step
    if enabled:
        row.start_step, row.end_step = row.start_step if acts else step, NEVER
    elif enabled is not None:
        row.end_step = min(int(row.end_step), step)
