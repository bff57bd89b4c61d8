"""How a user sees all bodies: as columns, NumPy views of the records."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from sandbox.attributes import FixedAttributes
from sandbox.engine.views.base import ViewedWorld
from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import BODY


def _vectors(records: Records, first: str) -> Floats:
    """Read-only (n, 2) view of two neighbouring columns, `first` and the one after it."""
    offset = records.dtype.fields[first][1]
    pair = np.dtype({"names": ["v"], "formats": [("f8", (2,))], "offsets": [offset], "itemsize": BODY.dtype.itemsize})
    view: Floats = np.asarray(records).view(pair)["v"]
    view.flags.writeable = False
    return view


def _column(records: Records, name: str) -> Any:
    view = np.asarray(records)[name]
    view.flags.writeable = False
    return view


class Bodies(FixedAttributes):
    """All bodies as columns. The arrays are read-only views that follow the world; copy what you keep.

    After a body has come or gone, ask for the arrays again: earlier ones are not as long, and after one has gone their
    rows may be those of others.
    """

    __slots__ = ("_layout", "_seen", "_world")

    def __init__(self, world: ViewedWorld) -> None:
        self._world = world
        self._layout = -1
        self._seen: dict[str, Any] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy is the columns of the same world; a deep or pickled one those of a copy of it."""
        return getattr, (self._world, "bodies")

    def _view(self, name: str, make: Callable[[Records, str], Any]) -> Any:
        """A view of a column, made once for each layout."""
        if self._layout != self._world.state.layout:
            self._layout, self._seen = self._world.state.layout, {}
        if name not in self._seen:
            self._seen[name] = make(self._world.state.bodies, name)
        return self._seen[name]

    @property
    def ids(self) -> tuple[str, ...]:
        """The bodies' ids, row by row."""
        return self._world.state.names

    @property
    def position(self) -> Floats:
        """(n, 2) m, the bodies' origins."""
        view: Floats = self._view("position_x", _vectors)
        return view

    @property
    def angle(self) -> Floats:
        """(n,) rad, not wrapped."""
        view: Floats = self._view("angle", _column)
        return view

    @property
    def velocity(self) -> Floats:
        """(n, 2) m/s, of the centres of mass."""
        view: Floats = self._view("velocity_x", _vectors)
        return view

    @property
    def angular_velocity(self) -> Floats:
        """(n,) rad/s."""
        view: Floats = self._view("angular_velocity", _column)
        return view

    @property
    def center(self) -> Floats:
        """(n, 2) m, the centres of mass."""
        view: Floats = self._view("center_x", _vectors)
        return view

    @property
    def mass(self) -> Floats:
        """(n,) kg; 0 for static and kinematic bodies."""
        view: Floats = self._view("mass", _column)
        return view

    @property
    def awake(self) -> Integers:
        """(n,) 1 while simulated, 0 asleep."""
        view: Integers = self._view("awake", _column)
        return view

    def __len__(self) -> int:
        return len(self._world.state.bodies)
