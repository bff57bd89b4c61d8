"""How a user sees what is played: controls, and how it ended."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from sandbox.scene.flat_rules import FlatControl
from sandbox.tables import plain
from sandbox.world.build_rules import outcome_texts
from sandbox.world.rule_records import OPEN, WON
from sandbox.world.state import State


@dataclass(frozen=True)
class ControlState:
    """A control and how it is held: `value` from -1 to 1, 0 if it is not; `pointer` is where the mouse was told to be.

    `keys`, `minus`, `pad` and `mouse` are the inputs that hold it, as in a scene file.
    """

    id: str
    title: str
    keys: tuple[str, ...]
    minus: tuple[str, ...]
    pad: tuple[str, ...]
    mouse: tuple[str, ...]
    value: float
    pointer: tuple[float, float]


@dataclass(frozen=True)
class Ending:
    """How a game ended: "won" or "lost", the text for the player, and the step after which it was decided."""

    result: Literal["won", "lost"]
    text: str
    step: int


def control_states(state: State) -> tuple[ControlState, ...]:
    """The controls of a state, in the order of the scene."""
    flat = state.census.scene.controls
    return tuple(_control(control, row) for control, row in zip(flat, plain(state.controls), strict=True))


def _control(control: FlatControl, row: Any) -> ControlState:
    value, x, y = (float(row[name]) for name in ("value", "pointer_x", "pointer_y"))
    inputs = control.keys, control.minus, control.pad, control.mouse
    return ControlState(control.id, control.title, *inputs, value, (x, y))


def counter_values(state: State) -> dict[str, float]:
    """The counters of a state by name."""
    flat = state.census.scene.counters
    return {counter.id: float(row["value"]) for counter, row in zip(flat, plain(state.tallies), strict=True)}


def ending(state: State) -> Ending | None:
    """How it ended; None while it is open."""
    if not len(state.outcome) or state.outcome[0].result == OPEN:
        return None
    row, texts = state.outcome[0], outcome_texts(state.census.scene)
    text = texts[int(row.text)] if row.text < len(texts) else ""
    return Ending("won" if row.result == WON else "lost", text, int(row.step))
