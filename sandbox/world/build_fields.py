"""From flat regions and thrusters to their records."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sandbox.scene.flat import FlatBody, FlatRegion, FlatThruster
from sandbox.tables import Records
from sandbox.world import field_records as kinds
from sandbox.world.field_records import EDGE, NEVER, REGION, THRUSTER

KINDS = {
    "water": kinds.WATER, "gravity": kinds.GRAVITY, "gravity_scale": kinds.GRAVITY_SCALE,
    "attraction": kinds.ATTRACTION, "wind": kinds.WIND,
}  # fmt: skip
"""The number of each kind of region."""
_WHOLE = 1e-6
"""A time this near to a step, in steps, is that step."""


def build_regions(regions: Sequence[FlatRegion], step_rate: float, now: int = 0) -> tuple[Records, Records]:
    """The tables of regions, in the order of the scene, and of their edges. Times count from the step `now` on."""
    table = REGION.zeros(len(regions))
    edges = EDGE.zeros(sum(len(region.edges) for region in regions))
    first = 0
    for row, region in zip(table, regions, strict=True):
        row.kind, row.first_edge, row.edge_count = KINDS[region.kind], first, len(region.edges)
        row.disc_x, row.disc_y, row.disc_radius = region.disc or (0.0, 0.0, 0.0)
        row.start_step, row.end_step = steps(region, step_rate, now)
        row.density, row.drag, row.angular_drag = region.density, region.drag, region.angular_drag
        row.flow_x, row.flow_y = region.flow
        row.gravity_x, row.gravity_y, row.scale = *region.gravity, region.scale
        row.center_x, row.center_y, row.strength = *region.center, region.strength
        row.falloff, row.core, row.range = region.falloff, region.core, region.range
        for edge in region.edges:
            edges[first] = edge
            first += 1
    return table, edges


def build_thrusters(scene_bodies: Sequence[FlatBody], bodies: Records, step_rate: float, now: int = 0) -> Records:
    """The thrusters of all bodies that can be pushed. `bodies` know where their centres of mass are.

    Their times count from the step `now` on.
    """
    found = [
        (index, thruster)
        for index, body in enumerate(scene_bodies)
        for thruster in (body.thrusters if body.type == "dynamic" else ())
    ]
    table = THRUSTER.zeros(len(found))
    for row, (index, thruster) in zip(table, found, strict=True):
        row.body = index
        row.force_x, row.force_y = thruster.force
        row.local_x = thruster.at[0] - float(bodies[index].local_center_x)
        row.local_y = thruster.at[1] - float(bodies[index].local_center_y)
        row.start_step, row.end_step = steps(thruster, step_rate, now)
    return table


def steps(field: FlatRegion | FlatThruster, step_rate: float, now: int) -> tuple[int, int]:
    """The first step of a field whose times count from the step `now` on, and the first one after it."""
    start, end = (step_at(seconds, step_rate) for seconds in (field.start, field.end))
    return now + start if start != NEVER else NEVER, now + end if end != NEVER else NEVER


def step_at(seconds: float, step_rate: float) -> int:
    """The first step that begins at that time or after it."""
    if math.isinf(seconds):
        return NEVER
    return math.ceil(seconds * step_rate - _WHOLE)
