"""What commands leave for the events to tell: contacts and sensings of deleted bodies, and bodies put elsewhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from sandbox.tables import Integers, Records, plain
from sandbox.world.contact_rows import contacts_of
from sandbox.world.state import State

Vec = tuple[float, float]


@dataclass(frozen=True)
class ShapeKey:
    """A shape by what no change of rows alters: its body's serial number and id, and which of its shapes it is."""

    serial: int
    name: str
    shape: int


@dataclass(frozen=True)
class DeletedPair:
    """Two shapes that touched until a body of theirs was deleted; `figures` is x, y, normal x and y."""

    first: ShapeKey
    second: ShapeKey
    figures: tuple[float, ...] = ()


DeletedPairs: TypeAlias = tuple[list[DeletedPair], list[DeletedPair]]
"""Contacts, and sensors with what they sensed."""


class PendingEvents:
    """What commands did between two steps, as far as the events before and after have to know."""

    __slots__ = ("_next", "ends", "leaves", "places")

    def __init__(self) -> None:
        self.places: dict[int, Vec] = {}
        """Where the centres of bodies (by row) were before commands put them elsewhere, m."""
        self.ends: list[DeletedPair] = []
        """Contacts that the events of the last step have to tell as ended."""
        self.leaves: list[DeletedPair] = []
        """The same for sensors (first) and what they sensed (second)."""
        self._next: DeletedPairs = ([], [])

    @property
    def deleted(self) -> DeletedPairs:
        """What was deleted since the last step, for the events of the next. A copy."""
        return list(self._next[0]), list(self._next[1])

    @deleted.setter
    def deleted(self, pairs: DeletedPairs) -> None:
        self._next = list(pairs[0]), list(pairs[1])

    def begin_step(self) -> None:
        """A step begins: its events tell what was deleted before it."""
        (self.ends, self.leaves), self._next = self._next, ([], [])
        self.places = {}

    def note_displaced(self, row: int, center: Vec) -> None:
        """A command has put the body of that row elsewhere; `center` is where its centre was."""
        self.places.setdefault(row, center)

    def note_going(self, state: State, going: Sequence[tuple[int, ...]], sensed: Records | None) -> None:
        """Bodies will be deleted, of those rows, command by command: what touches them, or is `sensed` with them, will
        do so no more, and is told of in that order."""
        gone = np.array(sorted(row for rows in going for row in rows), np.int64)
        count = int(plain(state.counters)["contact_count"][0])
        near = plain(state.contacts)[contacts_of(state.contacts, count, gone, state.resting)]
        touched = near[near["touching"] == 1]
        if len(touched):
            self._next[0].extend(_contacts(state, _in_order(touched, ("body_a", "body_b"), going)))
        if sensed is not None:
            rows = plain(sensed)
            left = rows.take(np.flatnonzero(np.isin(rows["sensor_body"], gone) | np.isin(rows["body"], gone)))
            left = _in_order(left, ("sensor_body", "body"), going)
            keys = _keys(state, left["sensor_body"], left["sensor"]), _keys(state, left["body"], left["shape_index"])
            self._next[1].extend(map(DeletedPair, *keys))

    def note_rows(self) -> None:
        """Rows have moved; the events of the last step are known."""
        self.places = {}


def _in_order(pairs: Any, bodies: tuple[str, str], going: Sequence[tuple[int, ...]]) -> Any:
    """Pairs of bodies as the first of both goes, command by command; those of one command stay in their order."""
    if len(going) == 1 or len(pairs) < 2:
        return pairs
    turn = {row: k for k, rows in enumerate(going) for row in rows}
    sides = (pairs[name].tolist() for name in bodies)
    turns = [min(turn.get(a, len(going)), turn.get(b, len(going))) for a, b in zip(*sides, strict=True)]
    return pairs[np.argsort(turns, kind="stable")]


def _keys(state: State, bodies: Integers, shapes: Integers) -> list[ShapeKey]:
    """The keys of shapes, given by their rows and those of their bodies."""
    ledger = state.census.bodies
    numbers = (shapes - _first_shapes(state, bodies)).tolist()
    return [
        ShapeKey(ledger.serials[body], ledger.names[body], number)
        for body, number in zip(bodies.tolist(), numbers, strict=True)
    ]


def _first_shapes(state: State, bodies: Integers) -> Integers:
    """The rows of the first shapes of bodies: shapes lie in the order of these."""
    return np.searchsorted(plain(state.shapes)["body"], bodies)


def _contacts(state: State, rows: Any) -> Iterator[DeletedPair]:
    """What to tell of rows of contacts."""
    centers, two = plain(state.bodies).take(rows["body_a"]), rows["point_count"] == 2
    figures = []
    for k in "xy":
        first, second = rows[f"anchor_a{k}1"], rows[f"anchor_a{k}2"]
        figures.append(centers[f"center_{k}"] + np.where(two, 0.5 * (first + second), first))
    figures += [rows["normal_x"], rows["normal_y"]]
    keys = (_keys(state, rows[f"body_{side}"], rows[f"shape_{side}"]) for side in "ab")
    return map(DeletedPair, *keys, zip(*(column.tolist() for column in figures), strict=True))


class RowLookup:
    """Finds the rows of shapes now, and gives deleted bodies places after all others, which are so many."""

    def __init__(self, state: State, bodies: int) -> None:
        self._state, self._bodies = state, bodies
        self._gone: dict[int, int] = {}
        self._names: list[str] = []

    @property
    def names(self) -> tuple[str, ...]:
        """The ids of deleted bodies that were looked up."""
        return tuple(self._names)

    def rows(self, pairs: Sequence[DeletedPair]) -> tuple[Integers, ...]:
        """For each pair the bodies' indices into all names, and the rows of the shapes; -1 for one that is gone."""
        keys = [key for pair in pairs for key in (pair.first, pair.second)]
        found = np.array([self._body(key) for key in keys], np.int64)
        shapes = _first_shapes(self._state, found) + np.array([key.shape for key in keys], np.int64)
        shapes[found >= self._bodies] = -1
        return found[::2], found[1::2], shapes[::2], shapes[1::2]

    def _body(self, key: ShapeKey) -> int:
        row = self._state.census.bodies.row_of(key.serial)
        if row is not None:
            return row
        if key.serial not in self._gone:
            self._gone[key.serial] = self._bodies + len(self._names)
            self._names.append(key.name)
        return self._gone[key.serial]
