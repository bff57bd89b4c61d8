"""The gear: couples two joints."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sandbox.scene.constraints import Range
from sandbox.scene.flat import FlatJoint
from sandbox.scene.joints.base import Joint, JointIds

Gearing = Annotated[float, Range(-1e6, 1e6)]


class Gear(Joint):
    """Keeps the first joint's angle or slide plus `ratio` times the second one's at the same value."""

    type: Literal["gear"] = Field(description="Couples two joints.")
    joints: JointIds = Field(description="Two revolute, wheel or prismatic joints by their ids.")
    ratio: Gearing = Field(default=1.0, description="Weight of the second joint; slides in m, angles in radians.")

    def flat(self) -> FlatJoint:
        """The joint in SI units."""
        return FlatJoint(kind="gear", body_a=None, body_b=None, joints=self.joints, ratio=self.ratio, **self.shared())
