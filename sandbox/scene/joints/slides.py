"""Joints along an axis: the slide and the wheel on its suspension."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.flat import INFINITE, FlatJoint, Vec
from sandbox.scene.joints.base import Pinned, direction
from sandbox.scene.quantities import Force, Frequency, LocalPoint, Ratio, Torque, Turning, Velocity
from sandbox.scene.quantities import Local as Slide


def _check_axis(axis: Vec) -> Vec:
    if max(abs(axis[0]), abs(axis[1])) < 1e-6:
        raise PydanticCustomError("axis", "must point somewhere: [0, 0] has no direction")
    return axis


Axis = Annotated[LocalPoint, AfterValidator(_check_axis)]


class Sliding(Pinned):
    """What slides along an axis that is fixed in the first body."""

    lower: Slide | None = Field(default=None, description="Least slide along the axis, m; default: none.")
    upper: Slide | None = Field(default=None, description="Greatest slide along the axis, m; default: none.")

    def limits(self) -> dict[str, Any]:
        """The limits of a flat joint."""
        return {
            "lower": -INFINITE if self.lower is None else self.lower,
            "upper": INFINITE if self.upper is None else self.upper,
        }


class Prismatic(Sliding):
    """A slide: the second body moves along an axis of the first and does not turn against it."""

    type: Literal["prismatic"] = Field(description="A slide.")
    axis: Axis = Field(description="Direction of the slide in the world [x, y].")
    motor_speed: Velocity | None = Field(default=None, description="Runs a motor at this speed, m/s.")
    max_force: Force | None = Field(default=None, description="Most that the motor gives, N; default: any.")
    hertz: Frequency | None = Field(default=None, description="Stiffness of a spring toward `rest`, Hz.")
    damping_ratio: Ratio = Field(default=0.0, description="Damping of the spring; 1 is critical.")
    rest: Slide = Field(default=0.0, description="Where the spring pulls the slide to, m.")

    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""
        return FlatJoint(
            kind="prismatic",
            axis=direction(self.axis),
            motor_speed=self.motor_speed,
            max_motor=INFINITE if self.max_force is None else self.max_force,
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            rest=self.rest,
            **self.limits(),
            **self.shared(),
        )


class Wheel(Sliding):
    """A wheel: the second body turns freely, and is sprung along an axis of the first."""

    type: Literal["wheel"] = Field(description="A wheel on a suspension.")
    axis: Axis = Field(default=(0.0, 1.0), description="Direction of the suspension in the world [x, y].")
    hertz: Frequency | None = Field(default=3.0, description="Stiffness of the suspension, Hz; null: none.")
    damping_ratio: Ratio = Field(default=0.7, description="Damping of the suspension; 1 is critical.")
    rest: Slide = Field(default=0.0, description="Where the suspension pulls the slide to, m.")
    motor_speed: Turning | None = Field(default=None, description="Runs a motor at this speed, degrees/s.")
    max_torque: Torque | None = Field(default=None, description="Most that the motor gives, N m; default: any.")

    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""
        return FlatJoint(
            kind="wheel",
            axis=direction(self.axis),
            motor_speed=None if self.motor_speed is None else self.motor_speed * RADIANS_PER_DEGREE,
            max_motor=INFINITE if self.max_torque is None else self.max_torque,
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            rest=self.rest,
            **self.limits(),
            **self.shared(),
        )
