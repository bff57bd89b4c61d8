"""Kinematic bodies on paths: before a step they get the velocity that leads to where they are due; there they arrive.

Places are worked out of the number of steps gone, with + - * / alone, so that nothing adds up over time.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable
from typing import NamedTuple

from sandbox._jit import interpreted
from sandbox.engine.active.wake import wake_body
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat_body import FlatPath
from sandbox.tables import plain
from sandbox.world.state import State

Pose = tuple[float, float, float]
_cos_sin = interpreted(cos_sin)


def pose_at(path: FlatPath, seconds: float) -> Pose:
    """Where a path is after so many seconds: x and y (m) and angle (rad) from its origin."""
    times, points = path.times, path.points
    whole = times[-1]
    if path.loops:
        seconds -= whole * math.floor(seconds / whole)
    if seconds >= whole:
        return points[-1]
    leg = bisect_right(times, seconds)  # the place that comes next
    if leg == 0:
        return points[0]
    begin, share = times[leg - 1], 0.0
    share = (seconds - begin) / (times[leg] - begin)
    if path.smooth:
        share = share * share * (3.0 - 2.0 * share)
    (x, y, angle), (u, v, turned) = points[leg - 1], points[leg]
    return x + share * (u - x), y + share * (v - y), angle + share * (turned - angle)


class _Gone(NamedTuple):
    """How far a path has gone, as its row in the table tells."""

    body: int
    enabled: int
    steps: int
    origin_x: float
    origin_y: float
    origin_angle: float


class _Led(NamedTuple):
    """What is read of a body before a step."""

    velocity_x: float
    velocity_y: float
    angular_velocity: float
    center_x: float
    center_y: float
    angle: float
    local_center_x: float
    local_center_y: float


_GONE, _LED = list(_Gone._fields), list(_Led._fields)
_VELOCITY = _LED[:3]
_POSE = ["position_x", "position_y", "angle", "rotation_cos", "rotation_sin", "center_x", "center_y"]
"""What is written of it afterwards."""


class Paths:
    """The paths of a world; `on_switch` hears of the row of a driven body that begins to move, or stops."""

    def __init__(self, state: State, on_switch: Callable[[int], None]) -> None:
        self._state, self._on_switch = state, on_switch
        self._due: list[tuple[int, Pose]] = []
        """The rows of the paths that go on in this step, and where their bodies are when it ends."""

    def lead(self) -> None:
        """Give every driven body the velocity with which it arrives on time."""
        self._due = []
        if not len(self._state.paths):
            return
        seconds = float(self._state.settings[0].step_seconds)
        table = plain(self._state.paths)
        driven = table["body"].tolist()
        bodies = plain(self._state.bodies)[_LED][driven].tolist()
        speeds = []
        for row, (path, body) in enumerate(zip(table[_GONE].tolist(), bodies, strict=True)):
            speeds.append(self._speed(row, _Gone(*path), _Led(*body), seconds))
        self._drive(driven, bodies, speeds)

    def _speed(self, row: int, path: _Gone, body: _Led, seconds: float) -> Pose | None:
        """The velocity (m/s, rad/s) of the body of a path, which is noted if it goes on; None if there is no path."""
        way = self._state.census.bodies.items[path.body].path
        if way is None:
            return None
        if not path.enabled or (not way.loops and path.steps * seconds >= way.times[-1]):
            return 0.0, 0.0, 0.0
        x, y, angle = pose_at(way, (path.steps + 1) * seconds)
        x, y, angle = path.origin_x + x, path.origin_y + y, path.origin_angle + angle
        self._due.append((row, (x, y, angle)))
        cx, cy = _center(body.local_center_x, body.local_center_y, x, y, *_cos_sin(angle))
        return (cx - body.center_x) / seconds, (cy - body.center_y) / seconds, (angle - body.angle) / seconds

    def _drive(self, driven: list[int], bodies: list[tuple[float, ...]], speeds: list[Pose | None]) -> None:
        """Write the velocities, and let those hear of it who begin to move or stop."""
        velocities = plain(self._state.bodies)[_VELOCITY]
        for row, body, speed in zip(driven, bodies, speeds, strict=True):
            before = body[: len(_VELOCITY)]
            if speed is None:
                continue
            velocities[row] = speed
            if any(before) != any(speed):
                wake_body(self._state, row)
                self._on_switch(row)

    def arrive(self) -> None:
        """Write the poses that were led to: exactly, whatever substeps rounded."""
        if not self._due:
            return
        table, bodies = plain(self._state.paths), plain(self._state.bodies)
        rows = [row for row, _ in self._due]
        table["steps"][rows] += 1
        driven = table["body"][rows]
        poses = bodies[_POSE]
        for i, frozen, (u, v), (_, (x, y, angle)) in zip(
            driven.tolist(),
            bodies["frozen_step"][driven].tolist(),
            bodies[["local_center_x", "local_center_y"]][driven].tolist(),
            self._due,
            strict=True,
        ):
            if frozen < 0:
                cosine, sine = _cos_sin(angle)
                poses[i] = (x, y, angle, cosine, sine, *_center(u, v, x, y, cosine, sine))


def _center(u: float, v: float, x: float, y: float, cosine: float, sine: float) -> tuple[float, float]:
    """Where the centre of mass is, (u, v) in the body, if the origin is at (x, y)."""
    return x + (cosine * u - sine * v), y + (sine * u + cosine * v)
