"""Places in runs that can be gone back to, and the futures that are known there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sandbox.engine.world import LastStep
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.tape import Tape


@dataclass(frozen=True)
class Future:
    """A run known up to `length` steps, called by what was done in it last (empty: nothing).

    The lists are those of that time; what is appended to them later is not part of it, so a count goes with them.
    """

    label: str
    commands: list[TimedCommand]
    known: int
    tape: Tape
    length: int

    def script(self) -> list[TimedCommand]:
        """Its commands, as a list of its own."""
        return self.commands[: self.known]


@dataclass(frozen=True)
class Moment:
    """A place in a future, after `step` steps and `applied` commands; `label` is the act that begins there.

    `branches` are the other futures of that time.
    """

    label: str
    future: Future
    step: int
    applied: int
    branches: tuple[Future, ...]


@dataclass(frozen=True)
class Past:
    """What a timeline knows besides its run: what can be undone and redone (the next one last), the other futures, and
    the last command of each act. Entries that two of them have in common are the same objects.
    """

    undo: Sequence[Moment] = ()
    redo: Sequence[Moment] = ()
    branches: Sequence[Future] = ()
    deeds: Sequence[tuple[str, TimedCommand]] = ()


@dataclass(frozen=True)
class Mark:
    """A place in a run to which commands can be taken back; `held` are drags of a future that they will replace."""

    step: int
    applied: int
    snapshot: bytes
    last_step: LastStep
    held: frozenset[str]


def common_prefix(a: Sequence[TimedCommand], b: Sequence[TimedCommand]) -> int:
    """How many commands two runs begin with in common."""
    return next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x is not y), min(len(a), len(b)))


def parting(a: Sequence[TimedCommand], b: Sequence[TimedCommand]) -> tuple[int, int | None]:
    """How many commands two runs have in common, and the step after which they go different ways; None if in none."""
    common = common_prefix(a, b)
    return common, min((step for step, _ in (*a[common : common + 1], *b[common : common + 1])), default=None)
