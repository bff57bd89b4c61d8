"""Actions that set fields, as the commands that do so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.commands.set_path import SetPath
from sandbox.engine.commands.set_region import SetRegion
from sandbox.engine.commands.set_surface import SetSurface
from sandbox.engine.commands.set_thruster import SetThruster

_DRIVEN = ("motor_speed", "surface_speed", "force")
"""What the value of a control multiplies."""


def setting_commands(what: str, names: Sequence[str], values: Mapping[str, Any], scale: float) -> Iterator[Command]:
    """A command for each of the bodies, joints or regions called `names`; angles are degrees, as in a file."""
    given = {name: _scaled(value, scale) if name in _DRIVEN else value for name, value in values.items()}
    for name in names:
        match what:
            case "surface":
                yield SetSurface(name, **given)
            case "thruster":
                yield SetThruster(name, **given)
            case "joint":
                yield SetJoint(name, **given, radians=False)
            case "region":
                yield SetRegion(name, **given)
            case _:
                yield SetPath(name, **given)


def _scaled(value: Any, scale: float) -> Any:
    return tuple(scale * part for part in value) if isinstance(value, tuple) else scale * value
