"""The command that changes what the shapes of a body are made of."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from sandbox.engine.commands.base import CommandTarget, Touched
from sandbox.engine.commands.body_command import BodyCommand
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError, SceneError
from sandbox.tables import plain
from sandbox.world.records import SURFACE
from sandbox.world.reweigh import reweigh
from sandbox.world.shape_rows import first_shape
from sandbox.world.state import State

_WRITTEN = tuple(name for name in SURFACE if name != "density")
"""Columns that take a new value as it is; a density weighs the body anew."""


@dataclass(frozen=True)
class SetSurface(BodyCommand):
    """Change the surface of a body's shapes; what is None stays as it is.

    `friction` and `restitution` are coefficients, `rolling_resistance` is in m, `surface_speed` in m/s, within the
    limits of scene files; above 1, up to 5, `restitution` needs `bumper=True` beside it. `shape` is the number of one
    of the body's shapes, from 0; None means all of them. A new `density` (kg/m^2) changes mass, inertia and centre of
    mass, as far as the scene does not give those itself; every point of the body goes on as it moved.
    """

    friction: float | None = None
    restitution: float | None = None
    rolling_resistance: float | None = None
    surface_speed: float | None = None
    shape: int | None = None
    density: float | None = None
    bumper: bool | None = None

    @property
    def outdates_events(self) -> bool:
        """Their places are measured from centres of mass, which a density may move."""
        return self.density is not None

    def apply(self, target: CommandTarget) -> Touched:
        """Change the body; by a density all that is known of masses changes."""
        return replace(super().apply(target), everybody=self.density is not None)

    def change(self, state: State, row: int) -> None:
        """Write the new surface. Raises `CommandError`, and changes nothing, for values that no scene may have."""
        all_rows = rows = range(first_shape(state.shapes, row), first_shape(state.shapes, row + 1))
        if self.shape is not None:
            if not 0 <= self.shape < len(rows):
                raise CommandError(f"{title(self)}: the body has no shape {self.shape}, but {len(rows)}")
            rows = rows[self.shape : self.shape + 1]
        given = {name: value for name in _WRITTEN if (value := getattr(self, name)) is not None}
        allowing = {name: value for name in ("density", "bumper") if (value := getattr(self, name)) is not None}
        _check(self, given | allowing)
        if self.density is not None:
            _weigh(state, row, all_rows, self)
        for name, value in given.items():
            plain(state.shapes)[name][rows.start : rows.stop] = value


def _check(command: SetSurface, given: dict[str, Any]) -> None:
    from sandbox.scene.material import Material

    try:
        Material(**given)
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None


def _weigh(state: State, row: int, rows: range, command: SetSurface) -> None:
    densities = plain(state.shapes)["density"][rows.start : rows.stop].tolist()
    for k in range(len(rows)) if command.shape is None else (command.shape,):
        densities[k] = command.density
    fault = reweigh(state, row, rows.start, densities)
    if fault is not None:
        raise CommandError(f"{title(command)}: {fault}")
