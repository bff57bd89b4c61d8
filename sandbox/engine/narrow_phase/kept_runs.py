"""What the runs of contacts among sleepers tell between steps: which of them are as they were a step before. Where rows
have gone, those that name nobody else than before keep their numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.narrow_phase.sleeping_contacts import NOTHING
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, plain
from sandbox.world.rows import Moved
from sandbox.world.runs import runs

_MANY = 8
"""Where more than one contact in so many has gone or names others, all get new numbers."""


def keep_runs(active: ActiveSet, contacts: Contacts, moved: Moved) -> None:
    """Bring the runs of the last step's contacts, `contacts.before`, up to date, and its list of all others.

    The table of the step before that is as it was, and so are its runs: numbers are never given again.
    """
    info, cursor = plain(active.info)[0], plain(contacts.cursor)[0]
    last = 1 - int(cursor["turn"])
    known = not info["stale"] and cursor[f"era{last}"] == info["era"]  # else the state is not what a step has left
    if not known or _MANY * len(moved.renamed) > len(moved.contacts):
        info["era"] += 1
        return
    contacts.first_kept[moved.bodies.first :] = NOTHING
    gone = np.flatnonzero(~moved.contacts)
    third = len(contacts.runs) // 3
    own: Any = plain(contacts.runs)[last * third : (last + 1) * third]
    first, end, number = _cut(own[: int(cursor[f"runs{last}"])], moved.renamed)
    count = cursor[f"runs{last}"] = len(first)
    own["first"][:count], own["end"][:count] = first - np.searchsorted(gone, first), end - np.searchsorted(gone, end)
    own["number"][:count] = number
    _list_others(contacts, moved)


def rows_in_doubt(
    active: ActiveSet, contacts: Contacts, old_count: int, count: int
) -> tuple[Integers, Integers] | None:
    """The rows of the contacts of the last two steps, `now` and `before`, that are not those of the same sleepers in
    both; None where that is not known, or all are in doubt."""
    info, cursor = plain(active.info)[0], plain(contacts.cursor)[0]
    turn = int(cursor["turn"])
    if info["stale"] or not cursor["era0"] == cursor["era1"] == info["era"] or not cursor[f"runs{1 - turn}"]:
        return None
    old_first, first, length = _in_both(*(_runs(contacts, third) for third in (turn, 1 - turn)))
    listed: Any = plain(contacts.active)
    stirred = listed["contact"][1 : 1 + int(listed["contact"][0])].astype(np.int64)
    owner = np.searchsorted(first, stirred, "right") - 1
    woken = (owner >= 0) & (stirred < (first + length)[owner]) if len(first) else np.zeros(len(stirred), np.bool_)
    old_stirred = stirred[woken] + (old_first - first)[owner[woken]]
    order = old_first.argsort()
    old_rows = np.union1d(_between(old_first[order], length[order], old_count), old_stirred)
    return old_rows, np.union1d(_between(first, length, count), stirred)


def _runs(contacts: Contacts, which: int) -> tuple[Integers, Integers, Integers]:
    """First rows, lengths and first numbers of the runs of one of the two tables, by number."""
    third = len(contacts.runs) // 3
    runs: Any = plain(contacts.runs)[which * third :][: int(plain(contacts.cursor)[0][f"runs{which}"])]
    first, end, number = (runs[name].astype(np.int64) for name in ("first", "end", "number"))
    order = number.argsort()
    return first[order], (end - first)[order], number[order]


def _in_both(
    one: tuple[Integers, Integers, Integers], other: tuple[Integers, Integers, Integers]
) -> tuple[Integers, Integers, Integers]:
    """First rows in both tables, and lengths, of what lies in runs of both, in the order of the second."""
    bounds = [edge for _, length, number in (one, other) for edge in (number, number + length)]
    numbers = np.unique(np.concatenate(bounds))
    starts, lengths = numbers[:-1], np.diff(numbers)
    rows, inside = [], np.ones(len(starts), np.bool_)
    for first, length, number in (one, other):
        if not len(first):
            return first, first, first
        owner = np.maximum(np.searchsorted(number, starts, "right") - 1, 0)
        inside &= (starts >= number[owner]) & (starts < (number + length)[owner])
        rows.append(first[owner] + starts - number[owner])
    order = rows[1][inside].argsort()
    return rows[0][inside][order], rows[1][inside][order], lengths[inside][order]


def _between(first: Integers, length: Integers, count: int) -> Integers:
    """Of so many rows those that lie in none of some runs."""
    starts = np.concatenate([[0], first + length])
    return runs(starts, np.concatenate([first, [count]]) - starts)


def _cut(own: Any, rows: Integers) -> tuple[Integers, Integers, Integers]:
    """The first rows, ends and numbers of the runs that are left when some rows are taken out."""
    first, end, number = (own[name].astype(np.int64) for name in ("first", "end", "number"))
    if not len(own) or not len(rows):
        return first, end, number
    owner = np.searchsorted(first, rows, "right") - 1
    rows = rows[(owner >= 0) & (rows < end[owner])]
    starts, ends = np.sort(np.concatenate([first, rows + 1])), np.sort(np.concatenate([end, rows]))
    some = starts < ends
    starts, ends = starts[some], ends[some]
    owner = np.searchsorted(first, starts, "right") - 1
    return starts, ends, number[owner] + starts - first[owner]


def _list_others(contacts: Contacts, moved: Moved) -> None:
    """List the contacts that are in no run: those that were listed and are left, and those that name others now."""
    listed: Any = plain(contacts.active)
    others = np.zeros(len(moved.contacts), np.bool_)  # flags: to sort the rows takes most of a deletion
    others[listed["contact"][1 : 1 + int(listed["contact"][0])]] = others[moved.renamed] = True
    rows = np.flatnonzero(others[moved.contacts])
    listed["contact"][0] = len(rows)
    listed["contact"][1 : 1 + len(rows)] = rows
    table: Any = plain(contacts.before)
    for side in ("body_a", "body_b"):
        listed[side][1 : 1 + len(rows)] = table[side][rows]
