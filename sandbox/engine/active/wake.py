"""Waking from outside: what a command touches is simulated again, with all that lies or hangs together with it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from sandbox.tables import FloatWords, Integers, WholeWords, plain
from sandbox.world.contact_rows import contacts_of
from sandbox.world.joined import Joined
from sandbox.world.records import DYNAMIC
from sandbox.world.records import BodyPlace as At
from sandbox.world.state import State

Rows: TypeAlias = tuple[int, ...]

_FEW = 4
"""Bodies up to which the words of each row are written sooner than columns."""


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
    bodies = plain(state.bodies)
    if plain(state.counters)["asleep_count"][0] == 0:
        return _rouse_few(state, rows) if len(rows) <= _FEW else _rouse(bodies, np.asarray(rows, np.int64))
    chosen = np.unique(np.asarray(rows, np.int64))
    chosen = chosen[chosen >= 0]  # -1 is the world
    near = np.concatenate([chosen, _touching(state, chosen), _joined(state, chosen)])
    islands = np.unique(bodies["island"][near[near >= 0]])
    islands = islands[islands > 0]
    if len(islands):
        chosen = np.union1d(chosen, _members(state, islands))
    return _rouse(bodies, chosen)


def wake_all(state: State) -> Rows:
    """Wake every sleeper. Returns their rows."""
    return _rouse(plain(state.bodies), sleepers(state))


def sleepers(state: State) -> Integers:
    """The rows of the bodies that sleep."""
    bodies = plain(state.bodies)
    if plain(state.counters)["asleep_count"][0] == 0:
        return np.zeros(0, np.int64)
    return np.flatnonzero((bodies["type"] == DYNAMIC) & (bodies["awake"] == 0))


def _touching(state: State, rows: Integers) -> Integers:
    """The bodies on both sides of the contacts of some."""
    count = int(plain(state.counters)["contact_count"][0])
    contacts = plain(state.contacts)[contacts_of(state.contacts, count, rows, state.resting)]
    return np.concatenate([contacts["body_a"], contacts["body_b"]]).astype(np.int64)


def _joined(state: State, rows: Integers) -> Integers:
    """The bodies that joints hold to some."""
    if len(state.joints) == 0:
        return rows[:0]
    if state.joined is None or not state.joined.holds(state.joints):
        state.joined = Joined.of(state.joints)
    return state.joined.others_of(rows, state.joints)


def _members(state: State, islands: Integers) -> Integers:
    """The bodies of some islands."""
    known = state.resting.members(state.bodies, islands) if state.resting is not None else None
    return np.flatnonzero(np.isin(plain(state.bodies)["island"], islands)) if known is None else known


def _rouse_few(state: State, rows: Sequence[int] | Integers) -> Rows:
    """The same by the words of rows, which numpy takes as long for as for a hundred of them."""
    chosen = tuple(map(int, rows))
    for row in chosen:
        numbers, flags = state.body_words(row)
        flags[At.AWAKE] = 1
        keep_awake(numbers, flags)
    return chosen


def _rouse(bodies: Any, rows: Integers) -> Rows:
    bodies["awake"][rows], bodies["sleep_time"][rows], bodies["island"][rows] = 1, 0.0, 0
    return tuple(rows.tolist())
