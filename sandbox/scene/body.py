"""Bodies and the prefabs that many bodies can share."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed
from sandbox.scene.limits import MAX_SHAPES, MAX_THRUSTERS
from sandbox.scene.objects import known_as
from sandbox.scene.play.path import BodyPath
from sandbox.scene.quantities import (
    Color,
    Damping,
    Degrees,
    Factor,
    Inertia,
    LocalPoint,
    Mass,
    Name,
    Number,
    Point,
    Speed,
    Turning,
    Velocity2,
)
from sandbox.scene.shapes import Shape
from sandbox.scene.thruster import Thruster

Shapes = Annotated[tuple[Shape, ...], Listed("of shapes", 1, MAX_SHAPES)]


class BodyFields(Model):
    """What a body has beside its id and place, and what a prefab of one body gives."""

    type: Literal["static", "kinematic", "dynamic"] = Field(
        default="dynamic",
        description="static never moves, kinematic keeps its velocity whatever it hits, dynamic is pushed.",
    )
    shapes: Shapes = Field(default=(), description="One or more shapes.")
    angle: Degrees = Field(default=0.0, description="Degrees, counter-clockwise.")
    velocity: Velocity2 = Field(default=(0.0, 0.0), description="Of the centre of mass at the start, m/s.")
    angular_velocity: Turning = Field(default=0.0, description="At the start, degrees/s, counter-clockwise.")
    linear_damping: Damping = Field(default=0.0, description="v' = -damping v, 1/s.")
    angular_damping: Damping = Field(default=0.0, description="w' = -damping w, 1/s.")
    gravity_scale: Factor = Field(default=1.0, description="Multiplies the scene's gravity.")
    sleep_speed: Speed = Field(
        default=0.05, description="It may sleep while no point of it moves faster, m/s; 0: it never sleeps."
    )
    fixed_rotation: bool = Field(default=False, description="true: the body never turns.")
    bullet: bool = Field(
        default=False, description="true: however fast, the body does not pass through moving bodies either."
    )
    mass: Mass | None = Field(default=None, description="Overrides the mass of the shapes, kg.")
    inertia: Inertia | None = Field(
        default=None,
        description="Overrides the inertia about the centre of mass, kg m^2; default: scaled with mass.",
    )
    center: LocalPoint | None = Field(default=None, description="Overrides the centre of mass, in the body's frame, m.")
    thrusters: Annotated[tuple[Thruster, ...], Listed("of thrusters", 0, MAX_THRUSTERS)] = Field(
        default=(), description="Forces fixed to the body, with a schedule."
    )
    path: BodyPath | None = Field(default=None, description="Where a kinematic body goes, and when.")
    material: Name | None = Field(default=None, description="Material of all shapes that do not name their own.")
    color: Color | None = Field(default=None, description='As "#3a7bd5" or "tomato"; default: chosen by the theme.')


class Placed(Model):
    """Which body it is, and where."""

    id: Name = Field(description="Unique name: letters, digits and _ - . :")
    prefab: Name | None = Field(
        default=None, description="Name of a prefab; fields given here win over the prefab's fields."
    )
    position: Point = Field(default=(0.0, 0.0), description="Of the body's origin, m.")
    params: dict[Name, Number] = Field(default={}, description="Parameters of the prefab, by name.")


@known_as("a body")
class Body(BodyFields, Placed):
    """One body."""

    def __eq__(self, other: object) -> bool:
        # A field given with its default value wins over a prefab, so what was given is part of a body.
        return isinstance(other, Body) and self.given() == other.given()

    def __hash__(self) -> int:
        return hash(self.id)
