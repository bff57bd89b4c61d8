"""Which shapes are tiles, and where their rows in the seam table are."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.tables import Integers


@dataclass
class Tiling:
    """The tiles of a state, `rows` of the shape table; `joined` are those that have rows in the seam table once there
    are two of them: all but parts of concave polygons. They come after the `own` rows that shapes came with."""

    rows: Integers
    joined: Integers
    own: int
