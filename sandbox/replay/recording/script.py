"""What is to be done to a run: commands with the steps that they come after."""

from __future__ import annotations

from numbers import Integral
from typing import Any

from sandbox.arguments import check_kind, checked_list, shown
from sandbox.engine.commands.base import Command
from sandbox.errors import ArgumentError
from sandbox.replay.recording.command_words import TimedCommand


def checked_script(call: str, commands: Any) -> list[TimedCommand]:
    """Pairs (step, command), with Python's own numbers. Raises `ArgumentError` with the index of what is none."""
    found = []
    for k, row in enumerate(checked_list(call, "a list of pairs (step, command)", commands)):
        if not isinstance(row, (tuple, list)) or len(row) != 2:
            raise ArgumentError(f"{call}: commands[{k}] is a pair (step, command), not {shown(row)}")
        step, command = row
        if not isinstance(step, Integral) or isinstance(step, bool):
            raise ArgumentError(f"{call}: commands[{k}] begins with a step, a whole number, not {shown(step)}")
        check_kind(f"{call}: commands[{k}]", "a command, such as sandbox.SetPose", command, Command)
        found.append((int(step), command))
    return found
