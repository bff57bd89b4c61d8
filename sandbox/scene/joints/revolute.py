"""Joints about a point: the hinge and the weld."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.flat import INFINITE, FlatJoint
from sandbox.scene.joints.base import Pinned
from sandbox.scene.quantities import Degrees, Frequency, Ratio, Torque, Turning


class Revolute(Pinned):
    """A hinge. Angles are those of the second body against the first, from the pose of the scene."""

    type: Literal["revolute"] = Field(description="A hinge.")
    lower: Degrees | None = Field(default=None, description="Least angle, degrees; default: none.")
    upper: Degrees | None = Field(default=None, description="Greatest angle, degrees; default: none.")
    motor_speed: Turning | None = Field(default=None, description="Runs a motor at this speed, degrees/s.")
    max_torque: Torque | None = Field(default=None, description="Most that the motor gives, N m; default: any.")
    hertz: Frequency | None = Field(default=None, description="Stiffness of a spring toward `rest`, Hz.")
    damping_ratio: Ratio = Field(default=0.0, description="Damping of the spring; 1 is critical.")
    rest: Degrees = Field(default=0.0, description="Where the spring pulls the angle to, degrees.")

    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""
        return FlatJoint(
            kind="revolute",
            lower=-INFINITE if self.lower is None else self.lower * RADIANS_PER_DEGREE,
            upper=INFINITE if self.upper is None else self.upper * RADIANS_PER_DEGREE,
            motor_speed=None if self.motor_speed is None else self.motor_speed * RADIANS_PER_DEGREE,
            max_motor=INFINITE if self.max_torque is None else self.max_torque,
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            rest=self.rest * RADIANS_PER_DEGREE,
            **self.shared(),
        )


class Weld(Pinned):
    """Keeps two bodies in their relative pose, rigidly or softly."""

    type: Literal["weld"] = Field(description="Keeps the pose of two bodies against each other.")
    hertz: Frequency = Field(default=0.0, description="Stiffness of the place, Hz; 0 is rigid.")
    damping_ratio: Ratio = Field(default=1.0, description="Damping of the place; 1 is critical.")
    angular_hertz: Frequency = Field(default=0.0, description="Stiffness of the angle, Hz; 0 is rigid.")
    angular_damping_ratio: Ratio = Field(default=1.0, description="Damping of the angle; 1 is critical.")

    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""
        return FlatJoint(
            kind="weld",
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            angular_hertz=self.angular_hertz,
            angular_damping_ratio=self.angular_damping_ratio,
            **self.shared(),
        )
