"""The paths of a world around its steps: what their kernels ask for, and who hears of bodies that begin to move."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sandbox._jit import Door, kernel_argument
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.bodies.paths import STOP, WAY, arrive, lead
from sandbox.scene.flat_body import FlatPath
from sandbox.tables import Records, plain
from sandbox.world.runs import run_starts
from sandbox.world.state import State


class Paths:
    """The paths of a world; `on_switch` hears of the rows of driven bodies that begin to move, or stop, and of
    those that wake by it."""

    def __init__(self, state: State, on_switch: Callable[[Sequence[int]], None]) -> None:
        self._state, self._on_switch = state, on_switch
        self._lead, self._arrive = Door(lead), Door(arrive)
        self._layout = -1
        """That of the state for which the ways hold."""
        self._ways, self._stops = ways_of([])

    def lead(self) -> None:
        """Give every driven body the velocity with which it arrives on time."""
        state = self._state
        if self._layout != state.layout:
            items, driven = state.census.bodies.items, plain(state.paths)["body"]
            self._layout = state.layout
            self._ways, self._stops = ways_of([items[row].path for row in driven.tolist()])
        seconds = float(plain(state.settings)["step_seconds"][0])
        if self._lead(*self._tables(), kernel_argument(self._stops), seconds):
            rows = plain(state.paths)["body"][plain(self._ways)["switched"] == 1]
            self._on_switch(wake_bodies(state, rows))

    def arrive(self) -> None:
        """Write the poses that were led to."""
        self._arrive(*self._tables())

    def _tables(self) -> tuple[Any, ...]:
        tables: tuple[Any, ...] = kernel_argument((self._state.bodies, self._state.paths, self._ways))
        return tables


def ways_of(paths: Sequence[FlatPath | None]) -> tuple[Records, Records]:
    """The tables of ways and of their places that the kernels ask for."""
    counts = np.array([0 if path is None else len(path.times) for path in paths], np.int64)
    ways, stops = WAY.zeros(len(paths)), STOP.zeros(int(counts.sum()))
    ways.first, ways.count = run_starts(counts), counts
    ways.loops = [path is not None and path.loops for path in paths]
    ways.smooth = [path is not None and path.smooth for path in paths]
    given = [path for path in paths if path is not None]
    stops[:] = [(time, *place) for path in given for time, place in zip(path.times, path.points, strict=True)]
    return ways, stops
