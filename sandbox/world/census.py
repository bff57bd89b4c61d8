"""Who is behind the rows now: lists that change in place as bodies, joints and regions come and go, in the order of
the rows.

What one that comes or goes costs does not depend on how many there are, but for the moving of what comes after it.
`roster` is the same at one moment, for whoever keeps it.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any, Generic

from sandbox.scene.flat import FlatBody, FlatJoint, FlatRegion, FlatScene
from sandbox.world.roster import Register, Roster, T, Words

_FEW = 8
"""So many gaps are closed one by one, which only moves what lies behind; more of them at once."""


class Ledger(Generic[T]):
    """One table's part of a census: what is behind each row, its id and its serial number, and the words of what was
    spawned."""

    __slots__ = ("_families", "_ids", "_register", "items", "names", "next", "serials", "words")

    def __init__(self, register: Register[T]) -> None:
        self.items: list[T] = list(register.items)
        self.names: list[str] = list(register.names)
        self.serials: list[int] = list(register.serials)
        self.words: dict[int, Words] = dict(register.words)
        self.next = register.next
        self._ids: tuple[str, ...] | None = register.names
        self._register: Register[T] | None = register
        self._families: Counter[str] | None = None
        """How many are called alike but for a number at the end, since somebody asked."""

    def __len__(self) -> int:
        return len(self.items)

    def add(self, items: Sequence[T], words: Sequence[Words]) -> None:
        """Further rows at the end, with the next serial numbers."""
        if not items:
            return
        fresh = range(self.next, self.next + len(items))
        self.items += items
        names = [item.id for item in items]
        self.names += names
        self.serials += fresh
        self.words.update(zip(fresh, words, strict=True))
        self.next += len(items)
        if self._families is not None:
            self._families.update(map(_family, names))
        self._register = self._ids = None

    def remove(self, rows: Sequence[int]) -> list[str]:
        """Take out some rows, given in their order: the others close up. Returns the names of those."""
        if not rows:
            return []
        names = [self.names[row] for row in rows]
        for row in rows:
            self.words.pop(self.serials[row], None)
        runs = _runs(rows)
        columns: tuple[list[Any], ...] = (self.items, self.names, self.serials)
        for column in columns:
            if len(runs) > _FEW:
                ends = [rows[0], *(end for _, end in runs)]
                starts = [*(start for start, _ in runs), len(column)]
                column[rows[0] :] = chain.from_iterable(map(column.__getitem__, map(slice, ends, starts)))
            else:
                for first, end in reversed(runs):
                    del column[first:end]
        self._register = self._ids = None
        if self._families is not None:
            self._families.subtract(map(_family, names))
        return names

    def numbered(self, name: str) -> int:
        """How many are called so, with a number: NAME-1, NAME-2. Costs nothing once it was asked."""
        if self._families is None:
            self._families = Counter(map(_family, self.names))
        return self._families[name]

    def called(self, row: int) -> str:
        """What commands call a row: its id, or if it has none #1 for the first of the scene. No id begins so."""
        return self.names[row] or f"#{self.serials[row] + 1}"

    def row_of(self, serial: int) -> int | None:
        """The row of what has that serial number; None if it is gone."""
        row = bisect_left(self.serials, serial)
        return row if row < len(self.serials) and self.serials[row] == serial else None

    @property
    def ids(self) -> tuple[str, ...]:
        """The names, to be kept."""
        if self._ids is None:
            self._ids = tuple(self.names)
        return self._ids

    @property
    def register(self) -> Register[T]:
        """What it holds now, to be kept; the same object as long as nothing comes or goes."""
        if self._register is None:
            self._register = Register(tuple(self.items), tuple(self.serials), dict(self.words), self.next)
            vars(self._register)["names"] = self.ids  # instead of asking everybody again
        return self._register


def _runs(rows: Sequence[int]) -> list[tuple[int, int]]:
    """Where runs of neighbouring rows begin and end."""
    starts = [row for row, before in zip(rows, (-2, *rows), strict=False) if row != before + 1]
    ends = [row + 1 for row, after in zip(rows, (*rows[1:], -2), strict=True) if after != row + 1]
    return list(zip(starts, ends, strict=True))


def _family(name: str) -> str:
    """What comes before the number at the end of a name; an empty text if there is none."""
    head, _, number = name.rpartition("-")
    return head if number.isdigit() else ""


class Census:
    """Everybody in a world that began as `scene`."""

    __slots__ = ("_roster", "bodies", "joints", "regions", "scene")

    def __init__(self, roster: Roster) -> None:
        self.scene: FlatScene = roster.scene
        self.bodies: Ledger[FlatBody] = Ledger(roster.bodies)
        self.joints: Ledger[FlatJoint] = Ledger(roster.joints)
        self.regions: Ledger[FlatRegion] = Ledger(roster.regions)
        self._roster = roster

    def __iter__(self) -> Iterator[Ledger[Any]]:
        return iter((self.bodies, self.joints, self.regions))

    @property
    def roster(self) -> Roster:
        """Who is there now, to be kept; the same object as long as nobody comes or goes."""
        before = self._roster
        bodies, joints, regions = (ledger.register for ledger in self)
        if bodies is not before.bodies or joints is not before.joints or regions is not before.regions:
            self._roster = Roster(self.scene, bodies, joints, regions)
        return self._roster
