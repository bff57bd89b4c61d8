"""Actions that give fields of what is there other values: surfaces, thrusters, joints, regions, paths."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.body_refs import Ids
from sandbox.scene.constraints import Range
from sandbox.scene.flat_rules import FlatAction, FlatSetting
from sandbox.scene.limits import MAX_SHAPES, MAX_THRUSTERS
from sandbox.scene.material import Surface
from sandbox.scene.play.actions import Action, Push2, names
from sandbox.scene.play.places import Place
from sandbox.scene.quantities import (
    Acceleration2,
    Coordinate,
    Damping,
    Degrees,
    Density,
    Displacement,
    Distance,
    Factor,
    Force,
    Frequency,
    Ratio,
    Seconds,
    Torque,
    Velocity2,
)
from sandbox.scene.regions import Strength

_DRIVE = Annotated[float, Range(-1e6, 1e6)]


def _given(model: Model, leave: set[str]) -> tuple[tuple[str, Any], ...]:
    """The fields that are there, in alphabetical order."""
    found = {name: value for name, value in model.given().items() if name not in leave and value is not None}
    return tuple(sorted(found.items()))


class SetBodySurface(Action):
    """Changes what bodies are made of."""

    surface: Surface = Field(description="The fields of a material that change.")
    of: Ids = Field(description="Which bodies.")
    shape: Annotated[int, Range(0, MAX_SHAPES)] | None = Field(
        default=None, description="Number of a shape of the body, from 0; default: all."
    )

    def flat(self) -> FlatAction:
        shape = () if self.shape is None else (("shape", self.shape),)
        return FlatSetting(names(self.of), "surface", (*_given(self.surface, set()), *shape))


class SwitchThruster(Action):
    """Switches thrusters, or turns them to another force."""

    thruster: bool = Field(description="true: on, false: off.")
    of: Ids = Field(description="Which bodies.")
    thrust: Push2 | None = Field(default=None, description="Its force [x, y] in the body's frame, N.")
    number: Annotated[int, Range(0, MAX_THRUSTERS)] | None = Field(
        default=None, description="Number of a thruster of the body, from 0; default: all."
    )

    def flat(self) -> FlatAction:
        given = (("enabled", self.thruster), ("force", self.thrust), ("thruster", self.number))
        return FlatSetting(names(self.of), "thruster", tuple(pair for pair in given if pair[1] is not None))


class ChangeJoint(Action):
    """Changes settings of joints, or switches them."""

    joint: Ids = Field(description="Which joints.")
    enabled: bool | None = Field(default=None, description="true: on, false: off.")
    motor_speed: _DRIVE | None = Field(default=None, description="Of its motor, degrees/s or m/s.")
    max_force: Force | None = Field(default=None, description="Most force, N.")
    max_torque: Torque | None = Field(default=None, description="Most torque, N m.")
    lower: _DRIVE | None = Field(default=None, description="Least angle or slide, degrees or m.")
    upper: _DRIVE | None = Field(default=None, description="Greatest angle or slide, degrees or m.")
    min: Distance | None = Field(default=None, description="Least length, m.")
    max: Distance | None = Field(default=None, description="Greatest length, m.")
    length: Distance | None = Field(default=None, description="Length of a rod or spring, m.")
    rest: _DRIVE | None = Field(default=None, description="Where a spring pulls to, degrees or m.")
    hertz: Frequency | None = Field(default=None, description="Stiffness, Hz.")
    damping_ratio: Ratio | None = Field(default=None, description="1 is critical.")
    offset: Displacement | None = Field(default=None, description="Where a motor drives its anchor to, m.")
    angle: Degrees | None = Field(default=None, description="Where a motor drives its angle to, degrees.")
    target: Place | None = Field(default=None, description="Of a target joint: [x, y], m, a body or an @ name.")

    def flat(self) -> FlatAction:
        return FlatSetting(names(self.joint), "joint", _given(self, {"joint"}))


class RegionFields(Model):
    """What of a region can be changed."""

    water: Density | None = Field(default=None, description="Density of water, kg/m^2.")
    surface: Coordinate | None = Field(default=None, description="Height of its surface, m.")
    flow: Velocity2 | None = Field(default=None, description="Velocity of the water [x, y], m/s.")
    drag: Damping | None = Field(default=None, description="Of water (1/s) or wind.")
    gravity: Acceleration2 | None = Field(default=None, description="[x, y], m/s^2.")
    gravity_scale: Factor | None = Field(default=None, description="Multiplies gravity.")
    attraction: Strength | None = Field(default=None, description="Acceleration at 1 m, m/s^2.")
    at: Displacement | None = Field(default=None, description="Where it attracts to, m.")
    wind: Velocity2 | None = Field(default=None, description="Velocity of the air [x, y], m/s.")


class ChangeRegion(Action):
    """Switches regions, or changes them."""

    region: Ids = Field(description="Which regions.")
    enabled: bool | None = Field(default=None, description="true: on, false: off, from now on.")
    set: RegionFields | None = Field(default=None, description="Fields of the region that change.")

    def flat(self) -> FlatAction:
        given = _given(self.set, set()) if self.set else ()
        switch = () if self.enabled is None else (("enabled", self.enabled),)
        return FlatSetting(names(self.region), "region", (*given, *switch))


class RunPath(Action):
    """Lets bodies go on along their paths, or stop; or puts them to another time of it."""

    path: Ids = Field(description="Which bodies.")
    enabled: bool | None = Field(default=None, description="true: goes on, false: stops.")
    time: Seconds | None = Field(default=None, description="Begins at this time of the path, s.")

    def flat(self) -> FlatAction:
        given = (("enabled", self.enabled), ("time", self.time))
        return FlatSetting(names(self.path), "path", tuple(pair for pair in given if pair[1] is not None))
