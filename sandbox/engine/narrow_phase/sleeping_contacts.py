"""Contacts among sleepers are kept as they are. Where nobody has woken or fallen asleep, whole runs of them are.

The two tables of contacts take turns, so what is to be kept was in the very table that is written now, two steps ago.
Each contact gets a number when it is first kept: a run of consecutive numbers that has its old place is there already,
and nothing is copied. Of a number it is known whose contact that is, so that somebody who wakes is found without a look
at the contacts, and all contacts of a body are in a list, for commands that wake or delete it (`resting.py`).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import ASLEEP, AWAKE, list_contact
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.broad_phase.pairs import comes_before
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records

NOTHING = -1
_SEAMS = 16
"""All contacts get new numbers once one in so many follows another one in the table, but not in number."""


@kernel
def begin_sleeping_contacts(contacts: Contacts, info: Records, old_count: int) -> None:
    """Begin a walk over so many contacts of the step before; `info` is that of the active set."""
    cursor = contacts.cursor[0]
    if cursor.next + old_count > contacts.kept.shape[0] or _SEAMS * cursor.seams > 64 * _SEAMS + old_count:
        cursor.era0 = cursor.era1 = cursor.next = 0
        for i in range(contacts.first_kept.shape[0]):
            contacts.first_kept[i] = NOTHING
    known = (cursor.era1 if cursor.turn == 0 else cursor.era0) == info.era
    here = (cursor.era0 if cursor.turn == 0 else cursor.era1) == info.era
    old = cursor.generation1 if cursor.turn == 0 else cursor.generation0
    cursor.known = (cursor.runs1 if cursor.turn == 0 else cursor.runs0) if known else 0
    cursor.quiet = 1 if old == info.generation else 0
    cursor.same = 1 if known and here else 0
    cursor.written = cursor.seams = cursor.old = cursor.here = 0


@kernel
def end_sleeping_contacts(contacts: Contacts, info: Records) -> None:
    """The table is written: its runs are known, and the next step writes the other one."""
    cursor = contacts.cursor[0]
    runs = contacts.runs
    third = runs.shape[0] // 3
    for r in range(cursor.written):
        runs[cursor.turn * third + r] = runs[2 * third + r]
    if cursor.turn == 0:
        cursor.generation0 = info.generation
        cursor.era0 = info.era
        cursor.runs0 = cursor.written
    else:
        cursor.generation1 = info.generation
        cursor.era1 = info.era
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
    base = (1 - cursor.turn) * (runs.shape[0] // 3)
    while k < old_count and comes_before(old[k], shape_a, shape_b):
        while cursor.old < cursor.known and runs[base + cursor.old].end <= k:
            cursor.old += 1
        if cursor.old < cursor.known and runs[base + cursor.old].first <= k:
            run = runs[base + cursor.old]
            end = first_not_before(old, k, run.end, shape_a, shape_b)
            count = _keep_some(bodies, activity, contacts, k, end, run.number + k - run.first, count)
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
def _keep_some(
    bodies: Records, activity: Integers, contacts: Contacts, first: int, end: int, number: int, count: int
) -> int:
    """Keep what is to be kept of a run `before[first:end]` with that first number; return the new count."""
    if contacts.cursor[0].quiet == 1:
        return _keep_run(contacts, first, end, number, count)
    kept = contacts.kept
    shift = number - first
    while first < end:
        k = first
        while k < end and _both(activity, kept[shift + k]) & (ASLEEP | AWAKE) == ASLEEP:
            k += 1
        if k > first:
            count = _keep_run(contacts, first, k, shift + first, count)
        if k < end:
            count = _keep_one(bodies, activity, contacts, k, count)
        first = k + 1
    return count


@inlined_kernel
def _both(activity: Integers, pair: Records) -> int:
    """The activities of two bodies."""
    return int(activity[pair.body_a] | activity[pair.body_b])


@kernel
def _keep_run(contacts: Contacts, first: int, end: int, number: int, count: int) -> int:
    """Keep `before[first:end]`; return the new count."""
    length = end - first
    if not _is_there(count, length, number, contacts):
        for n in range(length):
            contacts.now[count + n] = contacts.before[first + n]
    _note_run(count, length, number, contacts)
    return count + length


@kernel
def _is_there(count: int, length: int, number: int, contacts: Contacts) -> bool:
    """Whether the table under way has the contacts from a `number` on at row `count` already."""
    cursor = contacts.cursor[0]
    runs = contacts.runs
    if cursor.same == 0:
        return False
    base = cursor.turn * (runs.shape[0] // 3)
    there = cursor.runs0 if cursor.turn == 0 else cursor.runs1
    while cursor.here < there and runs[base + cursor.here].end <= count:
        cursor.here += 1
    if cursor.here >= there:
        return False
    run = runs[base + cursor.here]
    return bool(run.first <= count and count + length <= run.end and run.number + count - run.first == number)


@kernel
def _note_run(first: int, length: int, number: int, contacts: Contacts) -> None:
    cursor = contacts.cursor[0]
    runs = contacts.runs
    last = 2 * (runs.shape[0] // 3) + cursor.written - 1
    follows = cursor.written > 0 and runs[last].end == first
    if follows and runs[last].number + first - runs[last].first == number:
        runs[last].end = first + length
        return
    cursor.seams += 1 if follows else 0
    run = runs[last + 1]
    run.first = first
    run.end = first + length
    run.number = number
    cursor.written += 1


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
        _note_run(count, 1, _give_number(old, contacts), contacts)
    return count + 1


@kernel
def _give_number(contact: Records, contacts: Contacts) -> int:
    """The number of a contact that is first kept, which comes first in the lists of both bodies."""
    cursor = contacts.cursor[0]
    number: int = cursor.next
    a = contact.body_a
    b = contact.body_b
    pair = contacts.kept[number]
    pair.body_a = a
    pair.body_b = b
    link = contacts.links[number]
    link.shape_a = contact.shape_a
    link.shape_b = contact.shape_b
    link.next_a = contacts.first_kept[a]
    link.next_b = contacts.first_kept[b]
    contacts.first_kept[a] = contacts.first_kept[b] = number
    cursor.next += 1
    return number


@kernel
def list_active_contacts(bodies: Records, activity: Integers, contacts: Contacts, count: int) -> None:
    """List the contacts with an active body, and those of them that may have an impact, of so many.

    The narrow phase has made these lists; they are made anew after somebody has woken.
    """
    contacts.active[0].contact = 0
    contacts.impact_candidates[0] = 0
    cursor = contacts.cursor[0]
    runs = contacts.runs
    base = (1 - cursor.turn) * (runs.shape[0] // 3)
    row = 0
    for r in range(cursor.written):
        run = runs[base + r]
        _list_active(bodies, contacts, row, run.first)
        for i in range(run.first, run.end):
            if _both(activity, contacts.kept[run.number + i - run.first]) & AWAKE:
                _list_active(bodies, contacts, i, i + 1)
        row = run.end
    _list_active(bodies, contacts, row, count)


@inlined_kernel
def _list_active(bodies: Records, contacts: Contacts, first: int, end: int) -> None:
    """List those of the contacts first..end-1 that have an active body."""
    for i in range(first, end):
        contact = contacts.now[i]
        if is_active(bodies[contact.body_a]) or is_active(bodies[contact.body_b]):
            list_contact(contact, i, contacts)
