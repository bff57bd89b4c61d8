"""Contacts come into the same blocks as in the slow twin, however many share a body."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.bodies.flags import IMMOVABLE
from sandbox.engine.contact_solver.blocks import (
    ALL_COLORS,
    DEEP,
    KIND,
    LANES,
    MAX_COLORS,
    SETTLED,
    STRUCK_ALONE,
    STRUCK_AND_DEEP,
    UNSETTLED,
)
from sandbox.engine.contact_solver.further_colors import MOST_WORDS
from sandbox.engine.contact_solver.graph_coloring import FREE, IS_UNSETTLED, lowest_free
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.ccd import NEW, OVERLAPS, STRUCK
from sandbox.engine.records.contact_blocks import BLOCK, BlockRanges
from sandbox.world.build import build_state
from tests.engine.stages import fill_blocks, sort_contacts, stage
from tests.examples import examples
from tests.flat import scene
from tests.naive import contact_blocks as naive

EMPTY = build_state(scene())
free_color = stage(lowest_free)


def laid(pairs: list[naive.Pair], colors: list[int], movable: list[bool], room: int) -> list[naive.Block]:
    """The blocks that the engine makes, when there are so many; the ranges of their kinds are right."""
    memory = Scratch.for_state(EMPTY, LANES * room + len(pairs))
    contacts, blocks = memory.contacts, memory.blocks._replace(blocks=BLOCK.zeros(room))
    contacts.active[0].contact = len(pairs)
    for k, (a, b) in enumerate(pairs):
        contacts.active[1 + k] = k, a, b
    blocks.colors[: len(pairs)] = colors
    blocks.sets[:] = blocks.further[:] = blocks.further_heads[:] = 12345
    taken = np.where(movable, 7, IMMOVABLE)
    sort_contacts(contacts, memory.solver.batches, blocks, 1)
    ranges = BlockRanges(*fill_blocks(taken, blocks, 0))
    found = []
    for block in blocks.blocks[: ranges.total]:
        slots = blocks.slots[block.first : block.first + block.count]
        assert [(s.body_a, s.body_b) for s in slots] == [pairs[s.contact] for s in slots]
        found.append(naive.Block(bool(block.serial), tuple(int(s.contact) for s in slots)))
    kinds = [colors[block.contacts[0]] // KIND * KIND for block in found]
    assert kinds == sorted(kinds)
    assert ranges.unsettled == sum(kind < SETTLED for kind in kinds)
    assert ranges.struck == sum(kind in (STRUCK_ALONE, STRUCK_AND_DEEP) for kind in kinds)
    deep = [n for n, kind in enumerate(kinds) if kind in (STRUCK_AND_DEEP, DEEP)]
    assert list(range(ranges.deep_first, ranges.deep_end)) == deep
    return found


def colored(pairs: list[naive.Pair], movable: list[bool], unsettled: dict[int, int]) -> list[int]:
    """The first colours, as `color_contacts` gives them; `unsettled` has the bits of bodies that are."""
    found = naive.lowest_colors(pairs, range(len(pairs)), movable)
    return [
        -1
        if not (movable[a] or movable[b])
        else found[k] + kind_of(unsettled.get(a, 0) | unsettled.get(b, 0), bool({a, b} & set(unsettled)))
        for k, (a, b) in enumerate(pairs)
    ]


def kind_of(bits: int, unsettled: bool) -> int:
    """The first colour of contacts of bodies with these bits."""
    struck, deep = bool(bits & STRUCK), bool(bits & OVERLAPS)
    if not unsettled:
        return SETTLED
    alone, both = (STRUCK_ALONE, STRUCK_AND_DEEP) if struck else (UNSETTLED, DEEP)
    return both if deep else alone


@st.composite
def crowds(draw: Any) -> tuple[list[naive.Pair], list[bool], dict[int, int]]:
    """Many contacts of few bodies: some with all others, some of which cannot move."""
    bodies = draw(st.integers(2, 40))
    random = np.random.default_rng(draw(st.integers(0, 10**6)))
    count = draw(st.integers(1, 1500))
    hubs = draw(st.integers(1, bodies))
    first = random.integers(0, hubs, count)
    second = (first + random.integers(1, bodies, count)) % bodies
    pairs = [(int(min(pair)), int(max(pair))) for pair in zip(first, second, strict=True)]
    pairs = sorted(pairs) if draw(st.booleans()) else pairs
    movable = (random.random(bodies) > draw(st.sampled_from([0.0, 0.3]))).tolist()
    unsettled = np.flatnonzero(random.random(bodies) < draw(st.sampled_from([0.0, 0.1, 1.0]))).tolist()
    return pairs, movable, {body: int(random.integers(1, (NEW | OVERLAPS | STRUCK) + 1)) for body in unsettled}


@given(crowds(), st.integers(0, 30))
@examples(60)
def test_blocks_are_those_of_the_slow_twin(crowd, spare):
    pairs, movable, unsettled = crowd
    colors = colored(pairs, movable, unsettled)
    room = sum(naive.blocks_of(colors.count(c)) for c in range(ALL_COLORS)) + spare
    assert laid(pairs, colors, movable, room) == naive.fill_blocks(pairs, colors, movable, room)


def test_as_many_colours_as_are_asked_for_at_a_time_and_more():
    """All pairs of bodies, each twice over: some need more colours than there are words for."""
    bodies = 20
    times = 110
    pairs = [pair for pair in combinations(range(bodies), 2) for _ in range(times)]
    movable = [True] * bodies
    colors = colored(pairs, movable, {})
    found = laid(pairs, colors, movable, 10_000)
    assert found == naive.fill_blocks(pairs, colors, movable, 10_000)
    assert (bodies - 1) * times > MOST_WORDS * MAX_COLORS  # a colour each, as they share a body
    assert sum(len(block.contacts) for block in found if block.serial) < 20


def test_a_hub_leaves_its_contacts_to_be_solved_one_by_one():
    pairs = [(0, k) for k in range(1, 301)]
    movable = [True] * 301
    colors = colored(pairs, movable, {})
    found = laid(pairs, colors, movable, 1000)
    assert found == naive.fill_blocks(pairs, colors, movable, 1000)
    assert sum(len(block.contacts) for block in found if block.serial) == 300 - MAX_COLORS


@pytest.mark.parametrize("flags", [0, IS_UNSETTLED])
def test_the_lowest_free_colour(flags):
    random = np.random.default_rng(3)
    sets = [(1 << k) - 1 for k in range(MAX_COLORS + 1)]
    sets += [int(random.integers(0, 1 << MAX_COLORS)) | (1 << int(k)) - 1 for k in random.integers(0, 62, 500)]
    for taken in sets:
        wanted = next(c for c in range(MAX_COLORS + 1) if c == MAX_COLORS or not (taken >> c) & 1)
        assert free_color(taken | flags) == wanted
    assert len(FREE) == 256
