"""The spatial index of one state, as those who ask have it."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox._jit import Call, kernel_argument
from sandbox.engine.active.active_set import new_active_set
from sandbox.engine.narrow_phase.resting import AtRest
from sandbox.engine.queries.index import lay_out
from sandbox.engine.queries.records import NOTHING, Memory, QueryTables
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import plain
from sandbox.world.state import State

_PARAMETERS = ("tables", "active", "memory")
_UNKNOWN = ActiveSet(new_active_set(), *(np.zeros(2, np.int64) for _ in ActiveSet._fields[1:]))
"""The lists of a state that nobody steps: anybody may have moved."""


class SpatialIndex:
    """Where the shapes of a state are. `arguments` are what kernels that ask are called with first."""

    __slots__ = ("_active", "_lay_out", "_layout", "_resting", "_state", "arguments", "memory")

    memory: Memory
    arguments: tuple[Any, Any]

    def __init__(self, state: State) -> None:
        self._state = state
        self._layout = state.layout
        self._active = _UNKNOWN
        memory = Memory.for_state(state)
        self._lay_out = Call(lay_out, (QueryTables.of(state), _UNKNOWN, memory))
        self._take(memory)

    def update(self) -> bool:
        """Bring it up to date; returns whether rows have moved since the last time."""
        state, moved = self._state, self._layout != self._state.layout
        if moved:
            self._layout = state.layout
            self._take(self.memory if self.memory.holds(state) else Memory.for_state(state, times=2))
        if self._resting is not state.resting:
            self._take(self.memory)
        self._lay_out()
        return moved

    def forget(self) -> None:
        """Lay out all anew the next time."""
        plain(self.memory.info)["generation"] = NOTHING

    def _take(self, memory: Memory) -> None:
        """Prepare what the kernels are called with: the tables of now, and the lists that tell who moves."""
        state, self.memory = self._state, memory
        self._resting = state.resting
        active = state.resting.active if isinstance(state.resting, AtRest) else _UNKNOWN
        if active is not self._active:
            self._active = active
            self.forget()
        self.arguments = tables, own = kernel_argument((QueryTables.of(state), memory))
        arguments = tables, kernel_argument(active), own
        self._lay_out.exchange(_PARAMETERS, dict(zip(_PARAMETERS, arguments, strict=True)))
