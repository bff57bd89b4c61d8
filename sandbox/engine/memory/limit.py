"""How much memory the pairs and contacts of one step may take.

Bodies in one place make as many pairs as the square of their number: asked for all at once, that would end the process.
"""

from __future__ import annotations

from sandbox.engine.contact_solver.blocks import BLOCK_SIZE, LANES, MAX_COLORS
from sandbox.engine.records.colliders import PAIR
from sandbox.engine.records.contact_blocks import BLOCK, SLOT
from sandbox.engine.records.contacts import REPORT, SLEEPING_RUN
from sandbox.errors import CapacityError
from sandbox.world.records import CONTACT

MAX_STEP_BYTES = 4 * 1024**3
"""Memory of all tables that grow with pairs and contacts, in bytes: about 4 million pairs, or 900,000 contacts of
bodies that touch too many others to be solved side by side."""
_WORD = 8
_PAIR_BYTES = 3 * _WORD + sum(
    table.dtype.itemsize
    for table in (CONTACT, CONTACT, PAIR, PAIR, SLEEPING_RUN, SLEEPING_RUN, SLEEPING_RUN, REPORT, SLOT)
)
_BLOCK_BYTES = BLOCK.dtype.itemsize + _WORD * BLOCK_SIZE


def least_blocks(pairs: int) -> int:
    """Solver blocks for so many contacts if bodies have few each."""
    return pairs // LANES + MAX_COLORS + 2


def step_bytes(pairs: int, blocks: int) -> int:
    """Memory for so many pairs and solver blocks."""
    return pairs * _PAIR_BYTES + max(blocks, least_blocks(pairs)) * _BLOCK_BYTES


def room_for(needed: tuple[int, int], spare: tuple[int, int], found: int) -> tuple[int, int]:
    """For how many pairs and blocks memory is to be taken: `spare`, or what is needed if that would be too much.

    Raises `CapacityError` if what is needed is, for the pairs that were `found`.
    """
    size = step_bytes(*needed)
    if size > MAX_STEP_BYTES:
        raise CapacityError(
            f"a step with {found:,} pairs of shapes that may touch needs {size / 1e9:.1f} GB of tables; the limit is "
            f"{MAX_STEP_BYTES / 1e9:.1f} GB. Too many bodies are in one place: spread them, or give them categories "
            "that do not collide. The world is as before the step"
        )
    return spare if step_bytes(*spare) <= MAX_STEP_BYTES else needed
