"""Colours beyond the first `MAX_COLORS`, for contacts that found none of these: such as where hundreds of bodies lie in
one place.

They are given greedily in the order of contacts, as the first ones are, and looked up in several words of 62 colours a
body at once: to go through the contacts once for each word would cost the square of their number where all lie in one
place.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import IMMOVABLE
from sandbox.engine.contact_solver.blocks import ALL_COLORS, ENOUGH, LANES, MAX_COLORS
from sandbox.engine.contact_solver.graph_coloring import lowest_free
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.tables import Integers, Records

MOST_WORDS = 32
"""Of colours that are given at a time."""
_ALL = (1 << MAX_COLORS) - 1
_UNMET = -2


@kernel
def color_further(taken: Integers, blocks: ContactBlocks, used: int, first: int, end: int) -> int:
    """Give the contacts in the slots first..end-1 further colours, behind `used` blocks, and order them by these.

    Returns the number of colours given, up to `MAX_COLORS * MOST_WORDS` at a time; `blocks.further` has how many
    contacts each got, and the others come last, in their order. 0 if colours are not worth it, or there is no room for
    them. `taken` is `solver.colors`, which is scratch here.
    """
    if end - first < ENOUGH:
        return 0
    words = _number_bodies(taken, blocks, first, end)
    if words == 0:
        return 0
    _color(taken, blocks, first, end, words)
    colors = MAX_COLORS * _words_worth_it(blocks, used, first, end, words)
    if colors > 0:
        _move_to_colors(blocks, first, end, colors)
    return colors


@kernel
def _number_bodies(taken: Integers, blocks: ContactBlocks, first: int, end: int) -> int:
    """Number the bodies that contacts move, in `taken`, and empty their sets of colours; returns the words of each."""
    slots = blocks.slots
    for k in range(first, end):
        a = slots[k].body_a
        b = slots[k].body_b
        taken[a] = taken[a] if taken[a] == IMMOVABLE else _UNMET
        taken[b] = taken[b] if taken[b] == IMMOVABLE else _UNMET
    bodies = 0
    for k in range(first, end):
        a = slots[k].body_a
        b = slots[k].body_b
        if taken[a] == _UNMET:
            taken[a] = bodies
            bodies += 1
        if taken[b] == _UNMET:
            taken[b] = bodies
            bodies += 1
    words = blocks.sets.shape[0] // bodies
    words = words if words < MOST_WORDS else MOST_WORDS
    for k in range(bodies * words):
        blocks.sets[k] = 0
    return words


@kernel
def _color(taken: Integers, blocks: ContactBlocks, first: int, end: int, words: int) -> None:
    """Note in `spare` the lowest colour that neither body of each contact has, and count them."""
    slots = blocks.slots
    sets = blocks.sets
    heads = blocks.further
    for c in range(words * MAX_COLORS + 1):
        heads[c] = 0
    for k in range(first, end):
        a = taken[slots[k].body_a]
        b = taken[slots[k].body_b]
        word = 0
        both = _either(sets, a, b, words, 0)
        while both == _ALL and word < words - 1:
            word += 1
            both = _either(sets, a, b, words, word)
        color = lowest_free(both)
        if color < MAX_COLORS:
            if a != IMMOVABLE:
                sets[a * words + word] |= 1 << color
            if b != IMMOVABLE:
                sets[b * words + word] |= 1 << color
        color += word * MAX_COLORS
        blocks.spare[k].contact = color
        heads[color] += 1


@inlined_kernel
def _either(sets: Integers, a: int, b: int, words: int, word: int) -> int:
    """What one of two bodies has of a word of colours."""
    of_a = sets[a * words + word] if a != IMMOVABLE else 0
    of_b = sets[b * words + word] if b != IMMOVABLE else 0
    return of_a | of_b


@kernel
def _words_worth_it(blocks: ContactBlocks, used: int, first: int, end: int, words: int) -> int:
    """How many words of colours are given: all, up to the first that is not worth its blocks."""
    left = end - first
    for word in range(words):
        count = 0
        colors = 0
        full = used
        for c in range(word * MAX_COLORS, (word + 1) * MAX_COLORS):
            length = blocks.further[c]
            count += length
            colors += 1 if length > 0 else 0
            full += (length + LANES - 1) // LANES
        worth_it = left >= ENOUGH and count > 0 and count >= ENOUGH * colors
        if not worth_it or not _there_are_blocks(blocks, full, left - count, end):
            return word
        used = full
        left -= count
    return words


@kernel
def _there_are_blocks(blocks: ContactBlocks, used: int, left: int, end: int) -> bool:
    """Whether there are blocks for those that are `left` without a colour as well, and for the slots from `end` on."""
    needed = used + (left + LANES - 1) // LANES
    for c in range(ALL_COLORS):
        if blocks.heads[c] >= end:
            needed += (blocks.heads[c + 1] - blocks.heads[c] + LANES - 1) // LANES
    enough: bool = needed <= blocks.blocks.shape[0]
    return enough


@kernel
def _move_to_colors(blocks: ContactBlocks, first: int, end: int, colors: int) -> None:
    """Order slots by their colour in `spare`, if it is one of so many, `further` of each; the others come last."""
    slots = blocks.slots
    spare = blocks.spare
    heads = blocks.further_heads
    place = first
    for c in range(colors):
        heads[c] = place
        place += blocks.further[c]
    heads[colors] = place
    for k in range(first, end):
        color = spare[k].contact if spare[k].contact < colors else colors
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
