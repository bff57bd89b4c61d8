"""How a user sees a joint."""

from __future__ import annotations

import math
from typing import Any

from sandbox._plain_rows import plain_rows
from sandbox.arguments import shown
from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import DeleteJoint
from sandbox.engine.commands.joint_parts import BreakJoint, SetLimits, SetMotor, SetTarget
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.views.base import ViewedWorld
from sandbox.errors import CommandError, UnknownJointError
from sandbox.tables import plain
from sandbox.world import joint_records as kinds
from sandbox.world.joint_pose import anchor, angle_between, slide


class JointView(FixedAttributes):
    """One joint of a world. Setting a property applies a command, so that it can be recorded and refused.

    It stays the same joint whatever else comes and goes. Once that joint has been deleted, asking for anything but its
    `id` raises `UnknownJointError`.
    """

    __slots__ = ("_layout", "_record", "_serial", "_state", "_world", "id")

    def __init__(self, world: ViewedWorld, row: int) -> None:
        self.id = world.state.census.joints.names[row]
        self._world, self._state = world, world.state
        self._serial = world.state.census.joints.serials[row]
        self._layout, self._record = world.state.layout, plain_rows(plain(world.state.joints))[row]

    @classmethod
    def _again(cls, world: ViewedWorld, name: str, serial: int) -> JointView:
        """A view of the joint of that serial number, which may have been deleted."""
        view = cls.__new__(cls)
        view.id, view._world, view._state, view._serial, view._layout = name, world, world.state, serial, -1
        return view

    def __reduce__(self) -> tuple[Any, ...]:
        """A copied view looks at the same world; a deep or pickled copy at a copy of it."""
        return JointView._again, (self._world, self.id, self._serial)

    @property
    def _row(self) -> Any:
        if self._layout != self._state.layout:
            row = self._state.census.joints.row_of(self._serial)
            if row is None:
                raise UnknownJointError(f"the joint {self.id!r} has been deleted")
            self._layout, self._record = self._state.layout, plain_rows(plain(self._state.joints))[row]
        return self._record

    def _apply(self, command: Command) -> None:
        _ = self._row
        self._world.apply(command)

    @property
    def type(self) -> str:
        """The kind, as in the scene."""
        return kinds.KINDS[int(self._row.kind)]

    @property
    def bodies(self) -> tuple[str | None, str | None]:
        """The ids of its bodies; None is the world. Both None for a gear."""
        names = self._state.census.bodies.names
        a, b = (None if i < 0 else names[i] for i in (self._row.body_a, self._row.body_b))
        return a, b

    @property
    def force(self) -> tuple[float, float]:
        """Force on the second body, N: mean over the last step. Of a gear: on that of its first joint."""
        return float(self._row.force_x), float(self._row.force_y)

    @property
    def torque(self) -> float:
        """Torque on the second body about its anchor, N m: mean over the last step. Of a gear: as with `force`."""
        return float(self._row.torque)

    @property
    def anchors(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Where its anchors are in the world, m."""
        return anchor(self._state, self._row, "a"), anchor(self._state, self._row, "b")

    @property
    def angle(self) -> float:
        """Angle of the second body against the first since the scene began, rad."""
        return angle_between(self._state, self._row)

    @property
    def translation(self) -> float:
        """Slide along the axis (prismatic, wheel), else the distance of the anchors, m."""
        if int(self._row.kind) in (kinds.PRISMATIC, kinds.WHEEL):
            return slide(self._state, self._row)
        (ax, ay), (bx, by) = self.anchors
        return math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))

    @property
    def broken(self) -> bool:
        """Whether it broke."""
        return int(self._row.broken_step) >= 0

    @property
    def broken_step(self) -> int | None:
        """The step at which it broke; None while it holds."""
        return int(self._row.broken_step) if self.broken else None

    @property
    def enabled(self) -> bool:
        """Whether it is switched on."""
        return bool(self._row.enabled)

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._apply(SetJoint(self.id, value))

    @property
    def motor_speed(self) -> float | None:
        """Speed its motor strives for, rad/s or m/s; None while there is none."""
        return float(self._row.motor_speed) if self._row.motor else None

    @motor_speed.setter
    def motor_speed(self, value: float | None) -> None:
        self._apply(SetMotor(self.id, value))

    @property
    def limits(self) -> tuple[float | None, float | None]:
        """(lower, upper), rad or m; None on a side where there is none."""
        ends = (float(self._row.lower), float(self._row.upper))
        lower, upper = (end if self._row.limit and math.isfinite(end) else None for end in ends)
        return lower, upper

    @limits.setter
    def limits(self, value: tuple[float | None, float | None]) -> None:
        try:
            lower, upper = value
        except (TypeError, ValueError):
            raise CommandError(f"SetLimits of {self.id!r}: takes a pair (lower, upper), not {shown(value)}") from None
        self._apply(SetLimits(self.id, lower, upper))

    @property
    def target(self) -> tuple[float, float] | None:
        """Where a target joint pulls to, in the world (m); None for other kinds."""
        if int(self._row.kind) != kinds.TARGET:
            return None
        return float(self._row.point_ax), float(self._row.point_ay)

    @target.setter
    def target(self, value: tuple[float, float]) -> None:
        self._apply(SetTarget(self.id, value))

    def set(self, **settings: Any) -> None:
        """Change settings by their names in a scene file; angles in radians. Takes the fields of `SetJoint`."""
        try:
            command = SetJoint(self.id, **settings)
        except TypeError:
            strays = [name for name in settings if name not in SetJoint.__dataclass_fields__ or name == "joint"]
            raise CommandError(f"SetJoint of {self.id!r}: there is no setting {strays[0]!r}") from None
        self._apply(command)

    def delete(self) -> None:
        """Take it out of the world, with the gears on it."""
        self._apply(DeleteJoint(self.id))

    def break_(self) -> None:
        """Break it for good."""
        self._apply(BreakJoint(self.id))

    def __repr__(self) -> str:
        try:
            broken = self.broken
        except UnknownJointError:
            return f"<Joint {self.id!r}, deleted>"
        condition = "broken" if broken else f"{math.hypot(*self.force):.4g} N, {self.torque:.4g} N m"
        return f"<Joint {self.id!r} {self.type}: {condition}>"
