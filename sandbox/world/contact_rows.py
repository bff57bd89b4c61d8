"""The contacts of some bodies, found without a look at all others where the engine knows better."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from sandbox.tables import Integers, Records, plain


class Resting(Protocol):
    """What is known of sleepers and their contacts since the last step."""

    def contacts_of(self, table: Records, count: int, rows: Integers) -> Integers | None:
        """The rows of those of so many contacts that some bodies have, ascending; None where a look at all is as soon
        done."""

    def members(self, bodies: Records, islands: Integers) -> Integers | None:
        """The rows of the bodies of some islands; None where that is not known."""


def contacts_of(contacts: Records, count: int, rows: Integers, resting: Resting | None) -> Integers:
    """The rows of those of so many contacts that some bodies have, ascending."""
    if not len(rows) or count == 0:
        return np.zeros(0, np.int64)
    known = resting.contacts_of(contacts, count, rows) if resting is not None else None
    if known is not None:
        return known
    used: Any = plain(contacts)[:count]
    first, last = int(rows.min()), int(rows.max())
    near = np.flatnonzero(used["body_b"] >= first)  # which is no less than body_a
    highest = used["body_b"][near]
    if last - first + 1 == len(rows) and highest.max(initial=first) <= last:  # all from the first one on
        return near
    chosen = np.zeros(max(last, int(highest.max(initial=first))) + 1, np.bool_)
    chosen[rows] = True
    some: Integers = near[chosen[used["body_a"][near]] | chosen[highest]]
    return some
