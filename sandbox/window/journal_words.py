"""The words of a journal: commands and futures are written once, and called by their numbers from then on.

```
[STEP, NAME, {...}]          a command; it is the last of the run
{"aside": [STEP, NAME, ...]} a command of another future only
{"again": RANGES}            commands that were written before are the last of the run: [[first, end], ...]
{"keep": N, "steps": N}      the run has only so many of its commands, and is known so far
{"steps": N} {"at": N}       how far the run is known; where in it the user stands
{"script": RANGES}           what a session of a recording began with
{"future": [LABEL, RANGES, STEPS]}
{"undo": STACK} {"redo": STACK} {"deeds": STACK} {"branches": STACK}
```

A stack is `{"drop": N, "keep": N, "add": [...]}`: without its first, then only so many, then with those. What can be
undone is `[LABEL, FUTURE, STEP, APPLIED, [FUTURE, ...]]`, a deed `[LABEL, COMMAND]`, a branch a future's number.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import is_
from typing import Any

from sandbox.replay.moment import Future, Moment, Past, common_prefix
from sandbox.replay.recording.command_words import TimedCommand, encode

Range = list[int]


class Words:
    """Says what is new, as lines; `lines` are those that are not written yet."""

    def __init__(self) -> None:
        self.lines: list[Any] = []
        self._numbers: dict[int, int] = {}
        self._alive: list[Any] = []
        """What has a number: the identity of a thing that is gone would be another's."""
        self._commands = self._futures = 0
        self._run: list[TimedCommand] = []
        self._count = 0
        self._ranged: tuple[list[TimedCommand], int, list[Range]] = [], 0, []
        """The list of commands whose ranges were asked for last, how many of it, and these."""
        self._stacks = {
            "undo": Stack(self._moment), "redo": Stack(self._moment), "branches": Stack(self._future),
            "deeds": Stack(lambda deed: [deed[0], self._command(deed[1])]),
        }  # fmt: skip

    def script(self, commands: Sequence[TimedCommand]) -> None:
        """What a session of a recording began with."""
        if commands:
            self.lines.append({"script": self._ranges(list(commands), len(commands))})

    def run(self, commands: list[TimedCommand], steps: int, known: int) -> None:
        """The run is that now, over `steps` steps, of which the journal knows `known`."""
        if commands is not self._run or len(commands) < self._count:
            same = common_prefix(self._run[: self._count], commands)
            if same < self._count or steps < known:
                self.lines.append({"keep": same, "steps": steps})
            self._run, self._count = commands, same
        old: list[Range] = []
        for row in commands[self._count :]:
            if id(row) in self._numbers:
                _extend(old, self._numbers[id(row)])
                continue
            self._flush(old)
            self._name(row, [row[0], *encode(row[1])])
        self._flush(old)
        self._count = len(commands)

    def past(self, past: Past) -> None:
        """What else is known."""
        for name, stack in self._stacks.items():
            change = stack.change(getattr(past, name))
            if change is not None:
                self.lines.append({name: change})

    def _flush(self, ranges: list[Range]) -> None:
        if ranges:
            self.lines.append({"again": list(ranges)})
            ranges.clear()

    def _name(self, row: TimedCommand, line: Any) -> int:
        self._numbers[id(row)] = self._commands
        self._alive.append(row)
        self.lines.append(line)
        self._commands += 1
        return self._commands - 1

    def _command(self, row: TimedCommand) -> int:
        found = self._numbers.get(id(row))
        return self._name(row, {"aside": [row[0], *encode(row[1])]}) if found is None else found

    def _ranges(self, commands: list[TimedCommand], count: int) -> list[Range]:
        """The numbers of the first `count` commands of a list to which more may have been added since."""
        before, known, ranges = self._ranged
        if before is not commands or known > count:
            known, ranges = 0, []
        ranges = [list(one) for one in ranges]
        for row in commands[known:count]:
            _extend(ranges, self._command(row))
        self._ranged = commands, count, ranges
        return ranges

    def _future(self, future: Future) -> int:
        if id(future) not in self._numbers:
            self.lines.append({"future": [future.label, self._ranges(future.commands, future.known), future.length]})
            self._numbers[id(future)] = self._futures
            self._alive.append(future)
            self._futures += 1
        return self._numbers[id(future)]

    def _moment(self, moment: Moment) -> list[Any]:
        branches = [self._future(branch) for branch in moment.branches]
        return [moment.label, self._future(moment.future), moment.step, moment.applied, branches]


class Stack:
    """Things that come and go at the end, and now and then the first; `encode` says one."""

    def __init__(self, encode: Callable[[Any], Any]) -> None:
        self._encode = encode
        self._said: list[Any] = []

    def change(self, now: Sequence[Any]) -> dict[str, Any] | None:
        """What has become of it since it was asked last; None if nothing has."""
        said = self._said
        if len(now) == len(said) and all(map(is_, now, said)):
            return None
        drop = next((place for place, one in enumerate(said) if now and one is now[0]), 0)
        keep = next(
            (place for place, (a, b) in enumerate(zip(said[drop:], now, strict=False)) if a is not b),
            min(len(said) - drop, len(now)),
        )
        self._said = list(now)
        return {"drop": drop, "keep": keep, "add": [self._encode(one) for one in now[keep:]]}


def _extend(ranges: list[Range], number: int) -> None:
    """One number more."""
    if ranges and ranges[-1][1] == number:
        ranges[-1][1] += 1
    else:
        ranges.append([number, number + 1])
