"""The command that changes a region."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec
from sandbox.engine.commands.checks import AREAS, title
from sandbox.engine.commands.sleepers_in import sleepers_in
from sandbox.engine.commands.switch import switch
from sandbox.errors import CommandError, SceneError
from sandbox.scene.flat import FlatRegion
from sandbox.world.region_area import disc_of, side_count
from sandbox.world.region_columns import columns_of
from sandbox.world.region_rows import put_sides


@dataclass(frozen=True)
class SetRegion(Command):
    """Change a region, given by its id; what is None stays as it is.

    Fields are those of a scene file, with the same units and limits, as far as the kind of region has them: `water`,
    `surface`, `drag`, `angular_drag`, `flow`; `gravity`; `gravity_scale`; `attraction`, `at`, `falloff`, `core`,
    `range`, infinite for none; `wind`, `density`, `drag`. `enabled` switches the region on or off from now on, whatever
    its schedule was. `inside`, `outline` and `disc` (m) put its area elsewhere or make it larger, as far as it has such
    a one. What sleeps in its area wakes, where it was and where it is.
    """

    UNLIMITED: ClassVar[frozenset[str]] = frozenset({"range"})
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
    inside: tuple[float, float, float, float] | None = None
    outline: tuple[Vec, ...] | None = None
    disc: tuple[float, float, float] | None = None

    def apply(self, target: CommandTarget) -> Touched:
        """Change the region and wake what sleeps in it, where it was and where it is."""
        index = target.directory.region(self.region)
        state, flat = target.state, target.state.census.regions.items[index]
        row, edges = state.regions[index], state.edges
        given = {item.name: value for item in fields(self)[2:] if (value := getattr(self, item.name)) is not None}
        wanted = _checked(row, given, self)
        if "surface" in given and not flat.surfaced:
            raise CommandError(f"{title(self)}: this water has no surface; give it one in the scene")
        _check_area(side_count(state, index), disc_of(state, index) is not None, self)
        inside = sleepers_in(state, row)
        for field, columns in columns_of(row).items():
            if field in given and columns:
                for column, value in zip(columns, given[field] if len(columns) > 1 else (given[field],), strict=True):
                    row[column] = value
        if self.inside is not None or self.outline is not None:
            put_sides(state, index, wanted.edges[: len(wanted.edges) - wanted.surfaced])
        if wanted.disc is not None:
            row.disc_x, row.disc_y, row.disc_radius = wanted.disc
        if "surface" in given:
            state.edges[row.first_edge + row.edge_count - 1].offset = given["surface"]
        switch(row, self.enabled, state)
        woken = wake_bodies(state, np.concatenate([inside, sleepers_in(state, row)]))
        return Touched(schedules=self.enabled is not None, regions=state.edges is not edges, bodies=woken)


def _checked(row: Any, given: Mapping[str, Any], command: SetRegion) -> FlatRegion:
    """The fields must be those of the kind, and their values such as a scene may have; gives a region with them."""
    from sandbox.scene.regions import REGIONS

    known = columns_of(row)
    kind = next(iter(known))
    strays = [name for name in given if name not in known and name not in AREAS]
    if strays:
        raise CommandError(f"{title(command)}: a region of {kind} has no {strays[0]}; it has {', '.join(known)}")
    now = tuple(float(row[column]) for column in known[kind])
    endless = {name: None for name, value in given.items() if command.is_unlimited(name, value)}
    try:
        return REGIONS[kind](**{kind: now if len(now) > 1 else now[0], **given, **endless}).flat()
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None


def _check_area(sides: int, round_: bool, command: SetRegion) -> None:
    """A region keeps the kind of its area."""
    if (command.inside is not None or command.outline is not None) and sides == 0:
        raise CommandError(f"{title(command)}: its area has no sides that could be elsewhere")
    if command.disc is not None and not round_:
        raise CommandError(f"{title(command)}: its area is no disc")
