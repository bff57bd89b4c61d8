"""Sensors: shapes that sense what overlaps them and push nothing."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox._jit import Door, entry_point, inlined_kernel, kernel, kernel_argument
from sandbox.engine.broad_phase.pairs import may_collide
from sandbox.engine.events.pair_keys import pair_keys
from sandbox.engine.events.records import SENSOR_EVENT
from sandbox.engine.queries.boxes import bound
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.engine.queries.spatial_index import SpatialIndex
from sandbox.engine.queries.walk import begin_walk, next_box, stay_among_kept, stay_among_loose
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import MANIFOLD, collide_cores
from sandbox.tables import Integers, Records, as_table, plain, taken
from sandbox.world.records import STATIC
from sandbox.world.rows import Moved
from sandbox.world.state import State


class SensorOverlaps:
    """What the sensors of a world overlap. Made only for worlds that have sensors."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._manifold: Any = kernel_argument(MANIFOLD.zeros(1))
        self._found: Any = kernel_argument(SENSOR_EVENT.zeros(64))
        self._sense = Door(sense)
        self._index = SpatialIndex(state)
        self._find_sensors()
        self._layout = state.layout
        """That of the rows that `now` names."""
        self.before: Records = SENSOR_EVENT.zeros(0)
        """What they overlapped before the last step."""
        self.now: Records = SENSOR_EVENT.zeros(0)
        """What they overlap: `SENSOR_EVENT` rows, sorted by (sensor, shape)."""

    def _find_sensors(self) -> None:
        """Note which shapes are sensors."""
        self._sensors: Integers = np.flatnonzero(plain(self._state.shapes)["sensor"] == 1)

    def update(self) -> None:
        """Find what the sensors overlap now; what they overlapped so far becomes `before`."""
        if self._layout != self._state.layout:  # what is kept may have other rows
            self._layout = self._state.layout
            self._index.forget()
        if self._index.update():
            self._find_sensors()
        asking = *self._index.arguments, self._sensors, kernel_argument(self.now), self._manifold
        count = self._sense(*asking, self._found)
        if count > len(self._found):
            self._found = kernel_argument(SENSOR_EVENT.zeros(count + count // 2))
            self._sense(*asking, self._found)
        found = np.asarray(self._found)[:count]
        order = np.argsort(pair_keys(found["sensor"], found["shape_index"]), kind="stable")  # sensors are in order
        self.before, self.now = self.now, as_table(found.take(order))

    def move_rows(self, moved: Moved) -> None:
        """Rows have gone: keep what is left of what sensors overlapped."""
        rows = self.now
        left = (moved.shapes[rows.sensor] >= 0) & (moved.shapes[rows.shape_index] >= 0)
        self.now = taken(rows, left)
        for name in ("sensor", "shape_index"):
            self.now[name] = moved.shapes[self.now[name]]
        for name in ("sensor_body", "body"):
            self.now[name] = moved.bodies[self.now[name]]
        self.before = self.now
        self._layout = self._state.layout

    def reset(self) -> None:
        """Begin anew at the poses of now: after a restore, nothing enters or leaves that has not moved."""
        self.now = self.before = SENSOR_EVENT.zeros(0)
        self._index.forget()
        if self._state.counters[0].step_count > 0:
            self.update()
        self.before = self.now


@entry_point
def sense(
    tables: QueryTables, memory: Memory, sensors: Integers, before: Records, manifold: Records, found: Records
) -> int:
    """Write a row for every shape that overlaps one of `sensors` (rows of shapes), in no order of their own.

    Returns how many there are. `found` takes `SENSOR_EVENT` rows; those past its capacity are counted but not written.
    `before` has what was found when the index was brought up to date the last time; of what has been kept since both
    may stay. `manifold` is scratch, a `MANIFOLD` row.
    """
    index, walk = memory.info[0], memory.walk[0]
    resting = 0
    for sensor in sensors:
        resting += 1 if _rests(memory, sensor) else 0
    count = _keep(memory, before, found)
    shapes_ask = index.loose < resting  # what is loose asks for the sensors that rest, not they for it
    for k in range(sensors.shape[0] + (index.loose if shapes_ask else 0)):
        by_sensor = k < sensors.shape[0]
        i = sensors[k] if by_sensor else memory.loose[k - sensors.shape[0]]
        rests = _rests(memory, i)
        if (by_sensor and rests and shapes_ask) or (not by_sensor and tables.shapes[i].sensor == 1):
            continue
        _begin(tables, memory, i)
        if rests:
            stay_among_loose(walk, index)
        elif not by_sensor:
            stay_among_kept(walk, index)
        while True:
            row = next_box(walk, memory.grid)
            if row < 0:
                break
            other = memory.grid.ordered[row].shape_index
            if not _may_sense(tables.bodies, tables.shapes[i], tables.shapes[other]):
                continue
            sensor, shape = (i, other) if by_sensor else (other, i)
            if _overlap(tables, memory.cores, sensor, shape, manifold):
                if count < found.shape[0]:
                    _write(tables.shapes, sensor, shape, found[count])
                count += 1
    return count


@inlined_kernel
def _rests(memory: Memory, i: int) -> bool:
    """Whether a shape has been kept since the index was brought up to date the last time."""
    return bool(memory.info[0].anew == 0 and memory.places[i] >= 0)


@kernel
def _keep(memory: Memory, before: Records, found: Records) -> int:
    """Write the rows of pairs that both have been kept since; returns how many there are."""
    count = 0
    for k in range(before.shape[0]):
        row = before[k]
        if _rests(memory, row.sensor) and _rests(memory, row.shape_index):
            if count < found.shape[0]:
                found[count] = row
            count += 1
    return count


@kernel
def _begin(tables: QueryTables, memory: Memory, i: int) -> None:
    """Begin a walk through what the box of a shape meets."""
    question, box = memory.question[0], memory.boxes[0]
    bound(tables, memory, i, box)
    x = 0.5 * (box.lower_x + box.upper_x)
    y = 0.5 * (box.lower_y + box.upper_y)
    question.lower_x = box.lower_x - x
    question.lower_y = box.lower_y - y
    question.upper_x = box.upper_x - x
    question.upper_y = box.upper_y - y
    begin_walk(memory.walk[0], question, x, y, 0.0, 0.0, 0.0)


@kernel
def _write(shapes: Records, sensor: int, other: int, row: Records) -> None:
    row.sensor_body = shapes[sensor].body
    row.body = shapes[other].body
    row.sensor = sensor
    row.shape_index = other


@kernel
def _may_sense(bodies: Records, a: Records, b: Records) -> bool:
    """Whether of two shapes one is a sensor, and the other a solid one of another body that the filters let through."""
    if a.sensor == b.sensor or a.body == b.body or (bodies[a.body].type == STATIC and bodies[b.body].type == STATIC):
        return False
    return may_collide(a.category, a.mask, a.group, b.category, b.mask, b.group)


@kernel
def _overlap(tables: QueryTables, cores: Records, sensor: int, shape: int, manifold: Records) -> bool:
    """Whether two shapes overlap."""
    a = tables.shapes[sensor]
    b = tables.shapes[shape]
    body_a = tables.bodies[a.body]
    body_b = tables.bodies[b.body]
    dx = body_b.center_x - body_a.center_x
    dy = body_b.center_y - body_a.center_y
    return collide_cores(cores, core_of(a), core_of(b), dx, dy, 0.0, 0.0, manifold) > 0
