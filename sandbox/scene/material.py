"""Surfaces: named materials and the overrides a shape may give in place."""

from __future__ import annotations

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.objects import known_as
from sandbox.scene.quantities import Bounce, Density, Distance, Ratio, Velocity


@known_as("a material")
class Material(Model):
    """What a shape is made of, under a name that bodies and shapes refer to."""

    density: Density = Field(default=1.0, description="Mass per area, kg/m^2.")
    friction: Ratio = Field(default=0.5, description="Coulomb coefficient; a pair of shapes uses sqrt(a b).")
    bumper: bool = Field(default=False, description="true: restitution may be above 1, up to 5, which adds energy.")
    restitution: Bounce = Field(
        default=0.0,
        description="Bounce: 0 none, 1 keeps its speed, above 1 (with bumper) more; a pair of shapes uses max(a, b).",
    )
    rolling_resistance: Distance = Field(
        default=0.0, description="Lever arm of the rolling friction, m; a pair uses max(a, b)."
    )
    surface_speed: Velocity = Field(
        default=0.0,
        description="Conveyor: surface speed clockwise around the shape, m/s; positive carries what is on top right.",
    )


class Surface(Model):
    """The fields of a material that a shape may override for itself."""

    density: Density | None = Field(default=None, description="Overrides the material's density, kg/m^2.")
    friction: Ratio | None = Field(default=None, description="Overrides the material's friction coefficient.")
    bumper: bool | None = Field(default=None, description="true: the restitution beside it may be above 1, up to 5.")
    restitution: Bounce | None = Field(
        default=None, description="Overrides the material's bounce, 0 to 1; up to 5 with bumper."
    )
    rolling_resistance: Distance | None = Field(
        default=None, description="Overrides the material's rolling resistance, m."
    )
    surface_speed: Velocity | None = Field(
        default=None, description="Overrides the material's surface speed (conveyor), m/s."
    )
