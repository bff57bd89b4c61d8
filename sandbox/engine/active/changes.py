"""What is changed from outside between steps: how the lists of the active set, and the grid, hear of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Grid
from sandbox.tables import plain
from sandbox.world.records import STATIC
from sandbox.world.rows import Moved


def forget(active: ActiveSet) -> None:
    """Anything may have been changed: everybody is to be looked at."""
    plain(active.info)["stale"] = 1


def touch(active: ActiveSet, fixed: Sequence[int]) -> None:
    """Bodies that may move were changed, and others in those rows: these are to be looked at."""
    plain(active.info)["shifted"] = 1
    if fixed:
        touched = active.touched
        rows = np.union1d(touched[1 : 1 + touched[0]], fixed)
        if len(rows) < len(touched):
            touched[0], touched[1 : 1 + len(rows)] = len(rows), rows
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
    for rows in (active.loose, active.touched):
        rows[0] = np.searchsorted(rows[1 : 1 + rows[0]], body)
    info, known = plain(active.info)[0], plain(grid.info)[0]
    listed = int(info["bodies"])
    if body < listed:
        info["bodies"] = body
        info["static"] -= int((moved.types[: listed - body] == STATIC).sum())
    info["loose"] = np.searchsorted(active.loose_shapes[: info["loose"]], shape)
    info["shapes"], known["known"] = min(info["shapes"], shape), min(known["known"], shape)
    info["shifted"] = 1
