"""What the separating-axis test has found of a batch of pairs, before their contacts are written."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.geometry.manifold import MANIFOLD
from sandbox.tables import Field, Records, Table

DEEP = 4
"""Bit of a decision, beside `NEW` and `OVERLAPS`: the pair overlaps more than a little, and one body is immovable."""
MAY_IMPACT = 8
"""Bit of a decision: the contact is listed among those that may have an impact."""

DECISION = Table(
    "decision",
    (
        Field("row", "-", "of its contact; -1 when the pair has none", "i8"),
        Field("old", "-", "row of the contact it had in the step before; -1 if none", "i8"),
        Field("bits", "-", "what is to be noted of its bodies, and whether it may have an impact", "i8"),
        Field("shift_x", "m", "way of b against a until the moment of the manifold"),
        Field("shift_y", "m", "way of b against a until the moment of the manifold"),
    ),
)
"""One row a pair of a batch."""

_BATCH = 64
"""Pairs that one thread decides before it writes their contacts: what is known of them stays in the cache."""
_BATCH_SHARED = 4096
"""The same for several threads, who wait for each other after every batch."""


class Decisions(NamedTuple):
    """`made` and `manifolds` have a row for each pair of a batch; `scratch` has two manifolds for each worker."""

    made: Records
    manifolds: Records
    scratch: Records


def decisions_memory(workers: int) -> Decisions:
    """Memory for batches that so many workers share."""
    batch = _BATCH if workers == 1 else _BATCH_SHARED
    return Decisions(DECISION.zeros(batch), MANIFOLD.zeros(batch), MANIFOLD.zeros(2 * workers))
