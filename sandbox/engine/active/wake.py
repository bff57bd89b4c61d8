"""Waking from outside: what a command touches is simulated again, with all that lies or hangs together with it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sandbox.tables import Integers
from sandbox.world.state import State


def wake_body(state: State, index: int) -> None:
    """Wake a body with its island, and the islands of all that touch it or are joined to it."""
    wake_bodies(state, [index])


def wake_bodies(state: State, rows: Sequence[int] | Integers) -> None:
    """Wake bodies with their islands, and the islands of all that touch them or are joined to them."""
    contacts: Any = state.contacts[: int(state.counters[0].contact_count)]
    joints: Any = state.joints
    chosen = np.zeros(len(state.bodies) + 1, np.bool_)  # -1, the world, is the last row
    chosen[rows] = True
    near = chosen.copy()
    for pairs in (contacts, joints):
        near[pairs.body_b[chosen[pairs.body_a]]] = True
        near[pairs.body_a[chosen[pairs.body_b]]] = True
    bodies = state.bodies
    islands = bodies.island[near[:-1]]
    awoken = np.isin(bodies.island, islands[islands > 0]) | chosen[:-1]
    bodies.awake[awoken], bodies.sleep_time[awoken], bodies.island[awoken] = 1, 0.0, 0
