"""How a user sees a joint."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from sandbox.engine.commands.joint_commands import BreakJoint, JointCommand, SetJoint, SetMotor
from sandbox.errors import UnknownJointError
from sandbox.world import joint_records as kinds
from sandbox.world.build_joints import KINDS
from sandbox.world.joint_pose import anchor, angle_between, slide

if TYPE_CHECKING:
    from sandbox.engine.world import World

_NAMES = {number: name for name, number in KINDS.items()}


class Joint:
    """One joint of a world. Setting a property applies a command, so that it can be recorded and refused.

    It stays the same joint whatever else comes and goes. Once that joint has been deleted, asking for anything but its
    `id` raises `UnknownJointError`.
    """

    def __init__(self, world: World, row: int) -> None:
        self.id = world.joint_names[row]
        self._world, self._state = world, world.state
        self._serial = world.state.roster.joints.serials[row]
        self._layout, self._record = world.layout, world.state.joints[row]

    @property
    def _row(self) -> Any:
        if self._layout != self._state.layout:
            row = self._state.roster.joints.row_of(self._serial)
            if row is None:
                raise UnknownJointError(f"the joint {self.id!r} has been deleted")
            self._layout, self._record = self._state.layout, self._state.joints[row]
        return self._record

    def _apply(self, command: JointCommand) -> None:
        _ = self._row
        self._world.apply(command)

    @property
    def type(self) -> str:
        """The kind, as in the scene."""
        return _NAMES[int(self._row.kind)]

    @property
    def bodies(self) -> tuple[str | None, str | None]:
        """The ids of its bodies; None is the world. Both None for a gear."""
        names = self._state.names
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
        self._apply(SetJoint(self.id, bool(value)))

    @property
    def motor_speed(self) -> float | None:
        """Speed its motor strives for, rad/s or m/s; None while there is none."""
        return float(self._row.motor_speed) if self._row.motor else None

    @motor_speed.setter
    def motor_speed(self, value: float | None) -> None:
        self._apply(SetMotor(self.id, None if value is None else float(value)))

    def break_(self) -> None:
        """Break it for good."""
        self._apply(BreakJoint(self.id))

    def __repr__(self) -> str:
        condition = "broken" if self.broken else f"{math.hypot(*self.force):.4g} N, {self.torque:.4g} N m"
        return f"<Joint {self.id!r} {self.type}: {condition}>"
