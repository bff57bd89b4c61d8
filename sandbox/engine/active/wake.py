"""Waking from outside: what a command touches is simulated again, with all that lies or hangs together with it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from sandbox.tables import FloatWords, Integers, WholeWords, plain
from sandbox.world.records import DYNAMIC
from sandbox.world.records import BodyPlace as At
from sandbox.world.state import State

Rows: TypeAlias = tuple[int, ...]


def wake_body(state: State, index: int) -> Rows:
    """Wake a body with its island, and the islands of all that touch it or are joined to it; as `wake_bodies`."""
    return wake_bodies(state, [index])


def keep_awake(numbers: FloatWords, flags: WholeWords) -> None:
    """Let a body that is awake, by the words of its row, begin anew to count how long it has been slow."""
    numbers[At.SLEEP_TIME], flags[At.ISLAND] = 0.0, 0


def wake_bodies(state: State, rows: Sequence[int] | Integers) -> Rows:
    """Wake bodies with their islands, and the islands of all that touch them or are joined to them.

    Returns the rows of all these, for the active set to look at (`Touched`).
    """
    bodies, counter = plain(state.bodies), plain(state.counters)[0]
    if counter["asleep_count"] == 0:
        return _rouse(bodies, np.asarray(rows, np.int64))
    contacts, joints = plain(state.contacts)[: counter["contact_count"]], plain(state.joints)
    chosen = np.zeros(len(bodies) + 1, np.bool_)  # -1, the world, is the last row
    chosen[rows] = True
    near = chosen.copy()
    for pairs in (contacts, joints):
        a, b = pairs["body_a"], pairs["body_b"]
        near[b[chosen[a]]] = True
        near[a[chosen[b]]] = True
    islands = bodies["island"][near[:-1]]
    awoken = np.flatnonzero(chosen[:-1])
    if islands.any():
        awoken = np.union1d(awoken, np.flatnonzero(np.isin(bodies["island"], islands[islands > 0])))
    return _rouse(bodies, awoken)


def wake_all(state: State) -> None:
    """Wake every sleeper."""
    bodies = plain(state.bodies)
    _rouse(bodies, np.flatnonzero((bodies["type"] == DYNAMIC) & (bodies["awake"] == 0)))


def _rouse(bodies: Any, rows: Integers) -> Rows:
    bodies["awake"][rows], bodies["sleep_time"][rows], bodies["island"][rows] = 1, 0.0, 0
    return tuple(rows.tolist())
