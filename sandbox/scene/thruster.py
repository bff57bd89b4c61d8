"""Thrusters: forces fixed to a body, with a schedule."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.flat import INFINITE, FlatThruster
from sandbox.scene.quantities import LocalPoint, Seconds

Thrust = Annotated[float, Range(-1e15, 1e15, "N")]


class Thruster(Model):
    """A force that turns with its body."""

    force: Annotated[tuple[Thrust, Thrust], Listed("[x, y]", 2, 2)] = Field(description="In the body's frame, N.")
    at: LocalPoint = Field(default=(0.0, 0.0), description="Where it pushes, in the body's frame, m.")
    start: Seconds = Field(default=0.0, description="When it begins to push, s.")
    end: Seconds | None = Field(default=None, description="When it ceases to push, s; default: never.")

    def flat(self) -> FlatThruster:
        """The thruster in SI units."""
        return FlatThruster(self.force, self.at, self.start, INFINITE if self.end is None else self.end)
