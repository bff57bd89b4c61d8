"""Steps the worlds of many rows in one call: each goes through the tables of a lane.

Several threads may run this at once, each with a lane of its own; they take worlds from one queue.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from sandbox._atomics import atomic_add
from sandbox._jit import entry_point, kernel
from sandbox.engine.records.calls import FIELDS
from sandbox.engine.run_steps import (
    ASLEEP,
    DONE,
    FIRST,
    LAST_SWITCH,
    LOST,
    STEPS,
    TURN,
    WORK,
    CounterWords,
    lost_count,
    run_steps,
)
from sandbox.tables import Integers

REDO, APART = 1, 2
"""What a world's `verdicts` say, if not `DONE`: it has to be stepped again, by Python, from its row; it has no row."""

AT_ONCE = 4
"""Worlds that a thread takes from the queue at a time."""

WITHOUT_END = 1 << 62
"""Work after which a world goes back to Python."""

NEXT, EACH = 0, 1
"""What a queue says: the world that is taken next, and how many steps each goes."""


class Rows(NamedTuple):
    """The worlds: `words` (worlds, words of a row), `contacts` (worlds, words of all contacts that there is room for),
    the step after which schedules change nothing, and what came of each."""

    words: Integers
    contacts: Integers
    last_switches: Integers
    verdicts: Integers


class Lane(NamedTuple):
    """The tables of one lane as words: all but the contacts, the two tables of contacts that swap places, the record of
    the active set; `machine` [turn, part, CODE or BLOCK], the addresses of the parts of a step; and the order for
    `run_steps`."""

    words: Integers
    even_contacts: Integers
    odd_contacts: Integers
    active: Integers
    machine: Integers
    order: Integers


class Words(NamedTuple):
    """Which words of a row hold the counters that are looked at here, the one of the active set that says that it is
    stale, and how many words a contact has."""

    counters: CounterWords
    stale: int
    contact: int


@entry_point
def advance_rows(rows: Rows, lane: Lane, at: Words, queue: Integers, turn: int) -> int:
    """Take `queue[EACH]` steps with worlds from `queue[NEXT]` on, until there are none; returns how many were taken.

    `turn` is that of the lane, before and after. A world whose step needs Python (more memory, joints that have broken,
    frozen bodies) keeps its row and has the verdict `REDO`.
    """
    count = rows.words.shape[0]
    steps = queue[EACH]
    taken = 0
    while True:
        first = atomic_add(queue, NEXT, AT_ONCE)
        if first >= count:
            return taken
        end = first + AT_ONCE if first + AT_ONCE < count else count
        for world in range(first, end):
            if rows.verdicts[world] != APART:
                _load(rows, lane, at, turn, world)
                rows.verdicts[world] = _advance(rows, lane, at, turn, steps, world)
                taken += 1


@kernel
def _load(rows: Rows, lane: Lane, at: Words, turn: int, world: int) -> None:
    """Write a world into the tables of a lane."""
    _copy(rows.words[world], lane.words, lane.words.shape[0])
    contacts: Any = lane.even_contacts if turn == 0 else lane.odd_contacts
    _copy(rows.contacts[world], contacts, lane.words[at.counters.contact_count] * at.contact)
    lane.active[at.stale] = 1


@kernel
def _advance(rows: Rows, lane: Lane, at: Words, turn: int, steps: int, world: int) -> int:
    """Step what is in a lane and write it back; returns the verdict."""
    words = lane.words
    lost = lost_count(words, at.counters)
    lane.order[TURN] = turn
    lane.order[FIRST] = FIELDS
    lane.order[STEPS] = steps
    lane.order[LAST_SWITCH] = rows.last_switches[world]
    lane.order[LOST] = lost
    lane.order[WORK] = WITHOUT_END
    came = run_steps(lane.machine, words, at.counters, lane.order)
    count = words[at.counters.contact_count] * at.contact
    if (came != DONE and came != ASLEEP) or lost_count(words, at.counters) != lost or count > rows.contacts.shape[1]:
        return REDO
    contacts: Any = lane.even_contacts if lane.order[TURN] == 0 else lane.odd_contacts
    _copy(contacts, rows.contacts[world], count)
    _copy(words, rows.words[world], words.shape[0])
    return DONE


@kernel
def _copy(source: Integers, target: Integers, count: int) -> None:
    for k in range(count):
        target[k] = source[k]
