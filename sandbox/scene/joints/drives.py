"""Joints of limited force: they drive a pose, pull to a point, or rub."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.flat import INFINITE, FlatJoint
from sandbox.scene.joints.base import Pinned
from sandbox.scene.quantities import Degrees, Displacement, Force, Frequency, Point, Ratio, Torque


class Motor(Pinned):
    """Drives the second body to a pose against the first, with limited force and torque."""

    type: Literal["motor"] = Field(description="Drives a pose with limited force.")
    offset: Displacement = Field(
        default=(0.0, 0.0), description="Where the anchor of the second body is driven to, from where it starts, m."
    )
    angle: Degrees = Field(default=0.0, description="Angle it is driven to, from the angle it starts with, degrees.")
    hertz: Frequency = Field(default=5.0, description="Stiffness of the place, Hz; 0 is rigid.")
    damping_ratio: Ratio = Field(default=1.0, description="Damping of the place; 1 is critical.")
    angular_hertz: Frequency = Field(default=5.0, description="Stiffness of the angle, Hz; 0 is rigid.")
    angular_damping_ratio: Ratio = Field(default=1.0, description="Damping of the angle; 1 is critical.")
    max_force: Force | None = Field(default=None, description="Most force, N; default: any.")
    max_torque: Torque | None = Field(default=None, description="Most torque, N m; default: any.")

    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""
        x, y = self.anchor
        return FlatJoint(
            kind="motor",
            points=((x + self.offset[0], y + self.offset[1]),),
            angle=self.angle * RADIANS_PER_DEGREE,
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            angular_hertz=self.angular_hertz,
            angular_damping_ratio=self.angular_damping_ratio,
            max_force=INFINITE if self.max_force is None else self.max_force,
            max_torque=INFINITE if self.max_torque is None else self.max_torque,
            **self.shared(),
        )


class Target(Pinned):
    """Pulls a point of a body softly to a point of the world, as the mouse does."""

    type: Literal["target"] = Field(description="Pulls a point of one body to a point of the world.")
    target: Point = Field(description="Where to, m.")
    hertz: Frequency = Field(default=5.0, description="Stiffness, Hz; 0 is rigid.")
    damping_ratio: Ratio = Field(default=0.7, description="1 is critical.")
    max_force: Force | None = Field(default=None, description="Most force, N; default: any.")

    def flat(self) -> FlatJoint:
        """The joint in SI units."""
        return FlatJoint(
            kind="target",
            points=(self.target,),
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            max_force=INFINITE if self.max_force is None else self.max_force,
            **self.shared(),
        )


class Friction(Pinned):
    """Rubs two bodies against each other at a point, as the ground does in a view from above."""

    type: Literal["friction"] = Field(description="Rubs, with limited force and torque.")
    max_force: Force = Field(description="Friction against sliding, N.")
    max_torque: Torque = Field(default=0.0, description="Friction against turning, N m.")

    def flat(self) -> FlatJoint:
        """The joint in SI units."""
        return FlatJoint(kind="friction", max_force=self.max_force, max_torque=self.max_torque, **self.shared())
