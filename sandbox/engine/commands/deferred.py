"""Bodies that commands have told to go and to come, until somebody looks at the world or it steps.

What such a command costs is not its own rows, but to bring up to date whatever knows of rows: that is done once for all
that wait. Each is checked when it comes, and refused then if it has to be: what waits can be done.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from sandbox.scene.known import Known
from sandbox.scene.spawned import Spawned
from sandbox.world.directory import Directory
from sandbox.world.state import Deferring, State, apply_deferred

Rows: TypeAlias = tuple[int, ...]


class Waiting(NamedTuple):
    """The rows of the bodies that go, command by command, and what comes after that."""

    going: list[Rows]
    coming: list[Spawned]


class Deferred:
    """The deferred commands of one world. What they ask for is done by `apply`, once, which takes what waits."""

    __slots__ = ("_apply", "_bodies", "_directory", "_names", "_patterns", "_shapes", "_state", "_waiting")

    def __init__(self, state: State, directory: Directory, apply: Callable[[], None]) -> None:
        self._state, self._directory, self._apply = state, directory, apply
        self._patterns = state.patterns
        self._waiting = Waiting([], [])
        self._names: set[str] = set()
        """Of the bodies that come."""
        self._bodies = self._shapes = 0
        """How many bodies come, and how many shapes there are with theirs."""

    def apply(self) -> None:
        """Do what waits, if something does."""
        apply_deferred(self._state)

    def take(self) -> Waiting:
        """What waits, for who does it now."""
        waiting = self._waiting
        self._waiting, self._names, self._bodies = Waiting([], []), set(), 0
        return waiting

    def known(self) -> Known:
        """What a body that comes may refer to. Those that go are no longer there, but still count."""
        if not isinstance(self._state, Deferring):
            self._shapes = len(self._state.shapes)
        return self._directory.known(self._shapes, self._bodies)

    def remove(self, names: Sequence[str]) -> None:
        """Bodies of those ids go. Raises `UnknownBodyError`, and lets none of them wait, if there is no such body."""
        if not self._names.isdisjoint(names):  # what comes has no row yet
            self.apply()
        rows = [self._directory.standing(name) for name in names]
        self._directory.remove(names)
        self._wait()
        self._waiting.going.append(tuple(dict.fromkeys(rows)))

    def add(self, found: Spawned) -> bool:
        """Bodies come, whose ids are new; False if they have to come at once, as that may fail, or as what is there
        minds how it was when they came."""
        if any(body.type != "dynamic" for body in found.bodies) or not self._patterns.has(found.bodies):
            return False
        self._wait()
        names = [body.id for body in found.bodies]
        self._directory.announce(names, self._bodies)
        self._names.update(names)
        self._bodies += len(names)
        self._shapes += sum(len(body.shapes) for body in found.bodies)
        self._waiting.coming.append(found)
        return True

    def _wait(self) -> None:
        if not isinstance(self._state, Deferring):
            self._shapes = len(self._state.shapes)
            self._state.defer(self._apply)
