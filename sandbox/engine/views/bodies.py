"""How a user sees the records: NumPy views of all bodies, and one body with the same names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from sandbox.engine.commands.body_commands import ApplyForce, ApplyImpulse, Command, SetPose, SetVelocity
from sandbox.errors import UnknownBodyError
from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import BODY

if TYPE_CHECKING:
    from sandbox.engine.world import World

_NAMES = {0: "static", 1: "kinematic", 2: "dynamic"}


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


class Bodies:
    """All bodies as columns. The arrays are read-only views that follow the world; copy what you keep.

    After a body has come or gone, ask for the arrays again: earlier ones no longer change.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._layout = -1
        self._seen: dict[str, Any] = {}

    def _view(self, name: str, make: Callable[[Records, str], Any]) -> Any:
        """A view of a column, made once for each layout."""
        if self._layout != self._world.layout:
            self._layout, self._seen = self._world.layout, {}
        if name not in self._seen:
            self._seen[name] = make(self._world.state.bodies, name)
        return self._seen[name]

    @property
    def ids(self) -> tuple[str, ...]:
        """The bodies' ids, row by row."""
        return self._world.names

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
        return len(self.ids)


class Body:
    """One body of a world. Setting a property applies a command, so that it can be recorded and refused.

    It stays the same body whatever else comes and goes. Once that body has been deleted, asking for anything but its
    `id` raises `UnknownBodyError`, even if another one has its id.
    """

    def __init__(self, world: World, row: int) -> None:
        self.id = world.names[row]
        self._world = world
        self._serial = world.state.roster.bodies.serials[row]
        self._layout, self._row = world.layout, world.state.bodies[row]

    @property
    def _record(self) -> Any:
        if self._layout != self._world.layout:
            row = self._world.state.roster.bodies.row_of(self._serial)
            if row is None:
                raise UnknownBodyError(f"the body {self.id!r} has been deleted")
            self._layout, self._row = self._world.layout, self._world.state.bodies[row]
        return self._row

    def _apply(self, command: Command) -> None:
        _ = self._record
        self._world.apply(command)

    @property
    def type(self) -> str:
        """`static`, `kinematic` or `dynamic`; a frozen body is static."""
        return _NAMES[int(self._record.type)]

    @property
    def position(self) -> tuple[float, float]:
        """Origin in metres."""
        return float(self._record.position_x), float(self._record.position_y)

    @position.setter
    def position(self, value: tuple[float, float]) -> None:
        self._apply(SetPose(self.id, _pair(value), self.angle))

    @property
    def angle(self) -> float:
        """Radians turned so far, not wrapped."""
        return float(self._record.angle)

    @angle.setter
    def angle(self, value: float) -> None:
        self._apply(SetPose(self.id, self.position, float(value)))

    @property
    def velocity(self) -> tuple[float, float]:
        """Of the centre of mass, m/s."""
        return float(self._record.velocity_x), float(self._record.velocity_y)

    @velocity.setter
    def velocity(self, value: tuple[float, float]) -> None:
        self._apply(SetVelocity(self.id, _pair(value), self.angular_velocity))

    @property
    def angular_velocity(self) -> float:
        """Radians a second, counter-clockwise."""
        return float(self._record.angular_velocity)

    @angular_velocity.setter
    def angular_velocity(self, value: float) -> None:
        self._apply(SetVelocity(self.id, self.velocity, float(value)))

    def apply_force(
        self, force: tuple[float, float], torque: float = 0.0, point: tuple[float, float] | None = None
    ) -> None:
        """Push during the next step: N and N m, at a `point` of the world (m) or at the centre of mass."""
        self._apply(ApplyForce(self.id, _pair(force), float(torque), _pair(point) if point else None))

    def apply_impulse(
        self, impulse: tuple[float, float], angular_impulse: float = 0.0, point: tuple[float, float] | None = None
    ) -> None:
        """Strike at once: N s and N m s, at a `point` of the world (m) or at the centre of mass."""
        self._apply(ApplyImpulse(self.id, _pair(impulse), float(angular_impulse), _pair(point) if point else None))

    @property
    def center(self) -> tuple[float, float]:
        """Centre of mass in metres."""
        return float(self._record.center_x), float(self._record.center_y)

    @property
    def mass(self) -> float:
        """Kilograms; 0 for static and kinematic bodies."""
        return float(self._record.mass)

    @property
    def inertia(self) -> float:
        """kg m^2 about the centre of mass; 0 where the body cannot turn."""
        return float(self._record.inertia)

    @property
    def awake(self) -> bool:
        """Whether the body is simulated."""
        return bool(self._record.awake)

    def __repr__(self) -> str:
        x, y = self.position
        return f"<Body {self.id!r} {self.type} at ({x:.4g}, {y:.4g}) m, {self.angle:.4g} rad>"


def _pair(value: tuple[float, float]) -> tuple[float, float]:
    x, y = value
    return float(x), float(y)
