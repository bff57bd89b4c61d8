"""What futures are called: by the act that was done in them last."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.replay.recording.command_words import TimedCommand

MOST = 1000
"""Acts that are known at most: the oldest go."""
RECORDED = "the recording"
"""What a future is called in which something was done, but by no act."""


class Deeds:
    """The last command of every act, in the order of the user's time."""

    def __init__(self, last: Sequence[tuple[str, TimedCommand]] = ()) -> None:
        self._label = RECORDED
        self._last = list(last)
        self._fresh = True

    @property
    def last(self) -> Sequence[tuple[str, TimedCommand]]:
        """What acts are called, and their last commands: look at it only."""
        return self._last

    def begin(self, label: str) -> None:
        """What is done from now on is of another act."""
        self._label, self._fresh = label, True

    def note(self, row: TimedCommand) -> None:
        """A command of the act has been applied."""
        if not self._fresh:
            self._last.pop()
        self._last.append((self._label, row))
        self._fresh = False
        del self._last[:-MOST]

    def label(self, commands: Sequence[TimedCommand]) -> str:
        """The act that ends a future; empty if nothing was done in it."""
        known = set(map(id, commands))
        if not known:
            return ""
        return next((label for label, row in reversed(self._last) if id(row) in known), RECORDED)
