"""A task that several threads divide: a range of numbers, of which each takes the next few until none is left.

Who comes late finds less to do, or nothing: the thread that steps the world never waits for one that has not begun.
What a task is told (`Workers.words`, `numbers`) is read after a part of its range has been taken, and the next task is
only posted when all parts are done, so that nobody reads what is being changed. A thread by itself takes all at once.

Half of the workers take from the front, the others from the back: of what lies in the same order in every task, as
bodies and their contacts do, each gets what is in its own cache since the task before.
"""

from __future__ import annotations

from typing import Any

from sandbox._atomics import atomic_add, atomic_load, atomic_store, compare_and_swap, yield_processor
from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.workers import NUMBERS, SIZE, Workers
from sandbox.engine.workers.task_kinds import END, FIRST
from sandbox.tables import Integers

CLOSED = 1
"""Word: 1 when the step is over, and nobody is to look for tasks any more."""
TASK = 16
"""Word: what is to be done."""
GRAIN = 17
"""Word: how many numbers are taken at once."""
COUNT = 18
"""Word: how many numbers there are."""
FIRST_PAIR = 19
"""Word: the first pair of the batch that a task is about."""
RANGE = 32
"""Word: the next number to take, and in its lower half the end of the range."""
DONE = 48
"""Word: how many numbers are done."""
_HALF = 32
_LOWER = (1 << _HALF) - 1
_PATIENCE = 1000
"""So many looks take some microseconds."""
_FEW = 96
"""Fewer blocks of a colour than this one worker does by itself: the others would fetch them from its cache."""
_SHARES = 4
"""Parts for each worker: enough to even out that some take longer than others."""


@inlined_kernel
def first_part(workers: Workers, task: int, first: int, end: int) -> tuple[int, int]:
    """Offer first..end-1 to all workers; returns the part that this one is to do. (0, 0) if others do it all."""
    size = workers.words[SIZE]
    if size == 1:
        return first, end
    return _offer(workers.words, task, first, end, (end - first) // (_SHARES * size))


@inlined_kernel
def next_part(workers: Workers, first: int, end: int) -> tuple[int, int]:
    """After the part first..end-1: the next one to do; (0, 0) when all is done, also what others have taken. Of a range
    that was not offered nothing is left: the range of the last offer is taken."""
    if workers.words[SIZE] == 1:
        return 0, 0
    note_done(workers.words, end - first)
    return _take_or_wait(workers.words)


@inlined_kernel
def color_count(workers: Workers, blocks: ContactBlocks) -> int:
    """Into how many ranges blocks fall that are done one after the other: colours, or one if nobody shares them."""
    return 1 if workers.words[SIZE] == 1 else blocks.starts[0]


@inlined_kernel
def first_part_of_color(
    workers: Workers, task: int, blocks: ContactBlocks, color: int, span: tuple[int, int]
) -> tuple[int, int]:
    """As `first_part`, for those blocks span[0]..span[1]-1 that are of a colour. Serial blocks are not offered."""
    size = workers.words[SIZE]
    if size == 1:
        return span
    first = blocks.starts[1 + color] if blocks.starts[1 + color] > span[0] else span[0]
    end = blocks.starts[2 + color] if blocks.starts[2 + color] < span[1] else span[1]
    if first >= end:
        return 0, 0
    if blocks.blocks[first].serial == 1 or end - first < _FEW:
        return first, end
    return _offer(workers.words, task, first, end, (end - first) // (_SHARES * size))


@kernel
def take(words: Integers, worker: int) -> tuple[int, int]:
    """Take the next part of what is offered: (first, end), or (0, 0) if nothing is left. Odd workers take the last."""
    seen = atomic_load(words, RANGE)
    # The grain may be that of a task before with the same range: parts of any size are right.
    while (seen >> _HALF) < (seen & _LOWER):
        first = seen >> _HALF
        end = seen & _LOWER
        grain = words[GRAIN]  # looked at once: another task may be offered meanwhile
        if worker & 1:
            middle = end - grain if end - grain > first else first
            left = (first << _HALF) | middle
            first = middle
        else:
            middle = first + grain if first + grain < end else end
            left = (middle << _HALF) | end
            end = middle
        found = compare_and_swap(words, RANGE, seen, left)
        if found == seen:
            return first, end
        seen = found
    return 0, 0


@kernel
def told_range(workers: Workers) -> tuple[int, int]:
    """Which numbers a worker is to do that calls a part of the step for what it has taken."""
    own: Any = workers.numbers[workers.number * NUMBERS :]
    return int(own[FIRST]), int(own[END])


@inlined_kernel
def look_again(looks: int) -> int:
    """Between two looks at what another thread is to do: at first at once, for that takes less than to be woken; then
    let others have the processor, for who has the rest may be waiting for it. Returns how often it has been looked."""
    if looks > _PATIENCE:
        yield_processor()
    return looks + 1


@kernel
def note_done(words: Integers, count: int) -> None:
    """So many numbers are done."""
    atomic_add(words, DONE, count)


@kernel
def _offer(words: Integers, task: int, first: int, end: int, grain: int) -> tuple[int, int]:
    words[TASK] = task
    words[GRAIN] = grain if grain > 1 else 1
    words[COUNT] = end - first
    words[DONE] = 0
    atomic_store(words, RANGE, (first << _HALF) | end)
    return _take_or_wait(words)


@kernel
def _take_or_wait(words: Integers) -> tuple[int, int]:
    first, end = take(words, 0)
    if end == 0:
        looks = 0
        while atomic_load(words, DONE) < words[COUNT]:
            looks = look_again(looks)
    return first, end
