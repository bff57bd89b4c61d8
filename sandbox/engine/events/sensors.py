"""Sensors: shapes that sense what overlaps them and push nothing."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox._jit import Door, entry_point, kernel, kernel_argument
from sandbox.engine.broad_phase.pairs import may_collide
from sandbox.engine.events.pair_keys import pair_keys
from sandbox.engine.events.records import SENSOR_EVENT
from sandbox.engine.queries.boxes import bound
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.engine.queries.spatial_index import SpatialIndex
from sandbox.engine.queries.walk import begin_walk, next_box
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
        self.before: Records = SENSOR_EVENT.zeros(0)
        """What they overlapped before the last step."""
        self.now: Records = SENSOR_EVENT.zeros(0)
        """What they overlap: `SENSOR_EVENT` rows, sorted by (sensor, shape)."""

    def _find_sensors(self) -> None:
        """Note which shapes are sensors."""
        self._sensors: Integers = np.flatnonzero(plain(self._state.shapes)["sensor"] == 1)

    def update(self) -> None:
        """Find what the sensors overlap now; what they overlapped so far becomes `before`."""
        if self._index.update():
            self._find_sensors()
        asking = *self._index.arguments, self._sensors, self._manifold
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

    def reset(self) -> None:
        """Begin anew at the poses of now: after a restore, nothing enters or leaves that has not moved."""
        self.now = self.before = SENSOR_EVENT.zeros(0)
        if self._state.counters[0].step_count > 0:
            self.update()
        self.before = self.now


@entry_point
def sense(tables: QueryTables, memory: Memory, sensors: Integers, manifold: Records, found: Records) -> int:
    """Write a row for every shape that overlaps one of `sensors` (rows of shapes), in the order of the grid.

    Returns how many there are. `found` takes `SENSOR_EVENT` rows; those past its capacity are counted but not written.
    `manifold` is scratch, a `MANIFOLD` row.
    """
    question = memory.question[0]
    walk = memory.walk[0]
    count = 0
    for k in range(sensors.shape[0]):
        box = memory.boxes[0]
        bound(tables, memory, sensors[k], box)
        x = 0.5 * (box.lower_x + box.upper_x)
        y = 0.5 * (box.lower_y + box.upper_y)
        question.lower_x = box.lower_x - x
        question.lower_y = box.lower_y - y
        question.upper_x = box.upper_x - x
        question.upper_y = box.upper_y - y
        begin_walk(walk, question, x, y, 0.0, 0.0, 0.0)
        while True:
            row = next_box(walk, question, memory.grid)
            if row < 0:
                break
            other = memory.grid.ordered[row].shape_index
            if _is_sensed(tables.bodies, tables.shapes, memory.cores, sensors[k], other, manifold):
                if count < found.shape[0]:
                    _write(tables.shapes, sensors[k], other, found[count])
                count += 1
    return count


@kernel
def _write(shapes: Records, sensor: int, other: int, row: Records) -> None:
    row.sensor_body = shapes[sensor].body
    row.body = shapes[other].body
    row.sensor = sensor
    row.shape_index = other


@kernel
def _is_sensed(bodies: Records, shapes: Records, cores: Records, sensor: int, other: int, manifold: Records) -> bool:
    """Whether a solid shape of another body, which the filters let through, overlaps the sensor."""
    a = shapes[sensor]
    b = shapes[other]
    body_a = bodies[a.body]
    body_b = bodies[b.body]
    if b.sensor == 1 or a.body == b.body or (body_a.type == STATIC and body_b.type == STATIC):
        return False
    if not may_collide(a.category, a.mask, a.group, b.category, b.mask, b.group):
        return False
    dx = body_b.center_x - body_a.center_x
    dy = body_b.center_y - body_a.center_y
    return collide_cores(cores, core_of(a), core_of(b), dx, dy, 0.0, 0.0, manifold) > 0
