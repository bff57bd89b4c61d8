"""What is changed from outside between steps: how the lists of the active set, and the grid, hear of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox.engine.active.active_set import ASLEEP
from sandbox.engine.active.bearable_mass import WITH_GONE
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Grid
from sandbox.tables import Integers, plain
from sandbox.world.records import DYNAMIC, STATIC
from sandbox.world.rows import Moved


def forget(active: ActiveSet) -> None:
    """Anything may have been changed: everybody is to be looked at."""
    plain(active.info)["stale"] = 1


def touch(active: ActiveSet, rows: Sequence[int]) -> None:
    """Bodies that may move were changed, and bodies in those rows have woken or were changed: these are to be looked
    at."""
    plain(active.info)["shifted"] = 1
    if len(rows) == 1:
        _touch_one(active, rows[0])
    elif rows:
        touched = active.touched
        _touch_only(active, np.union1d(touched[1 : 1 + touched[0]], rows))


def _touch_one(active: ActiveSet, row: int) -> None:
    """One more row among the touched ones, in its place: a command each for thousands of bodies takes no time for what
    was touched before."""
    touched = active.touched
    count = int(touched[0])
    place = 1 + int(touched[1 : 1 + count].searchsorted(row))
    if place <= count and touched[place] == row:
        return
    if count + 1 < len(touched):
        touched[place + 1 : count + 2] = touched[place : count + 1]
        touched[place], touched[0] = row, count + 1
    else:
        forget(active)


def _touch_only(active: ActiveSet, rows: Integers) -> None:
    """These rows alone are to be looked at; everybody is, where they are many."""
    if len(rows) < len(active.touched):
        active.touched[0], active.touched[1 : 1 + len(rows)] = len(rows), rows
    else:
        forget(active)


def keep_what_stays(active: ActiveSet, grid: Grid, moved: Moved) -> None:
    """Rows have gone: what comes before the first of them is still where it was, all else is as if it had come. Where
    that is much, everybody is."""
    body, shape = moved.bodies.first, moved.shapes.first
    if len(moved.bodies.left) >= len(active.touched):
        forget(active)
        plain(grid.cache.info)["valid"] = 0
        return
    rows, touched = active.bodies, active.touched
    rows[0] = np.searchsorted(rows[1 : 1 + rows[0]], body)
    some = touched[1 : 1 + touched[0]]
    _touch_only(active, some[some < body])
    info, known = plain(active.info)[0], plain(grid.info)[0]
    listed = int(info["bodies"])
    if body < listed:
        info["bodies"] = body
        info["static"] -= int((moved.types[: listed - body] == STATIC).sum())
        info["asleep"] -= int((active.activity[body:listed] == ASLEEP).sum())
    known["known"] = min(known["known"], shape)
    info["shifted"] = 1
    if info["weighed"] and (moved.types[~moved.bodies.left] == DYNAMIC).any():
        info["weighed"] = WITH_GONE
