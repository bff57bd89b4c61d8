"""Bodies on paths in another engine: before each step they get the velocity with which they arrive on time, as here.

What enables and stops paths are rules and commands, which other engines know nothing of: there a path goes on as it
began.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace

from sandbox.reference.run import OtherRun
from sandbox.scene.flat import FlatBody, Vec


class _Way:
    """How far one of them has come: `place` is where it is (x and y in m, angle in rad) after so many `steps`."""

    def __init__(self, body: FlatBody, rate: float) -> None:
        assert body.path is not None
        self.path, self._rate = body.path, rate
        self._origin = (*body.position, body.angle)
        self._turns = any(angle != 0.0 for _, _, angle in body.path.points)
        self.steps = round(body.path.time * rate)
        self.place = self._due() if self.steps else self._origin

    @property
    def is_over(self) -> bool:
        """Whether it stays where it is for good."""
        return not self.path.loops and self.steps / self._rate >= self.path.times[-1]

    def go_on(self, run: OtherRun, name: str) -> tuple[Vec, float]:
        """Take another step; returns with which velocities. An engine that errs about an angle is asked for it."""
        x, y, angle = self.place
        if self._turns:
            now = run.pose(name)
            angle = math.atan2(now.sin, now.cos)
        self.steps += 1
        self.place = self._due()
        turn = math.remainder(self.place[2] - angle, math.tau)
        return ((self.place[0] - x) * self._rate, (self.place[1] - y) * self._rate), turn * self._rate

    def _due(self) -> tuple[float, float, float]:
        (x, y, angle), way = self._origin, self.path.after(self.steps / self._rate)
        return x + way[0], y + way[1], angle + way[2]


class Led:
    """Those whose paths are enabled, by their ids, at `step_rate` steps a second."""

    def __init__(self, step_rate: float) -> None:
        self._rate = step_rate
        self._ways: dict[str, _Way] = {}

    def add(self, bodies: Iterable[FlatBody]) -> tuple[FlatBody, ...]:
        """The same bodies, those on paths where these are at the `time` with which they come."""
        return tuple([body if body.path is None else self._begun(body) for body in bodies])

    def remove(self, names: Iterable[str]) -> None:
        """Some of all bodies have gone."""
        for name in names:
            self._ways.pop(name, None)

    def lead(self, run: OtherRun) -> None:
        """Give all of them the velocities for the next step; those at the end of their ways stand still for good."""
        over = [name for name, way in self._ways.items() if way.is_over]
        for name in over:
            run.set_velocity(name, (0.0, 0.0), 0.0)
            del self._ways[name]
        for name, way in self._ways.items():
            run.set_velocity(name, *way.go_on(run, name))

    def _begun(self, body: FlatBody) -> FlatBody:
        way = _Way(body, self._rate)
        if way.path.enabled:
            self._ways[body.id] = way
        x, y, angle = way.place
        return replace(body, position=(x, y), angle=angle, velocity=(0.0, 0.0), angular_velocity=0.0)
