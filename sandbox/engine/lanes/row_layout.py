"""How a world lies in a row: all its tables but the contacts, one after another, in words of 64 bits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.tables import Integers, Records, Table, plain
from sandbox.world.records import CONTACT, COUNTERS, TABLES
from sandbox.world.state import ARRAYS, State

WORD = 8
_LINE = 8
"""Words of a cache line, at which every table begins."""
CONTACT_WORDS = CONTACT.dtype.itemsize // WORD


@dataclass(frozen=True)
class Place:
    """Where the rows of a table are: its first word, and how many rows there are."""

    table: Table
    array: str
    first: int
    count: int

    @property
    def words(self) -> int:
        """How many words its rows take."""
        return self.count * self.table.dtype.itemsize // WORD


@dataclass(frozen=True)
class RowLayout:
    """The places of all tables, and how many words a row has."""

    places: tuple[Place, ...]
    words: int

    @classmethod
    def of(cls, state: State) -> RowLayout:
        """That of a state. Contacts are not in it, as there are more or fewer of them after each step."""
        places, first = [], 0
        for table, array in zip(TABLES, ARRAYS, strict=True):
            if table is not CONTACT:
                place = Place(table, array, first, len(getattr(state, array)))
                places.append(place)
                first += -(-place.words // _LINE) * _LINE
        return cls(tuple(places), first)

    def new_row(self) -> Integers:
        """An empty row that begins at a cache line. Its tables have no spare rows behind them, and its memory, unlike
        that of `aligned_zeros`, says so to whoever lets them grow."""
        memory = np.zeros(self.words + _LINE, np.int64)
        first = -(memory.ctypes.data // WORD) % _LINE
        return memory[first : first + self.words]

    def views(self, row: Integers) -> dict[str, Records]:
        """The tables in a row, by the names that a state has for them: they share its memory."""
        return {place.array: _view(row, place) for place in self.places}

    def write(self, row: Integers, state: State) -> None:
        """Write the tables of a state, which have as many rows, into a row."""
        for place in self.places:
            self._write(row, place, state)

    def fits_columns(self, state: State) -> bool:
        """Whether a state has as many bodies as the layout, and counters."""
        return all(len(getattr(state, place.array)) == place.count for place in self._shown)

    def write_columns(self, row: Integers, state: State) -> None:
        """Write bodies and counters alone into a row, of a state that `fits_columns`."""
        for place in self._shown:
            self._write(row, place, state)

    @property
    def _shown(self) -> list[Place]:
        return [place for place in self.places if place.array in ("bodies", "counters")]

    def columns(self, rows: Integers, array: str) -> Any:
        """A table in all `rows` (worlds, words): an array of its records (worlds, rows of the table), a view."""
        place = next(place for place in self.places if place.array == array)
        part = rows[:, place.first : place.first + place.words]
        return part.view(place.table.dtype) if place.count else np.zeros((len(rows), 0), place.table.dtype)

    def _write(self, row: Integers, place: Place, state: State) -> None:
        own = plain(getattr(state, place.array))
        row[place.first : place.first + place.words] = own.view(np.int64)[: place.words]

    def counter(self, name: str) -> int:
        """The word of a counter."""
        place = next(place for place in self.places if place.table is COUNTERS)
        offset: int = COUNTERS.dtype.fields[name][1]  # type: ignore[index]
        return place.first + offset // WORD


def _view(row: Integers, place: Place) -> Records:
    """A table of its own in the memory of a row, as `Table.zeros` gives one in memory that it takes."""
    if not place.count:
        return place.table.zeros(0)
    return np.ndarray(place.count, place.table.dtype, row.data, place.first * WORD).view(np.recarray)
