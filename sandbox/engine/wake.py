"""Waking from outside: what a command touches is simulated again, with all that lies or hangs together with it."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.world.state import State


def wake_body(state: State, index: int) -> None:
    """Wake a body with its island, and the islands of all that touch it or are joined to it."""
    contacts: Any = state.contacts[: int(state.counters[0].contact_count)]
    joints: Any = state.joints
    near = [index]
    for pairs in (contacts, joints):
        near += pairs.body_b[pairs.body_a == index].tolist() + pairs.body_a[pairs.body_b == index].tolist()
    bodies = state.bodies
    islands = bodies.island[[body for body in near if body >= 0]]
    rows = np.isin(bodies.island, islands[islands > 0])
    rows[index] = True
    bodies.awake[rows], bodies.sleep_time[rows], bodies.island[rows] = 1, 0.0, 0
