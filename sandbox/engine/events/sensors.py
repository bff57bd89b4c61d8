"""Sensors: shapes that feel what overlaps them and push nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from sandbox._jit import ZERO, entry_point, kernel, kernel_argument
from sandbox.engine.broad_phase.pairs import may_collide
from sandbox.engine.events.events import SENSOR_EVENT
from sandbox.engine.queries.index import lay_out
from sandbox.engine.queries.records import Memory
from sandbox.engine.queries.walk import begin_walk, next_box
from sandbox.geometry.manifold import MANIFOLD, collide_cores
from sandbox.tables import Integers, Records, taken
from sandbox.world.records import STATIC
from sandbox.world.rows import Moved
from sandbox.world.state import State


class Sensing:
    """What the sensors of a world overlap. Made only for worlds that have sensors."""

    def __init__(self, state: State) -> None:
        self._state = state
        m = self._memory = Memory.for_state(state)
        self._sensors: Integers = np.flatnonzero(state.shapes.sensor == 1)
        self._manifold: Any = kernel_argument(MANIFOLD.zeros(1))
        self._found: Any = kernel_argument(SENSOR_EVENT.zeros(64))
        grid = (m.ordered, m.heads, m.levels, m.regions, m.question)
        laying = (state.bodies, state.shapes, state.vertices, m.turned, m.boxes, *grid)
        asking = (state.bodies, state.shapes, m.turned, m.boxes, *grid, m.walk)
        self._laying: Any = tuple(map(kernel_argument, laying))
        self._asking: Any = tuple(map(kernel_argument, asking))
        self.before: Records = SENSOR_EVENT.zeros(0)
        """What they overlapped before the last step."""
        self.now: Records = SENSOR_EVENT.zeros(0)
        """What they overlap: `SENSOR_EVENT` rows, sorted by (sensor, shape)."""

    def look(self) -> None:
        """Find what the sensors overlap now; what they overlapped so far becomes `before`."""
        lay_out(*self._laying)
        ask: Callable[..., int] = sense
        count = ask(*self._asking, self._sensors, self._manifold, self._found)
        if count > len(self._found):
            self._found = kernel_argument(SENSOR_EVENT.zeros(count + count // 2))
            ask(*self._asking, self._sensors, self._manifold, self._found)
        found = np.asarray(self._found)[:count]
        self.before, self.now = self.now, found[np.lexsort((found["shape_index"], found["sensor"]))].view(np.recarray)

    def follow(self, earlier: Sensing, moved: Moved) -> None:
        """Take over what sensors overlapped before rows came or went."""
        rows = earlier.now
        left = (moved.shapes[rows.sensor] >= 0) & (moved.shapes[rows.shape_index] >= 0)
        self.now = taken(rows, left)
        for name in ("sensor", "shape_index"):
            self.now[name] = moved.shapes[self.now[name]]
        for name in ("sensor_body", "body"):
            self.now[name] = moved.bodies[self.now[name]]
        self.before = self.now

    def forget(self) -> None:
        """Begin anew at the poses of now: after a restore, nothing enters or leaves that has not moved."""
        self.now = self.before = SENSOR_EVENT.zeros(0)
        if self._state.counters[0].step_count > 0:
            self.look()
        self.before = self.now


@entry_point
def sense(
    bodies: Records,
    shapes: Records,
    turned: Records,
    boxes: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    regions: Records,
    question: Records,
    walk: Records,
    sensors: Integers,
    manifold: Records,
    found: Records,
) -> int:
    """Write a row for every shape that overlaps a sensor, in the order of the grid; return how many there are.

    Rows past the capacity of `found` are counted but not written.
    """
    count = ZERO
    for k in range(sensors.shape[0]):
        box = boxes[sensors[k]]
        x = 0.5 * (box.lower_x + box.upper_x)
        y = 0.5 * (box.lower_y + box.upper_y)
        question[0].lower_x = box.lower_x - x
        question[0].lower_y = box.lower_y - y
        question[0].upper_x = box.upper_x - x
        question[0].upper_y = box.upper_y - y
        begin_walk(walk[0], question[0], x, y, 0.0, 0.0, 0.0)
        while True:
            row = next_box(walk[0], question[0], ordered, heads, levels, regions)
            if row < 0:
                break
            other = ordered[row].shape_index
            if _is_sensed(bodies, shapes, turned, sensors[k], other, manifold):
                if count < found.shape[0]:
                    _write(shapes, sensors[k], other, found[count])
                count += 1
    return count


@kernel
def _write(shapes: Records, sensor: int, other: int, row: Records) -> None:
    row.sensor_body = shapes[sensor].body
    row.body = shapes[other].body
    row.sensor = sensor
    row.shape_index = other


@kernel
def _is_sensed(bodies: Records, shapes: Records, turned: Records, sensor: int, other: int, manifold: Records) -> bool:
    """Whether a solid shape of another body, which the filters let through, overlaps the sensor."""
    a = shapes[sensor]
    b = shapes[other]
    body_a = bodies[a.body]
    body_b = bodies[b.body]
    if b.sensor == 1 or a.body == b.body or (body_a.type == STATIC and body_b.type == STATIC):
        return False
    if not may_collide(a.category, a.mask, a.group, b.category, b.mask, b.group):
        return False
    points = collide_cores(
        turned,
        a.vertex_start,
        a.vertex_count,
        a.radius,
        b.vertex_start,
        b.vertex_count,
        b.radius,
        body_b.center_x - body_a.center_x,
        body_b.center_y - body_a.center_y,
        0.0,
        0.0,
        manifold,
    )
    return points > 0
