"""Stage: contacts are ordered by colour and cut into blocks."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import IMMOVABLE
from sandbox.engine.contact_solver.blocks import LANES, MAX_COLORS, VECTOR
from sandbox.engine.contact_solver.graph_coloring import SETTLED, lowest_free
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records

_ENOUGH = VECTOR // 4
"""Contacts of a colour, in the mean, that are solved sooner side by side than one by one."""


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
    """Give further colours to contacts that found none, as many at a time as there were: such as where hundreds of
    bodies lie in one place.

    Returns the new number of blocks, and the first slot that is left: contacts that share a body with nearly all
    others, or for which there are no blocks.
    """
    slots = blocks.slots
    heads = blocks.further
    while end - first >= _ENOUGH:
        for k in range(first, end):
            a = slots[k].body_a
            b = slots[k].body_b
            taken[a] = taken[a] if taken[a] == IMMOVABLE else 0
            taken[b] = taken[b] if taken[b] == IMMOVABLE else 0
        for c in range(MAX_COLORS + 1):
            heads[c] = 0
        for k in range(first, end):
            a = slots[k].body_a
            b = slots[k].body_b
            both = (0 if taken[a] == IMMOVABLE else taken[a]) | (0 if taken[b] == IMMOVABLE else taken[b])
            color = lowest_free(both)
            blocks.impacts[k].contact = color
            heads[color] += 1
            if color < MAX_COLORS:
                taken[a] = taken[a] if taken[a] == IMMOVABLE else taken[a] | 1 << color
                taken[b] = taken[b] if taken[b] == IMMOVABLE else taken[b] | 1 << color
        if not _are_enough(blocks, used, end):
            break
        _move_to_colors(blocks, first, end)
        for c in range(MAX_COLORS):
            length = heads[c]
            used = _cut(blocks, used, first, first + length, False)
            first += length
    return used, first


@kernel
def _are_enough(blocks: ContactBlocks, used: int, end: int) -> bool:
    """Whether contacts with further colours are worth their blocks, and whether there are so many: those without one,
    and what lies in slots from `end` on, are to have theirs as well."""
    colors = 0
    count = 0
    needed = used + (blocks.further[MAX_COLORS] + LANES - 1) // LANES
    for c in range(MAX_COLORS):
        colors += 1 if blocks.further[c] > 0 else 0
        count += blocks.further[c]
        needed += (blocks.further[c] + LANES - 1) // LANES
    for c in range(2 * SETTLED):
        if blocks.heads[c] >= end:
            needed += (blocks.heads[c + 1] - blocks.heads[c] + LANES - 1) // LANES
    return count > 0 and count >= _ENOUGH * colors and needed <= blocks.blocks.shape[0]


@kernel
def _move_to_colors(blocks: ContactBlocks, first: int, end: int) -> None:
    """Order slots by the further colour in `impacts` (free as yet), `further` of each, and last those without one."""
    slots = blocks.slots
    spare = blocks.impacts
    heads = blocks.further[MAX_COLORS + 1 :]
    place = first
    for c in range(MAX_COLORS + 1):
        heads[c] = place
        place += blocks.further[c]
    for k in range(first, end):
        color = spare[k].contact
        spare[k].contact = heads[color]
        heads[color] += 1
    for k in range(first, end):
        while spare[k].contact != k:
            other = spare[k].contact
            _swap(slots[k], slots[other])
            spare[k].contact = spare[other].contact
            spare[other].contact = other


@inlined_kernel
def _swap(one: Records, other: Records) -> None:
    contact = one.contact
    a = one.body_a
    b = one.body_b
    one.contact = other.contact
    one.body_a = other.body_a
    one.body_b = other.body_b
    other.contact = contact
    other.body_a = a
    other.body_b = b
