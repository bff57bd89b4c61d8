"""The controls of a scene as keys with what they do."""

from __future__ import annotations

from collections.abc import Iterable

from sandbox.engine.views.game import ControlState
from sandbox.window.hint import Key

BACKWARDS = ["Right", "Left"], ["Down", "Up"]
"""How no keyboard has them."""


def control_keys(controls: Iterable[ControlState]) -> tuple[Key, ...]:
    """One for each control, with the first of its inputs: keys, else the mouse, else a gamepad."""
    return tuple(Key(tuple(_caps(control)), control.title or control.id) for control in controls)


def _caps(control: ControlState) -> list[str]:
    keys = [key.title() for key in (*control.minus[:1], *control.keys[:1])]
    if keys:
        return keys[::-1] if keys in BACKWARDS else keys
    return [f"Mouse {name}" for name in control.mouse[:1]] or [f"Pad {name}" for name in control.pad[:1]]
