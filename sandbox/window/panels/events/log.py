"""The events of the steps that were seen, as a table that is filtered quickly."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sandbox.engine.events.events import KINDS, Events
from sandbox.engine.events.happening import HAPPENINGS
from sandbox.replay.timeline import Timeline
from sandbox.tables import Integers
from sandbox.window.history import Branches
from sandbox.window.panels.events.rows import NOBODY, ROW, rows_of, sorts_of, told_by_rules

MOST_ROWS = 50_000
"""When there are more, the older half of them is forgotten."""


Book = tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]
"""Ids of bodies and of joints, by row, and what rules told."""


@dataclass(frozen=True)
class LoggedEvent:
    """One event in words. `point` (m) is where bodies met, None for other kinds; `joint` is one that broke.

    `said` is what a rule or control did, with the figures and ids that it tells.
    """

    step: int
    kind: str
    bodies: tuple[str, ...]
    point: tuple[float, float] | None = None
    speed: float = 0.0
    impulse: float = 0.0
    joint: str | None = None
    said: str = ""


@dataclass
class Filter:
    """What is shown: events of these kinds whose kind or ids hold every word."""

    kinds: set[str] = field(default_factory=lambda: set(KINDS))
    words: str = ""

    @property
    def key(self) -> tuple[object, ...]:
        """Changes when the filter does."""
        return frozenset(self.kinds), self.words.lower().split()


class EventTable:
    """Rows of events, and the ids of who they speak of, by step."""

    def __init__(self) -> None:
        self._rows: Any = np.zeros(1024, ROW)
        self._count = 0
        self._names: dict[int, Book] = {}
        self._last: Book = (), (), ()
        self._noted: set[int] = set()
        self._branches = Branches()
        self._found: tuple[tuple[object, ...], Integers] | None = None
        self._known: dict[tuple[int, str], Any] = {}
        self.forgotten = False
        """Whether older events were forgotten, for there were too many."""

    def __len__(self) -> int:
        return self._count

    def follow(self, timeline: Timeline) -> None:
        """Forget what is no longer so."""
        parting = self._branches.parting(timeline)
        if parting is None:
            return
        self._keep(self._rows["step"][: self._count] <= parting)
        self._noted = {step for step in self._noted if step <= parting}

    def note(self, events: Events) -> None:
        """Keep the events of a step, unless they are known."""
        if events.step in self._noted:
            return
        self._noted.add(events.step)
        fresh = rows_of(events)
        if not len(fresh):
            return
        self._names[events.step] = self._book(events)
        if self._count + len(fresh) > len(self._rows):
            self._rows = np.concatenate([self._rows, np.zeros(max(len(self._rows), len(fresh)), ROW)])
        self._rows[self._count : self._count + len(fresh)] = fresh
        self._count += len(fresh)
        self._found = None
        if self._count > MOST_ROWS:
            self._forget_older()

    def _book(self, events: Events) -> Book:
        """The ids that a step's events speak of: the same object as before while they are the same."""
        said = told_by_rules(events)
        if (self._last[0] is not events.names) or (self._last[1] is not events.joint_names) or self._last[2] != said:
            self._last = events.names, events.joint_names, said
        return self._last

    def matching(self, wanted: Filter) -> Integers:
        """The numbers of the events that a filter lets through, latest step first."""
        key = wanted.key
        if self._found is None or self._found[0] != key:
            self._found = key, self._search(wanted)
        return self._found[1]

    def event(self, number: int) -> LoggedEvent:
        """The event of that number."""
        row = self._rows[number]
        step, kind = int(row["step"]), KINDS[int(row["kind"])]
        names, joints, said = self._names[step]
        a, b = int(row["a"]), int(row["b"])
        if kind == "joint_break":
            return LoggedEvent(step, kind, (), joint=joints[a])
        if kind in HAPPENINGS:
            return LoggedEvent(step, kind, tuple(name for name in names if name in said[a].split()), said=said[a])
        bodies = tuple(names[index] for index in (a, b) if index != NOBODY)
        point = None if np.isnan(row["x"]) else (float(row["x"]), float(row["y"]))
        return LoggedEvent(step, kind, bodies, point, float(row["speed"]), float(row["impulse"]))

    def _search(self, wanted: Filter) -> Integers:
        rows = self._rows[: self._count]
        chosen = np.array([kind in wanted.kinds for kind in KINDS])
        found = np.flatnonzero(chosen[rows["kind"]] & self._holding(wanted.words.lower().split()))
        return found[np.argsort(-rows["step"][found], kind="stable")]

    def _holding(self, words: list[str]) -> Any:
        """Which events hold all the words, in their kind or in the ids of who they speak of."""
        rows = self._rows[: self._count]
        held = np.ones(self._count, np.bool_)
        if not words:
            return held
        steps, at = np.unique(rows["step"], return_inverse=True)
        books = [self._names[step] for step in steps.tolist()]
        for book in {id(book): book for book in books}.values():
            mine = np.array([other is book for other in books])[at]
            for word in words:
                held[mine] &= self._has(book, word, rows[mine])
        return held

    def _has(self, book: Book, word: str, rows: Any) -> Any:
        """Which of the rows, that speak of the ids in `book`, hold a word."""
        held = np.array([word in kind for kind in KINDS])[rows["kind"]]
        bodies, joints, said = (self._having(names, word) for names in book)
        of_body, of_joint, of_rule = sorts_of(rows["kind"])
        for has, mine in ((bodies, of_body), (joints, of_joint), (said, of_rule)):
            held |= has[np.where(mine, rows["a"], NOBODY)]
        return held | bodies[rows["b"]]

    def _having(self, names: tuple[str, ...], word: str) -> Any:
        """Which names have a word in them, and a last one that has none, for nobody."""
        key = id(names), word
        if key not in self._known:
            self._known[key] = np.array([*(word in name.lower() for name in names), False])
        return self._known[key]

    def _keep(self, mask: Any) -> None:
        kept = self._rows[: self._count][mask]
        self._rows[: len(kept)] = kept
        self._count, self._found, self._known = len(kept), None, {}
        there = set(np.unique(kept["step"]).tolist())
        self._names = {step: names for step, names in self._names.items() if step in there}

    def _forget_older(self) -> None:
        order = np.argsort(self._rows["step"][: self._count], kind="stable")
        newer = np.zeros(self._count, np.bool_)
        newer[order[-(MOST_ROWS // 2) :]] = True
        self._keep(newer)
        self.forgotten = True
