"""How many static tiles may lie over each other: all pairs of them are looked at, and in one place all are pairs."""

from __future__ import annotations

from sandbox.errors import CapacityError
from sandbox.world.tile_outlines import Outlines
from sandbox.world.tile_pairs import pairs_at_most

MAX_PAIRS = 1_000_000
"""Pairs of tiles whose boxes are near each other, some microseconds each: a thousand tiles in one place."""
_PER_TILE = 50
"""Further pairs for each tile: what large levels have, each in its own place."""


def check_crowds(*outlines: Outlines) -> None:
    """Raises `CapacityError` if too many of these tiles, which are at hand in parts, lie over each other."""
    count = sum(len(part.shapes) for part in outlines)
    most = MAX_PAIRS + _PER_TILE * count
    if count * count > most and pairs_at_most(outlines) > most:
        raise CapacityError(
            f"more than {most:,} pairs of {count:,} static shapes lie over each other or side by side: too many to "
            "find out which of their edges show. Spread them, or leave out those that lie within others"
        )
