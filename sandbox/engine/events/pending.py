"""What commands leave for the events to tell: contacts and sensings of deleted bodies, and bodies put elsewhere."""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers, Records, plain
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

    def note_going(self, state: State, gone: NDArray[np.bool_], sensed: Records | None) -> None:
        """Bodies will be deleted: what touches them, or is `sensed` with them, will do so no more."""
        contacts = plain(state.contacts)[: int(state.counters[0].contact_count)]
        going = contacts[gone[contacts["body_a"]] | gone[contacts["body_b"]]]
        self._next[0].extend(_contact(state, row) for row in going[going["touching"] == 1])
        if sensed is not None:
            rows = sensed[gone[sensed.sensor_body] | gone[sensed.body]]
            keys = ((_key(state, r.sensor_body, r.sensor), _key(state, r.body, r.shape_index)) for r in rows)
            self._next[1].extend(DeletedPair(*pair) for pair in keys)

    def note_rows(self) -> None:
        """Rows have moved; the events of the last step are known."""
        self.places = {}


def _key(state: State, body: int, shape: int) -> ShapeKey:
    ledger = state.census.bodies
    first = bisect_left(plain(state.shapes)["body"], body)
    return ShapeKey(ledger.serials[body], ledger.names[body], int(shape) - first)


def _contact(state: State, row: Any) -> DeletedPair:
    center, two = plain(state.bodies)[row["body_a"]], row["point_count"] == 2
    x, y = (0.5 * (row[f"anchor_a{k}1"] + row[f"anchor_a{k}2"]) if two else row[f"anchor_a{k}1"] for k in "xy")
    figures = (center["center_x"] + x, center["center_y"] + y, row["normal_x"], row["normal_y"])
    keys = _key(state, row["body_a"], row["shape_a"]), _key(state, row["body_b"], row["shape_b"])
    return DeletedPair(*keys, tuple(map(float, figures)))


class RowLookup:
    """Finds the rows of shapes now, and gives deleted bodies places after all others in `names`."""

    def __init__(self, state: State, names: tuple[str, ...]) -> None:
        self._ledger = state.census.bodies
        self._owners: Integers = plain(state.shapes)["body"]
        self.names = names
        self._gone: dict[int, int] = {}

    def rows(self, pair: DeletedPair) -> tuple[int, int, int, int]:
        """The bodies' indices into `names`, and the rows of the shapes; -1 for one that is gone."""
        (a, shape_a), (b, shape_b) = self._find(pair.first), self._find(pair.second)
        return a, b, shape_a, shape_b

    def _find(self, key: ShapeKey) -> tuple[int, int]:
        row = self._ledger.row_of(key.serial)
        if row is not None:
            return row, bisect_left(self._owners, row) + key.shape
        if key.serial not in self._gone:
            self._gone[key.serial] = len(self.names)
            self.names = (*self.names, key.name)
        return self._gone[key.serial], -1
