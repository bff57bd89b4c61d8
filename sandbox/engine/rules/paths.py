"""Kinematic bodies on paths: before a step they get the velocity that leads to where they are due; there they arrive.

Places are worked out of the number of steps gone, with + - * / alone, so that nothing adds up over time.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable
from typing import Any

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


class Paths:
    """The paths of a world; `on_switch` hears when a driven body begins to move, or stops."""

    def __init__(self, state: State, on_switch: Callable[[], None]) -> None:
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
        for row in range(len(table)):
            path = self._path(table[row])
            if path is None:
                continue
            body = plain(self._state.bodies)[table[row]["body"]]
            if not table[row]["enabled"] or (not path.loops and table[row]["steps"] * seconds >= path.times[-1]):
                self._drive(int(table[row]["body"]), 0.0, 0.0, 0.0)
                continue
            x, y, angle = self._pose(table[row], path, (int(table[row]["steps"]) + 1) * seconds)
            self._due.append((row, (x, y, angle)))
            cx, cy = _center(body, x, y, *_cos_sin(angle))
            self._drive(
                int(table[row]["body"]),
                (cx - float(body["center_x"])) / seconds,
                (cy - float(body["center_y"])) / seconds,
                (angle - float(body["angle"])) / seconds,
            )

    def arrive(self) -> None:
        """Write the poses that were led to: exactly, whatever substeps rounded."""
        table, bodies = plain(self._state.paths), plain(self._state.bodies)
        for row, (x, y, angle) in self._due:
            body = bodies[table[row]["body"]]
            table[row]["steps"] += 1
            if body["frozen_step"] >= 0:
                continue
            cosine, sine = _cos_sin(angle)
            body["position_x"], body["position_y"], body["angle"] = x, y, angle
            body["rotation_cos"], body["rotation_sin"] = cosine, sine
            body["center_x"], body["center_y"] = _center(body, x, y, cosine, sine)

    def _path(self, row: Any) -> FlatPath | None:
        body = self._state.census.bodies.items[int(row["body"])]
        return body.path

    def _pose(self, row: Any, path: FlatPath, seconds: float) -> Pose:
        x, y, angle = pose_at(path, seconds)
        return float(row["origin_x"]) + x, float(row["origin_y"]) + y, float(row["origin_angle"]) + angle

    def _drive(self, row: int, x: float, y: float, turning: float) -> None:
        body = plain(self._state.bodies)[row]
        moved = bool(body["velocity_x"] or body["velocity_y"] or body["angular_velocity"])
        body["velocity_x"], body["velocity_y"], body["angular_velocity"] = x, y, turning
        if moved != bool(x or y or turning):
            wake_body(self._state, row)
            self._on_switch()


def _center(body: Any, x: float, y: float, cosine: float, sine: float) -> tuple[float, float]:
    """Where the centre of mass is if the origin is at (x, y)."""
    u, v = float(body["local_center_x"]), float(body["local_center_y"])
    return x + (cosine * u - sine * v), y + (sine * u + cosine * v)
