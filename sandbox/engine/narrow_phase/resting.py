"""What commands ask of sleepers: whose contacts are where, and who sleeps together, without a look at all others.

Contacts among sleepers are in the lists of their bodies (`sleeping_contacts.py`), all others are those that the last
step has listed as active.
"""

from __future__ import annotations

from bisect import bisect_left
from typing import Any

import numpy as np

from sandbox.engine.active.sleeping_islands import NOBODY
from sandbox.engine.narrow_phase.sleeping_contacts import NOTHING
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records, plain

_FEW = 32
"""So many entries of lists are looked at one by one,"""
_SHARE = 1024
"""and another one for so many contacts: then a look at all of them is as soon done."""


class AtRest:
    """As much of the scratch memory of a world as holds from one step to the next."""

    __slots__ = ("_contacts", "active")

    def __init__(self, active: ActiveSet, contacts: Contacts) -> None:
        self.active, self._contacts = active, contacts

    def contacts_of(self, table: Records, count: int, rows: Integers) -> Integers | None:
        """The rows of those of so many contacts that some bodies have, ascending; None where a look at all is as soon
        done."""
        if not self._has_runs():
            return None
        kept = self._kept_of(plain(table)[:count], rows)
        if kept is None:
            return None
        active: Any = plain(self._contacts.active)
        active = active[1 : 1 + int(active["contact"][0])]
        bodies = len(self._contacts.first_kept)
        near = _among(active["body_a"], rows, bodies) | _among(active["body_b"], rows, bodies)
        return np.union1d(kept, active["contact"][near]).astype(np.int64)

    def members(self, bodies: Records, islands: Integers) -> Integers | None:
        """The rows of the bodies of some islands; None where that is not known."""
        info = plain(self.active.info)[0]
        if info["stale"]:
            return None
        island, listed = plain(bodies)["island"], int(info["bodies"])
        found = (
            listed + np.flatnonzero(_among(island[listed:], islands, len(island) + 1))
        ).tolist()  # who has come, or has another row
        for root in islands.tolist():
            if root > listed:
                continue
            row = int(self.active.last_member[root - 1])
            while row != NOBODY:
                if row < listed and island[row] == root:
                    found.append(row)
                row = int(self.active.member_before[row])
        return np.array(sorted(found), np.int64)

    def _has_runs(self) -> bool:
        """Whether the lists tell of the contacts that the last step has found."""
        info, cursor = plain(self.active.info)[0], plain(self._contacts.cursor)[0]
        last = cursor["era1"] if cursor["turn"] == 0 else cursor["era0"]
        return bool(info["stale"] == 0 and last == info["era"])

    def _kept_of(self, table: Any, rows: Integers) -> list[int] | None:
        """Those of them that are in the lists. A list may name a contact twice, or one that is no more: rows may have
        gone since."""
        kept, links, first = plain(self._contacts.kept), plain(self._contacts.links), self._contacts.first_kept
        left = _FEW + len(table) // _SHARE
        found = []
        for row in rows.tolist():
            left -= 1
            number = int(first[row])
            while number != NOTHING:
                left -= 1
                if left < 0:
                    return None
                link = links[number].item()
                place = bisect_left(table, link[2:], key=_shapes)
                if place < len(table) and _is_of(table[place], row, link[2:]):
                    found.append(place)
                number = link[0] if kept[number]["body_a"] == row else link[1]
            if left < 0:
                return None
        return found


def _shapes(contact: Any) -> tuple[int, int]:
    return contact["shape_a"], contact["shape_b"]


def _is_of(contact: Any, body: int, shapes: tuple[int, int]) -> bool:
    return _shapes(contact) == shapes and body in (contact["body_a"], contact["body_b"])


def _among(column: Integers, rows: Integers, count: int) -> Any:
    """Which of a column are some rows, all of them below a count. `np.isin` sorts, or looks for the least and most."""
    if len(rows) == 1:
        return column == rows[0]
    chosen = np.zeros(count, np.bool_)
    chosen[rows] = True
    return chosen[column]
