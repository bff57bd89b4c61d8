"""Stage: contacts are ordered by colour and cut into blocks."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.blocks import LANES, MAX_COLORS
from sandbox.engine.contact_solver.further_colors import color_further
from sandbox.engine.contact_solver.graph_coloring import SETTLED
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers


@kernel
def fill_blocks(contacts: Contacts, taken: Integers, blocks: ContactBlocks) -> tuple[int, int]:
    """Order contacts by colour into slots and cut every colour into blocks; `blocks.starts` tells where each begins.

    Returns how many blocks that takes, and how many of them, the first ones, are of unsettled bodies. `taken` is
    `solver.colors`, as `color_contacts` has left it.
    """
    rows = contacts.active[1 : 1 + contacts.active[0]]
    heads = blocks.heads
    _sort_by_color(contacts, rows, blocks)
    used = unsettled = 0
    blocks.starts[0] = 0
    for c in range(2 * SETTLED):
        first = heads[c]
        end = heads[c + 1]
        serial = c % SETTLED == MAX_COLORS
        if serial:
            used, first = _color_what_is_left(taken, blocks, used, first, end)
        used = _cut(blocks, used, first, end, serial)
        unsettled = used if c < SETTLED else unsettled
    return used, unsettled


@kernel
def _sort_by_color(contacts: Contacts, rows: Integers, blocks: ContactBlocks) -> None:
    """A counting sort: afterwards `heads` has the first slot of each colour, and behind them how many there are."""
    heads = blocks.heads
    for c in range(2 * SETTLED + 1):
        heads[c] = 0
    for k in range(rows.shape[0]):
        if blocks.colors[k] >= 0:
            heads[blocks.colors[k]] += 1
    total = 0
    for c in range(2 * SETTLED + 1):
        total += heads[c]
        heads[c] = total
    for k in range(rows.shape[0] - 1, -1, -1):
        if blocks.colors[k] < 0:
            continue
        heads[blocks.colors[k]] -= 1
        slot = blocks.slots[heads[blocks.colors[k]]]
        slot.contact = rows[k]
        slot.body_a = contacts.now[rows[k]].body_a
        slot.body_b = contacts.now[rows[k]].body_b


@kernel
def _cut(blocks: ContactBlocks, used: int, first: int, end: int, serial: bool) -> int:
    """Cut the slots first..end-1, of one colour, into blocks behind the `used` first ones; returns the new number."""
    if first >= end:
        return used
    starts = blocks.starts
    starts[0] += 1
    starts[starts[0]] = used
    while first < end:
        block = blocks.blocks[used]
        block.first = first
        block.serial = 1 if serial else 0
        block.count = end - first if end - first < LANES else LANES
        first += LANES
        used += 1
    starts[starts[0] + 1] = used
    return used


@kernel
def _color_what_is_left(taken: Integers, blocks: ContactBlocks, used: int, first: int, end: int) -> tuple[int, int]:
    """Give further colours to contacts that found none, as many at a time as there is room for.

    Returns the new number of blocks, and the first slot that is left: contacts that share a body with nearly all
    others, or for which there are no blocks.
    """
    colors = color_further(taken, blocks, used, first, end)
    while colors > 0:
        for c in range(colors):
            length = blocks.further[c]
            used = _cut(blocks, used, first, first + length, False)
            first += length
        colors = color_further(taken, blocks, used, first, end)
    return used, first
