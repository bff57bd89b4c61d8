"""Commands that change regions and thrusters: plain data, checked as a whole before it is applied."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from sandbox.engine.active.wake import wake_bodies, wake_body
from sandbox.engine.commands.checks import check_fields, title
from sandbox.errors import CommandError, SceneError
from sandbox.tables import Integers
from sandbox.world.build_fields import KINDS
from sandbox.world.field_records import NEVER
from sandbox.world.records import DYNAMIC

if TYPE_CHECKING:
    from sandbox.engine.world import World
    from sandbox.world.state import State

Vec = tuple[float, float]
_FLOW = ("flow_x", "flow_y")
_COLUMNS: dict[str, dict[str, tuple[str, ...]]] = {
    "water": {
        "water": ("density",), "surface": (), "drag": ("drag",), "angular_drag": ("angular_drag",), "flow": _FLOW,
    },
    "gravity": {"gravity": ("gravity_x", "gravity_y")},
    "gravity_scale": {"gravity_scale": ("scale",)},
    "attraction": {
        "attraction": ("strength",), "at": ("center_x", "center_y"), "falloff": ("falloff",), "core": ("core",),
        "range": ("range",),
    },
    "wind": {"wind": _FLOW, "density": ("density",), "drag": ("drag",)},
}  # fmt: skip
"""The fields that a region of each kind has, and where its record keeps them."""


@dataclass(frozen=True)
class SetRegion:
    """Change a region, given by its id; what is None stays as it is.

    Fields are those of a scene file, with the same units and limits, as far as the kind of region has them: `water`,
    `surface`, `drag`, `angular_drag`, `flow`; `gravity`; `gravity_scale`; `attraction`, `at`, `falloff`, `core`,
    `range`; `wind`, `density`, `drag`. `enabled` switches the region on or off from now on, whatever its schedule was.
    What sleeps in its area wakes.
    """

    region: str
    enabled: bool | None = None
    water: float | None = None
    surface: float | None = None
    drag: float | None = None
    angular_drag: float | None = None
    flow: Vec | None = None
    gravity: Vec | None = None
    gravity_scale: float | None = None
    attraction: float | None = None
    at: Vec | None = None
    falloff: int | None = None
    core: float | None = None
    range: float | None = None
    wind: Vec | None = None
    density: float | None = None


@dataclass(frozen=True)
class SetThruster:
    """Change a body's thrusters; what is None stays as it is.

    `force` [x, y] (N) is in the body's frame; `enabled` switches on or off from now on, whatever the schedule was.
    `thruster` is the number of one of them, from 0; None means all.
    """

    body: str
    force: Vec | None = None
    enabled: bool | None = None
    thruster: int | None = None


FieldCommand: TypeAlias = SetRegion | SetThruster


def apply_field_command(world: World, command: FieldCommand) -> None:
    """Apply a command.

    Raises `CommandError`, `UnknownRegionError` or `UnknownBodyError`, and changes nothing, if it can't be done.
    """
    check_fields(command)
    if isinstance(command, SetRegion):
        _set_region(world, command)
    else:
        _set_thruster(world.state, world.directory.body(command.body), command)


def _set_region(world: World, command: SetRegion) -> None:
    index = world.directory.region(command.region)
    state, flat = world.state, world.flat.regions[index]
    row = state.regions[index]
    given = {field.name: value for field in fields(command)[2:] if (value := getattr(command, field.name)) is not None}
    _check_region(row, given, command)
    if "surface" in given and not flat.surfaced:
        raise CommandError(f"{title(command)}: this water has no surface; give it one in the scene")
    inside = _inside(state, row)
    for field, columns in _columns(row).items():
        if field in given and columns:
            for column, value in zip(columns, given[field] if len(columns) > 1 else (given[field],), strict=True):
                row[column] = value
    if "surface" in given:
        state.edges[row.first_edge + row.edge_count - 1].offset = given["surface"]
    _switch(row, command.enabled, state)
    wake_bodies(state, np.concatenate([inside, _inside(state, row)]))


def _columns(row: Any) -> Mapping[str, tuple[str, ...]]:
    return _COLUMNS[next(name for name, number in KINDS.items() if number == row.kind)]


def _check_region(row: Any, given: Mapping[str, Any], command: SetRegion) -> None:
    """The fields must be those of the kind, and their values such as a scene may have."""
    from sandbox.scene.regions import REGIONS

    known = _columns(row)
    kind = next(iter(known))
    strays = [name for name in given if name not in known]
    if strays:
        raise CommandError(f"{title(command)}: a region of {kind} has no {strays[0]}; it has {', '.join(known)}")
    now = tuple(float(row[column]) for column in known[kind])
    try:
        REGIONS[kind](**{kind: now if len(now) > 1 else now[0], **given})
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None


def _inside(state: State, region: Any) -> Integers:
    """Rows of the sleeping bodies that may reach into a region."""
    bodies: Any = state.bodies
    found = (bodies.type == DYNAMIC) & (bodies.awake == 0)
    for edge in state.edges[region.first_edge : region.first_edge + region.edge_count]:
        found &= edge.normal_x * bodies.center_x + edge.normal_y * bodies.center_y - edge.offset <= bodies.extent
    if region.disc_radius > 0.0:
        x, y = bodies.center_x - region.disc_x, bodies.center_y - region.disc_y
        found &= np.sqrt(x * x + y * y) <= region.disc_radius + bodies.extent
    return np.flatnonzero(found)


def _set_thruster(state: State, index: int, command: SetThruster) -> None:
    rows = np.flatnonzero(np.asarray(state.thrusters.body) == index)
    if command.thruster is not None:
        if not 0 <= command.thruster < len(rows):
            raise CommandError(f"{title(command)}: the body has no thruster {command.thruster}, but {len(rows)}")
        rows = rows[command.thruster : command.thruster + 1]
    if len(rows) == 0:
        raise CommandError(f"{title(command)}: the body has no thrusters; give it some in the scene")
    if command.force is not None:
        _check_force(command)
        state.thrusters.force_x[rows], state.thrusters.force_y[rows] = command.force
    for row in rows:
        _switch(state.thrusters[row], command.enabled, state)
    wake_body(state, index)


def _check_force(command: SetThruster) -> None:
    from sandbox.scene.thruster import Thruster

    try:
        Thruster(force=command.force)  # type: ignore[arg-type]
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None


def _switch(row: Any, enabled: bool | None, state: State) -> None:
    """Let a region or a thruster act from the coming step on, or no more."""
    step = int(state.counters[0].step_count)
    acts = row.start_step <= step < row.end_step
    if enabled:
        row.start_step, row.end_step = row.start_step if acts else step, NEVER
    elif enabled is not None:
        row.end_step = min(int(row.end_step), step)
