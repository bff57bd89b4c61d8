"""What all joints have: an id, the bodies they join, and what breaks them."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated, Any

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed
from sandbox.scene.flat import INFINITE, FlatJoint, Vec
from sandbox.scene.quantities import Force, Name, Point, Torque

Anchors = Annotated[tuple[Point, Point], Listed("[[x, y], [x, y]]", 2, 2)]
Bodies = Annotated[tuple[Name | None, ...], Listed('["id", "id"]; null is the world', 1, 2)]
JointIds = Annotated[tuple[Name, Name], Listed('["id", "id"]', 2, 2)]


class Joint(Model):
    """What all joints have."""

    id: Name = Field(description="A name that no other joint has.")
    break_force: Force | None = Field(default=None, description="Breaks under more than this, N; default: never.")
    break_torque: Torque | None = Field(default=None, description="Breaks under more than this, N m; default: never.")
    collide: bool = Field(default=False, description="true: the two bodies collide with each other.")
    enabled: bool = Field(default=True, description="false: has no effect until a command switches it on.")

    @abstractmethod
    def flat(self) -> FlatJoint:
        """The joint in SI units and radians."""

    def shared(self) -> dict[str, Any]:
        """The fields of a flat joint that all kinds have."""
        limits = {"break_force": self.break_force, "break_torque": self.break_torque}
        return {
            "id": self.id, "collide": self.collide, "enabled": self.enabled,
            **{name: INFINITE if value is None else value for name, value in limits.items()},
        }  # fmt: skip


class Joining(Joint):
    """A joint between two bodies, or between a body and the world."""

    bodies: Bodies = Field(description='["a", "b"]; null, or only one id, joins to the world.')

    def shared(self) -> dict[str, Any]:
        a, b = self.bodies if len(self.bodies) == 2 else (None, self.bodies[0])
        return {**super().shared(), "body_a": a, "body_b": b}


class Pinned(Joining):
    """A joint with one anchor, at the same point of the world on both bodies."""

    anchor: Point = Field(description="Where the bodies are joined, in the world, m.")

    def shared(self) -> dict[str, Any]:
        return {**super().shared(), "anchor_a": self.anchor, "anchor_b": self.anchor}


def direction(vector: Vec) -> Vec:
    """The unit vector along a vector that is not zero."""
    x, y = vector
    length = float((x * x + y * y) ** 0.5)
    return x / length, y / length
