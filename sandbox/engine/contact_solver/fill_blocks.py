"""Stage: contacts are ordered by batch and colour, and cut into blocks."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.island_batches import batch_of
from sandbox.engine.contact_solver.blocks import (
    ALL_COLORS,
    DEEP,
    KIND,
    LANES,
    MAX_COLORS,
    SETTLED,
    STRUCK_AND_DEEP,
    UNSETTLED,
)
from sandbox.engine.contact_solver.further_colors import color_further
from sandbox.engine.records.contact_blocks import BlockRanges, ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records


@kernel
def fill_blocks(taken: Integers, blocks: ContactBlocks, batch: int) -> BlockRanges:
    """Cut every colour of a batch into blocks, after `sort_contacts`; `blocks.starts` tells where each begins.

    `taken` is `solver.colors`, as `color_contacts` has left it. Only batch 0 may have contacts that found no colour.
    """
    heads = blocks.heads[ALL_COLORS * batch :]
    used = struck = deep_first = deep_end = unsettled = 0
    blocks.starts[0] = 0
    if heads[0] == heads[ALL_COLORS]:  # no contacts, as where bodies fly or only joints hold them
        return BlockRanges(0, 0, 0, 0, 0)
    for kind in range(0, ALL_COLORS, KIND):
        for c in range(kind, kind + MAX_COLORS):
            if heads[c] < heads[c + 1]:  # few colours have contacts
                used = _cut(blocks, used, heads[c], heads[c + 1], False)
        first = heads[kind + MAX_COLORS]
        end = heads[kind + KIND]
        if first < end:
            used, first = _color_what_is_left(taken, blocks, used, first, end)
            used = _cut(blocks, used, first, end, True)
        deep_first = used if kind < STRUCK_AND_DEEP else deep_first
        struck = used if kind < DEEP else struck
        deep_end = used if kind < UNSETTLED else deep_end
        unsettled = used if kind < SETTLED else unsettled
    return BlockRanges(used, unsettled, struck, deep_first, deep_end)


@kernel
def sort_contacts(contacts: Contacts, of_body: Integers, blocks: ContactBlocks, batch_count: int) -> None:
    """Order the active contacts into slots, by batch (`of_body` of their bodies) and then by colour: a counting sort.

    Afterwards `heads` has the first slot of each colour of each batch, and behind them how many there are.
    """
    listed = contacts.active[1 : 1 + contacts.active[0].contact]
    colors = blocks.colors
    heads = blocks.heads
    for c in range(ALL_COLORS * batch_count + 1):
        heads[c] = 0
    if listed.shape[0] == 0:
        return
    for k in range(listed.shape[0]):
        if colors[k] >= 0:
            heads[_key(listed[k], of_body, colors[k], batch_count)] += 1
    total = 0
    for c in range(ALL_COLORS * batch_count + 1):
        total += heads[c]
        heads[c] = total
    for k in range(listed.shape[0] - 1, -1, -1):
        if colors[k] < 0:
            continue
        key = _key(listed[k], of_body, colors[k], batch_count)
        heads[key] -= 1
        blocks.slots[heads[key]] = listed[k]


@inlined_kernel
def _key(slot: Records, of_body: Integers, color: int, batch_count: int) -> int:
    return color if batch_count == 1 else ALL_COLORS * batch_of(slot, of_body) + color


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
