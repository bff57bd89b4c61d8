"""Joints between two points: the rod, spring and rope, and the rope over two wheels."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sandbox.scene.flat import INFINITE, FlatJoint
from sandbox.scene.joints.base import Anchors, Joining
from sandbox.scene.quantities import Distance as Length
from sandbox.scene.quantities import Frequency, Ratio


class DistanceJoint(Joining):
    """A rod between two points; a spring with `hertz`; a rope with `max`."""

    type: Literal["distance"] = Field(description="A rod, a spring or a rope.")
    anchors: Anchors = Field(description="Its two ends in the world [[x, y], [x, y]], m.")
    length: Length | None = Field(default=None, description="Rest length, m; default: that of the scene.")
    min: Length | None = Field(default=None, description="Least length, m; default: none.")
    max: Length | None = Field(default=None, description="Greatest length, m; default: none.")
    hertz: Frequency | None = Field(default=None, description="Stiffness as a spring, Hz; default: a rod.")
    damping_ratio: Ratio = Field(default=0.0, description="Damping of the spring; 1 is critical.")

    def flat(self) -> FlatJoint:
        """The joint in SI units."""
        return FlatJoint(
            kind="distance",
            anchor_a=self.anchors[0],
            anchor_b=self.anchors[1],
            length=self.length,
            lower=-INFINITE if self.min is None else self.min,
            upper=INFINITE if self.max is None else self.max,
            hertz=self.hertz,
            damping_ratio=self.damping_ratio,
            **self.shared(),
        )


class Pulley(Joining):
    """A rope from the first body up over two fixed wheels and down to the second."""

    type: Literal["pulley"] = Field(description="A rope over two wheels.")
    anchors: Anchors = Field(description="Where it is tied to the bodies [[x, y], [x, y]], m.")
    wheels: Anchors = Field(description="The wheels it runs over, in the world [[x, y], [x, y]], m.")
    ratio: Ratio = Field(default=1.0, description="first length + ratio times second length stays the same.")

    def flat(self) -> FlatJoint:
        """The joint in SI units."""
        return FlatJoint(
            kind="pulley",
            anchor_a=self.anchors[0],
            anchor_b=self.anchors[1],
            points=self.wheels,
            ratio=self.ratio,
            **self.shared(),
        )
