"""Stage: colour the constraint graph, so that contacts of one colour share no moving body."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import NOT_MOVED
from sandbox.engine.active.body_flags import is_active
from sandbox.engine.contact_solver.blocks import LANES, MAX_COLORS, VECTOR
from sandbox.tables import Integers, Records

FREE = tuple(next(k for k in range(9) if not (bits >> k) & 1) for bits in range(256))
"""For every set of the first eight colours the lowest that is not in it; 8 if all are."""


@kernel
def color_contacts(
    bodies: Records,
    movers: Integers,
    flights: Records,
    palettes: Integers,
    contacts: Records,
    live: Integers,
    pace: int,
    mixed: bool,
    colors: Integers,
) -> int:
    """Greedy colouring of the live contacts of a pace, in order, into `colors`; returns the number of colours.

    `mixed` says that there are other paces. `palettes` is scratch: the colours that each body's contacts have.
    Only active bodies count: others are read by the solver but not changed. A contact that finds no free colour gets
    `MAX_COLORS`, the colour of those that are solved one by one; one among sleeping bodies or of another pace
    gets -1 and is not solved.
    """
    for i in movers:
        palettes[i] = 0 if is_active(bodies[i]) else NOT_MOVED
    highest = -1
    for k in range(live.shape[0]):
        a = contacts[live[k]].body_a
        b = contacts[live[k]].body_b
        moves_a = palettes[a] != NOT_MOVED
        moves_b = palettes[b] != NOT_MOVED
        if not (moves_a or moves_b) or (mixed and flights[a if moves_a else b].pace != pace):
            colors[k] = -1
            continue
        color = _lowest_free((palettes[a] if moves_a else 0) | (palettes[b] if moves_b else 0))
        colors[k] = color
        highest = color if color > highest else highest
        if color < MAX_COLORS:
            if moves_a:
                palettes[a] |= 1 << color
            if moves_b:
                palettes[b] |= 1 << color
    return highest + 1


@inlined_kernel
def _lowest_free(taken: int) -> int:
    """Lowest colour that is not in a set. A table, as nobody can guess when a loop over its bits ends."""
    color = FREE[taken & 0xFF]
    if color == 8:
        while color < MAX_COLORS and (taken >> color) & 1:
            color += 1
    return color


@kernel
def fill_blocks(
    contacts: Records,
    live: Integers,
    colors: Integers,
    color_count: int,
    heads: Integers,
    slots: Records,
    blocks: Records,
) -> int:
    """Order contacts by colour into `slots` and cut every colour into blocks; return how many blocks that takes.

    If that is more than `blocks` can hold, none is written.
    """
    for c in range(color_count + 1):
        heads[c] = 0
    for k in range(live.shape[0]):
        if colors[k] >= 0:
            heads[colors[k]] += 1
    total = 0
    for c in range(color_count + 1):
        total += heads[c]
        heads[c] = total
    for k in range(live.shape[0] - 1, -1, -1):
        if colors[k] < 0:
            continue
        heads[colors[k]] -= 1
        slot = slots[heads[colors[k]]]
        slot.contact = live[k]
        slot.body_a = contacts[live[k]].body_a
        slot.body_b = contacts[live[k]].body_b
    needed = 0
    for c in range(color_count):
        most = LANES // VECTOR if c == MAX_COLORS else LANES
        needed += (heads[c + 1] - heads[c] + most - 1) // most
    if needed > blocks.shape[0]:
        return needed
    used = 0
    for c in range(color_count):
        first = heads[c]
        while first < heads[c + 1]:
            left = heads[c + 1] - first
            block = blocks[used]
            block.first = first
            block.stride = VECTOR if c == MAX_COLORS else 1
            most = LANES // block.stride
            block.count = left if left < most else most
            first += block.count
            used += 1
    return used
