"""Contacts among sleepers are kept as they are. Where nobody has woken or fallen asleep, whole runs of them are.

The two tables of contacts take turns, so what is to be kept was in the very table that is written now, two steps ago.
A run of kept rows that has its old place is there already: nothing is copied, nothing is looked at.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import SLEEPS, STIRS, list_contact
from sandbox.engine.active.body_flags import is_active
from sandbox.tables import Field, Integers, Records, Table

RUN = Table(
    "run",
    (
        Field("first", "-", "row of its first contact", "i8"),
        Field("end", "-", "row after its last one", "i8"),
        Field("rank", "-", "kept contacts before it in the table", "i8"),
    ),
)
"""Contacts among bodies that do not stir, one after the other in a table of contacts."""

KEEPER = Table(
    "keeper",
    (
        Field("turn", "-", "0 or 1: which of the two tables of contacts is written", "i8"),
        Field("era0", "-", "of the census when table 0 was written; 0 if never", "i8"),
        Field("era1", "-", "of the census when table 1 was written", "i8"),
        Field("runs0", "-", "runs in table 0", "i8"),
        Field("runs1", "-", "runs in table 1", "i8"),
        Field("written", "-", "runs in the table under way", "i8"),
        Field("rank", "-", "contacts kept so far", "i8"),
        Field("old", "-", "next run of the old table", "i8"),
        Field("here", "-", "next run that is in the table under way from two steps ago", "i8"),
        Field("quiet", "-", "1 when the runs of the old table hold", "i8"),
        Field("same", "-", "1 when those in the table under way hold as well", "i8"),
    ),
)
"""One row: where the walk is. `runs` has the runs of table 0, those of table 1, and those of the walk, in thirds."""


@kernel
def begin_keeping(keeper: Records, era: int) -> None:
    """Begin a walk; `era` counts how often somebody has woken, fallen asleep or been changed."""
    old_era = keeper.era1 if keeper.turn == 0 else keeper.era0
    here_era = keeper.era0 if keeper.turn == 0 else keeper.era1
    keeper.quiet = 1 if old_era == era else 0
    keeper.same = 1 if here_era == era and keeper.quiet == 1 else 0
    keeper.written = keeper.rank = keeper.old = keeper.here = 0


@kernel
def end_keeping(keeper: Records, runs: Records, era: int) -> None:
    """The table is written: its runs are known, and the next step writes the other one."""
    third = runs.shape[0] // 3
    for r in range(keeper.written):
        runs[keeper.turn * third + r] = runs[2 * third + r]
    if keeper.turn == 0:
        keeper.era0 = era
        keeper.runs0 = keeper.written
    else:
        keeper.era1 = era
        keeper.runs1 = keeper.written
    keeper.turn = 1 - keeper.turn


@kernel
def keep_before(
    bodies: Records,
    stirs: Integers,
    old: Records,
    k: int,
    old_count: int,
    shape_a: int,
    shape_b: int,
    contacts: Records,
    count: int,
    live: Integers,
    strikers: Integers,
    keeper: Records,
    runs: Records,
) -> tuple[int, int]:
    """Keep what is to be kept of `old[k:]` before the pair (shape_a, shape_b): (the row after it, the new count)."""
    third = runs.shape[0] // 3
    base = (1 - keeper.turn) * third
    known = (keeper.runs1 if keeper.turn == 0 else keeper.runs0) if keeper.quiet == 1 else 0
    while k < old_count and comes_before(old[k], shape_a, shape_b):
        while keeper.old < known and runs[base + keeper.old].end <= k:
            keeper.old += 1
        if keeper.old < known and runs[base + keeper.old].first <= k:
            end = _first_not_before(old, k, runs[base + keeper.old].end, shape_a, shape_b)
            count = _keep_run(old, k, end, contacts, count, keeper, runs)
            k = end
        else:
            count = _keep_one(bodies, stirs, old[k], contacts, count, live, strikers, keeper, runs)
            k += 1
    return k, count


@inlined_kernel
def comes_before(contact: Records, shape_a: int, shape_b: int) -> bool:
    """Whether a contact has its place before a pair of shapes."""
    first = contact.shape_a
    return bool(first < shape_a or (first == shape_a and contact.shape_b < shape_b))


@kernel
def _first_not_before(old: Records, first: int, end: int, shape_a: int, shape_b: int) -> int:
    """First row of `old[first:end]` that does not come before a pair, or `end`; by bisection."""
    while first < end:
        middle = (first + end) // 2
        if comes_before(old[middle], shape_a, shape_b):
            first = middle + 1
        else:
            end = middle
    return first


@kernel
def _keep_run(old: Records, first: int, end: int, contacts: Records, count: int, keeper: Records, runs: Records) -> int:
    """Keep `old[first:end]`; return the new count."""
    length = end - first
    if not _is_there(count, length, keeper, runs):
        for n in range(length):
            contacts[count + n] = old[first + n]
    _note_run(count, length, keeper, runs)
    return count + length


@kernel
def _is_there(count: int, length: int, keeper: Records, runs: Records) -> bool:
    """Whether the table under way has the next contacts to keep at row `count` already."""
    if keeper.same == 0:
        return False
    base = keeper.turn * (runs.shape[0] // 3)
    there = keeper.runs0 if keeper.turn == 0 else keeper.runs1
    while keeper.here < there and runs[base + keeper.here].end <= count:
        keeper.here += 1
    if keeper.here >= there:
        return False
    run = runs[base + keeper.here]
    return bool(run.first <= count and count + length <= run.end and run.rank + count - run.first == keeper.rank)


@kernel
def _note_run(first: int, length: int, keeper: Records, runs: Records) -> None:
    base = 2 * (runs.shape[0] // 3)
    last = base + keeper.written - 1
    if keeper.written > 0 and runs[last].end == first:
        runs[last].end = first + length
    else:
        run = runs[last + 1]
        run.first = first
        run.end = first + length
        run.rank = keeper.rank
        keeper.written += 1
    keeper.rank += length


@kernel
def _keep_one(
    bodies: Records,
    stirs: Integers,
    old: Records,
    contacts: Records,
    count: int,
    live: Integers,
    strikers: Integers,
    keeper: Records,
    runs: Records,
) -> int:
    """Append an old contact if one of its bodies sleeps and none is active; return the new count."""
    both = stirs[old.body_a] | stirs[old.body_b]
    if both & SLEEPS == 0:
        return count
    if both & STIRS and (is_active(bodies[old.body_a]) or is_active(bodies[old.body_b])):
        return count
    contacts[count] = old
    if both & STIRS:  # a driven body has left the sleeper, who will wake
        list_contact(old, count, True, live, strikers)
    else:
        _note_run(count, 1, keeper, runs)
    return count + 1
