"""Contacts among sleepers are kept as they are. Where nobody has woken or fallen asleep, whole runs of them are.

The two tables of contacts take turns, so what is to be kept was in the very table that is written now, two steps ago.
A run of kept rows that has its old place is there already: nothing is copied, nothing is looked at.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.active.active_set import ASLEEP, AWAKE, list_contact
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.broad_phase.pairs import comes_before
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records


@kernel
def begin_sleeping_contacts(cursor: Records, generation: int) -> None:
    """Begin a walk; `generation` is that of the active set."""
    old = cursor.generation1 if cursor.turn == 0 else cursor.generation0
    here = cursor.generation0 if cursor.turn == 0 else cursor.generation1
    cursor.quiet = 1 if old == generation else 0
    cursor.same = 1 if here == generation and cursor.quiet == 1 else 0
    cursor.written = cursor.rank = cursor.old = cursor.here = 0


@kernel
def end_sleeping_contacts(cursor: Records, runs: Records, generation: int) -> None:
    """The table is written: its runs are known, and the next step writes the other one."""
    third = runs.shape[0] // 3
    for r in range(cursor.written):
        runs[cursor.turn * third + r] = runs[2 * third + r]
    if cursor.turn == 0:
        cursor.generation0 = generation
        cursor.runs0 = cursor.written
    else:
        cursor.generation1 = generation
        cursor.runs1 = cursor.written
    cursor.turn = 1 - cursor.turn


@kernel
def keep_sleeping_before(
    bodies: Records,
    activity: Integers,
    contacts: Contacts,
    k: int,
    old_count: int,
    shape_a: int,
    shape_b: int,
    count: int,
) -> tuple[int, int]:
    """Keep what is to be kept of `contacts.before[k:]` before the pair (shape_a, shape_b).

    Returns (the row after it, the new count of contacts).
    """
    old = contacts.before
    cursor = contacts.cursor[0]
    runs = contacts.runs
    third = runs.shape[0] // 3
    base = (1 - cursor.turn) * third
    known = (cursor.runs1 if cursor.turn == 0 else cursor.runs0) if cursor.quiet == 1 else 0
    while k < old_count and comes_before(old[k], shape_a, shape_b):
        while cursor.old < known and runs[base + cursor.old].end <= k:
            cursor.old += 1
        if cursor.old < known and runs[base + cursor.old].first <= k:
            end = first_not_before(old, k, runs[base + cursor.old].end, shape_a, shape_b)
            count = _keep_run(old, k, end, contacts.now, count, cursor, runs)
            k = end
        else:
            count = _keep_one(bodies, activity, contacts, k, count)
            k += 1
    return k, count


@kernel
def first_not_before(old: Records, first: int, end: int, shape_a: int, shape_b: int) -> int:
    """First row of `old[first:end]` that does not come before a pair, or `end`; by bisection."""
    while first < end:
        middle = (first + end) // 2
        if comes_before(old[middle], shape_a, shape_b):
            first = middle + 1
        else:
            end = middle
    return first


@kernel
def _keep_run(old: Records, first: int, end: int, contacts: Records, count: int, cursor: Records, runs: Records) -> int:
    """Keep `old[first:end]`; return the new count."""
    length = end - first
    if not _is_there(count, length, cursor, runs):
        for n in range(length):
            contacts[count + n] = old[first + n]
    _note_run(count, length, cursor, runs)
    return count + length


@kernel
def _is_there(count: int, length: int, cursor: Records, runs: Records) -> bool:
    """Whether the table under way has the next contacts to keep at row `count` already."""
    if cursor.same == 0:
        return False
    base = cursor.turn * (runs.shape[0] // 3)
    there = cursor.runs0 if cursor.turn == 0 else cursor.runs1
    while cursor.here < there and runs[base + cursor.here].end <= count:
        cursor.here += 1
    if cursor.here >= there:
        return False
    run = runs[base + cursor.here]
    return bool(run.first <= count and count + length <= run.end and run.rank + count - run.first == cursor.rank)


@kernel
def _note_run(first: int, length: int, cursor: Records, runs: Records) -> None:
    base = 2 * (runs.shape[0] // 3)
    last = base + cursor.written - 1
    if cursor.written > 0 and runs[last].end == first:
        runs[last].end = first + length
    else:
        run = runs[last + 1]
        run.first = first
        run.end = first + length
        run.rank = cursor.rank
        cursor.written += 1
    cursor.rank += length


@kernel
def _keep_one(bodies: Records, activity: Integers, contacts: Contacts, k: int, count: int) -> int:
    """Append old contact k if one of its bodies sleeps and none is active; return the new count."""
    old = contacts.before[k]
    both = activity[old.body_a] | activity[old.body_b]
    if both & ASLEEP == 0:
        return count
    if both & AWAKE and (is_active(bodies[old.body_a]) or is_active(bodies[old.body_b])):
        return count
    contacts.now[count] = old
    if both & AWAKE:  # a driven body has left the sleeper, who will wake
        list_contact(old, count, contacts)
    else:
        _note_run(count, 1, contacts.cursor[0], contacts.runs)
    return count + 1
