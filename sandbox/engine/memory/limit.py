"""How much memory the pairs and contacts of one step may take.

Bodies in one place make as many pairs as the square of their number: asked for all at once, that would end the process.
"""

from __future__ import annotations

from sandbox.engine.contact_solver.blocks import ALL_COLORS, BLOCK_SIZE, LANES
from sandbox.engine.records.batches import IMPACT, IMPACT_SLOT, SIZE
from sandbox.engine.records.colliders import PAIR
from sandbox.engine.records.contact_blocks import BLOCK
from sandbox.engine.records.contacts import KEPT, KEPT_LINK, REPORT, SLEEPING_RUN, SLOT
from sandbox.errors import CapacityError
from sandbox.world.records import CONTACT

MAX_STEP_BYTES = 4 * 1024**3
"""Memory of all tables that grow with pairs and contacts, in bytes: about 4 million pairs."""
_LEAST = 256
"""A world that has outgrown its first memory for pairs takes room for so many: a few at a time is as often anew."""
_WORD = 8
FAT_PAIRS = 2
"""Pairs of fat boxes for which there is memory, for each pair of boxes."""
_PAIR_BYTES = 3 * _WORD + 2 * FAT_PAIRS * PAIR.dtype.itemsize + sum(
    table.dtype.itemsize
    for table in (
        CONTACT, CONTACT, PAIR, SLEEPING_RUN, SLEEPING_RUN, SLEEPING_RUN, KEPT, KEPT, KEPT_LINK, KEPT_LINK,
        REPORT, SLOT, SLOT, SLOT, IMPACT, IMPACT_SLOT,
    )
)  # fmt: skip
_BLOCK_BYTES = BLOCK.dtype.itemsize + _WORD * BLOCK_SIZE


def most_blocks(pairs: int) -> int:
    """Most solver blocks that so many contacts fill: every colour has one that is not full, settled or not."""
    return pairs // LANES + ALL_COLORS


def most_batches(pairs: int) -> int:
    """Most batches that islands with so many contacts are put into; what is left is solved with the first."""
    return pairs // SIZE + 1


def step_bytes(pairs: int) -> int:
    """Memory for so many pairs."""
    return pairs * _PAIR_BYTES + most_blocks(pairs) * _BLOCK_BYTES


def room_for(pairs: int) -> int:
    """For how many pairs memory is to be taken: half as many more than are needed, if there is room for that, and not
    just a few.

    Raises `CapacityError` if there is none for those that are needed.
    """
    size = step_bytes(pairs)
    if size > MAX_STEP_BYTES:
        raise CapacityError(
            f"a step with {pairs:,} pairs of shapes that may touch needs {size / 1e9:.1f} GB of tables; the limit is "
            f"{MAX_STEP_BYTES / 1e9:.1f} GB. Too many bodies are in one place: spread them, or give them categories "
            "that do not collide. The world is as before the step"
        )
    roomy = max(_LEAST, pairs + pairs // 2)
    return roomy if step_bytes(roomy) <= MAX_STEP_BYTES else pairs
