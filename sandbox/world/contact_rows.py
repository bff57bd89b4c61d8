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
    chosen = np.zeros(int(used["body_b"].max()) + 1, np.bool_)  # which is no less than body_a
    chosen[rows[rows < len(chosen)]] = True
    return np.flatnonzero(chosen[used["body_a"]] | chosen[used["body_b"]])
