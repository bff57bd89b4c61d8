"""How a user sees one body."""

from __future__ import annotations

from typing import Any

from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.motion import SetPose, SetVelocity
from sandbox.engine.commands.pushes import ApplyForce, ApplyImpulse
from sandbox.engine.commands.set_surface import SetSurface
from sandbox.engine.views.base import ViewedWorld
from sandbox.errors import UnknownBodyError
from sandbox.geometry.shapes import Shape
from sandbox.tables import FloatWords, WholeWords
from sandbox.world.body_shapes import body_shapes
from sandbox.world.records import BodyPlace as At

_NAMES = {0: "static", 1: "kinematic", 2: "dynamic"}


class BodyView(FixedAttributes):
    """One body of a world, with the names of the columns.

    Setting a property applies a command, so that it can be recorded and refused. It stays the same body whatever else
    comes and goes. Once that body has been deleted, asking for anything but its `id` raises `UnknownBodyError`, even
    if another one has its id.
    """

    __slots__ = ("_floats", "_layout", "_serial", "_wholes", "_world", "id")

    def __init__(self, world: ViewedWorld, row: int) -> None:
        self.id = world.state.census.bodies.names[row]
        self._world = world
        self._serial = world.state.census.bodies.serials[row]
        self._layout = -1

    @classmethod
    def _again(cls, world: ViewedWorld, name: str, serial: int) -> BodyView:
        """A view of the body of that serial number, which may have been deleted."""
        view = cls.__new__(cls)
        view.id, view._world, view._serial, view._layout = name, world, serial, -1
        return view

    def __reduce__(self) -> tuple[Any, ...]:
        """A copied view looks at the same world; a deep or pickled copy at a copy of it."""
        return BodyView._again, (self._world, self.id, self._serial)

    @property
    def _numbers(self) -> FloatWords:
        """Its row as floats, by `BodyPlace`."""
        if self._layout != self._world.state.layout:
            self._find()
        return self._floats

    @property
    def _flags(self) -> WholeWords:
        """Its row as whole numbers."""
        if self._layout != self._world.state.layout:
            self._find()
        return self._wholes

    def _find(self) -> None:
        """Look up its row, which may be another one since bodies have come or gone."""
        state = self._world.state
        self._floats, self._wholes = state.body_words(self._index)
        self._layout = state.layout

    @property
    def _index(self) -> int:
        row = self._world.state.census.bodies.row_of(self._serial)
        if row is None:
            raise UnknownBodyError(f"the body {self.id!r} has been deleted")
        return row

    def _apply(self, command: Command) -> None:
        _ = self._flags
        self._world.apply(command)

    @property
    def type(self) -> str:
        """`static`, `kinematic` or `dynamic`; a frozen body is static."""
        return _NAMES[self._flags[At.TYPE]]

    @property
    def position(self) -> tuple[float, float]:
        """Origin in metres."""
        row = self._numbers
        return row[At.POSITION_X], row[At.POSITION_Y]

    @position.setter
    def position(self, value: tuple[float, float]) -> None:
        self._apply(SetPose(self.id, value, self.angle))

    @property
    def angle(self) -> float:
        """Radians turned so far, not wrapped."""
        return self._numbers[At.ANGLE]

    @angle.setter
    def angle(self, value: float) -> None:
        self._apply(SetPose(self.id, self.position, value))

    @property
    def velocity(self) -> tuple[float, float]:
        """Of the centre of mass, m/s."""
        row = self._numbers
        return row[At.VELOCITY_X], row[At.VELOCITY_Y]

    @velocity.setter
    def velocity(self, value: tuple[float, float]) -> None:
        self._apply(SetVelocity(self.id, value, self.angular_velocity))

    @property
    def angular_velocity(self) -> float:
        """Radians a second, counter-clockwise."""
        return self._numbers[At.ANGULAR_VELOCITY]

    @angular_velocity.setter
    def angular_velocity(self, value: float) -> None:
        self._apply(SetVelocity(self.id, self.velocity, value))

    def apply_force(
        self, force: tuple[float, float], torque: float = 0.0, point: tuple[float, float] | None = None
    ) -> None:
        """Push during the next step: N and N m, at a `point` of the world (m) or at the centre of mass."""
        self._apply(ApplyForce(self.id, force, torque, point))

    def apply_impulse(
        self, impulse: tuple[float, float], angular_impulse: float = 0.0, point: tuple[float, float] | None = None
    ) -> None:
        """Strike at once: N s and N m s, at a `point` of the world (m) or at the centre of mass."""
        self._apply(ApplyImpulse(self.id, impulse, angular_impulse, point))

    def set_surface(
        self,
        friction: float | None = None,
        restitution: float | None = None,
        rolling_resistance: float | None = None,
        surface_speed: float | None = None,
        shape: int | None = None,
        bumper: bool | None = None,
    ) -> None:
        """Change what its shapes, or the one of that number, are made of: `SetSurface`; for densities apply that."""
        self._apply(SetSurface(self.id, friction, restitution, rolling_resistance, surface_speed, shape, bumper=bumper))

    def delete(self) -> None:
        """Take it out of the world, with the joints that hold it."""
        self._apply(Delete(self.id))

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Its shapes where they are now, in the order of the scene: what `sandbox.collide` and queries take.

        Raises `ShapeError` where a shape is too small to be told apart so far from the origin.
        """
        return body_shapes(self._world.state, self._index)

    @property
    def center(self) -> tuple[float, float]:
        """Centre of mass in metres."""
        row = self._numbers
        return row[At.CENTER_X], row[At.CENTER_Y]

    @property
    def mass(self) -> float:
        """Kilograms; 0 for static and kinematic bodies."""
        return self._numbers[At.MASS]

    @property
    def inertia(self) -> float:
        """kg m^2 about the centre of mass; 0 where the body cannot turn."""
        return self._numbers[At.INERTIA]

    @property
    def awake(self) -> bool:
        """Whether the body is simulated."""
        return bool(self._flags[At.AWAKE])

    def __repr__(self) -> str:
        try:
            x, y = self.position
        except UnknownBodyError:
            return f"<Body {self.id!r}, deleted>"
        return f"<Body {self.id!r} {self.type} at ({x:.4g}, {y:.4g}) m, {self.angle:.4g} rad>"
