"""The command that changes a region."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec
from sandbox.engine.commands.checks import title
from sandbox.engine.commands.sleepers_in import sleepers_in
from sandbox.engine.commands.switch import switch
from sandbox.errors import CommandError, SceneError
from sandbox.world.region_columns import columns_of


@dataclass(frozen=True)
class SetRegion(Command):
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

    def apply(self, target: CommandTarget) -> Touched:
        """Change the region and wake what sleeps in it, where it was and where it is."""
        index = target.directory.region(self.region)
        state, flat = target.state, target.state.census.regions.items[index]
        row = state.regions[index]
        given = {item.name: value for item in fields(self)[2:] if (value := getattr(self, item.name)) is not None}
        _check(row, given, self)
        if "surface" in given and not flat.surfaced:
            raise CommandError(f"{title(self)}: this water has no surface; give it one in the scene")
        inside = sleepers_in(state, row)
        for field, columns in columns_of(row).items():
            if field in given and columns:
                for column, value in zip(columns, given[field] if len(columns) > 1 else (given[field],), strict=True):
                    row[column] = value
        if "surface" in given:
            state.edges[row.first_edge + row.edge_count - 1].offset = given["surface"]
        switch(row, self.enabled, state)
        wake_bodies(state, np.concatenate([inside, sleepers_in(state, row)]))
        return Touched(schedules=True)


def _check(row: Any, given: Mapping[str, Any], command: SetRegion) -> None:
    """The fields must be those of the kind, and their values such as a scene may have."""
    from sandbox.scene.regions import REGIONS

    known = columns_of(row)
    kind = next(iter(known))
    strays = [name for name in given if name not in known]
    if strays:
        raise CommandError(f"{title(command)}: a region of {kind} has no {strays[0]}; it has {', '.join(known)}")
    now = tuple(float(row[column]) for column in known[kind])
    try:
        REGIONS[kind](**{kind: now if len(now) > 1 else now[0], **given})
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None
