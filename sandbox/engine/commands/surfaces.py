"""The command that changes what the shapes of a body are made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sandbox.errors import CommandError, SceneError
from sandbox.tables import Integers
from sandbox.world.reweigh import reweigh

if TYPE_CHECKING:
    from sandbox.world.state import State

_FIELDS = ("friction", "restitution", "rolling_resistance", "surface_speed")


@dataclass(frozen=True)
class SetSurface:
    """Change the surface of a body's shapes; what is None stays as it is.

    `friction` and `restitution` are coefficients, `rolling_resistance` is in m, `surface_speed` in m/s, within the
    limits of scene files. `shape` is the number of one of the body's shapes, from 0; None means all of them. A new
    `density` (kg/m^2) changes mass, inertia and centre of mass, as far as the scene does not give those itself; every
    point of the body goes on as it moved.
    """

    body: str
    friction: float | None = None
    restitution: float | None = None
    rolling_resistance: float | None = None
    surface_speed: float | None = None
    shape: int | None = None
    density: float | None = None


def set_surface(state: State, index: int, command: SetSurface) -> None:
    """Write the new surface. Raises `CommandError`, and changes nothing, for values that no scene may have."""
    rows = np.flatnonzero(np.asarray(state.shapes.body) == index)
    if command.shape is not None:
        if not 0 <= command.shape < len(rows):
            raise CommandError(
                f"SetSurface of {command.body!r}: the body has no shape {command.shape}, but {len(rows)}"
            )
        rows = rows[command.shape : command.shape + 1]
    given = {name: float(value) for name in _FIELDS if (value := getattr(command, name)) is not None}
    _check(command.body, given | ({} if command.density is None else {"density": float(command.density)}))
    if command.density is not None:
        _weigh(state, index, rows, command)
    for name, value in given.items():
        state.shapes[name][rows] = value


def _check(body: str, given: dict[str, float]) -> None:
    from sandbox.scene.material import Material

    try:
        Material(**given)
    except SceneError as error:
        raise CommandError(f"SetSurface of {body!r}: {error.problems[0].message}") from None


def _weigh(state: State, index: int, rows: Integers, command: SetSurface) -> None:
    densities = state.shapes.density.copy()
    densities[rows] = command.density
    fault = reweigh(state, index, densities[state.shapes.body == index].tolist())
    if fault is not None:
        raise CommandError(f"SetSurface of {command.body!r}: {fault}")
