"""Water, wind, zones and flames of a moment, as plain data that a canvas can draw."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sandbox.render.camera import Camera
from sandbox.render.field_drawing import area
from sandbox.render.field_frame import FieldMarks, RegionMark
from sandbox.render.theme import Theme
from sandbox.report.body_data import hex_of
from sandbox.world.field_records import WATER, WIND
from sandbox.world.state import State

_ROOM = 8.0
"""How many times wider than the first view the area is in which regions are shown."""


@dataclass(frozen=True)
class FieldSampler:
    """The first view and the colours: what it takes to draw regions, which may be without end."""

    camera: Camera
    theme: Theme

    def sample(self, marks: FieldMarks, state: State, slots: Sequence[int]) -> list[Any]:
        """`[regions, flames]` of now; `slots` says which body of the film a row is."""
        if not marks.regions and not len(marks.flames):
            return [[], []]
        wide = replace(self.camera, scale=self.camera.scale / _ROOM)
        regions = (self._region(region, wide) for region in marks.regions)
        return [[region for region in regions if region], _flames(state, slots)]

    def _region(self, region: RegionMark, camera: Camera) -> dict[str, Any] | None:
        if not len(region.edges) and region.disc[2] == 0.0:
            return None
        points = area(region, camera)
        if len(points) < 3:
            return None
        color = {WATER: self.theme.water, WIND: self.theme.wind}.get(region.kind, self.theme.gravity)
        data: dict[str, Any] = {"color": hex_of(color), "area": np.round(points, 4).ravel().tolist()}
        levels = region.edges[region.edges[:, 1] == 1.0, 2].tolist() if region.kind == WATER else []
        return data | ({"level": round(min(levels), 5)} if levels else {})


def _flames(state: State, slots: Sequence[int]) -> list[list[float]]:
    """`[body, x, y, jet x, jet y]` of each thruster that burns, in its body's frame."""
    step = int(state.counters[0].step_count)
    burning = [row for row in state.thrusters if row.start_step <= step < row.end_step and row.body >= 0]
    return [_flame(row, slots[int(row.body)]) for row in burning]


def _flame(row: Any, slot: int) -> list[float]:
    size = max(float(np.hypot(row.force_x, row.force_y)), 1e-300)
    numbers = (row.local_x, row.local_y, -row.force_x / size, -row.force_y / size)
    return [slot, *(round(float(value), 5) for value in numbers)]
