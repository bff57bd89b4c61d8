"""Paths of kinematic bodies: where they are at which time."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.flat_body import FlatPath
from sandbox.scene.limits import MAX_OUTLINE
from sandbox.scene.objects import known_as
from sandbox.scene.quantities import Degrees, Point, Seconds

PathSpeed = Annotated[float, Range(1e-4, 1e6, "m/s")]


@known_as('a "path"')
class BodyPath(Model):
    """Where a kinematic body goes, and when."""

    to: Annotated[tuple[Point, ...], Listed("[[x, y], ...]", 1, MAX_OUTLINE)] = Field(
        description="Where it goes one after another, from where it is placed [x, y], m."
    )
    turn: Annotated[tuple[Degrees, ...], Listed("[degrees, ...]", 1, MAX_OUTLINE)] | None = Field(
        default=None, description="How far it is turned at each of these places, degrees; default: not at all."
    )
    times: Annotated[tuple[Seconds, ...], Listed("[s, ...]", 1, MAX_OUTLINE + 1)] | None = Field(
        default=None, description="When it gets to each place, s; a loop has one more: when it is back."
    )
    speed: PathSpeed | None = Field(default=None, description="How fast it goes instead of times, m/s.")
    pause: Seconds = Field(default=0.0, description="With a speed: how long it waits at each place, s.")
    mode: Literal["once", "loop", "ping-pong"] = Field(
        default="once", description="After the last place: stay there, go on to the first, or go back the same way."
    )
    easing: Literal["linear", "smooth"] = Field(
        default="linear", description="smooth: each leg begins and ends at rest (3 u^2 - 2 u^3)."
    )
    enabled: bool = Field(default=True, description="false: it waits until a rule or command lets it go.")
    time: Seconds = Field(default=0.0, description="The time of the path at which the scene begins, s.")

    def flat(self) -> FlatPath:
        """The path in SI units, with a time for every place; the way back is written out."""
        turns = self.turn or (0.0,) * len(self.to)
        places = [(x, y, turn * RADIANS_PER_DEGREE) for (x, y), turn in zip(self.to, turns, strict=True)]
        points = [_START, *places, *([_START] if self.mode == "loop" else [])]
        times = [0.0, *self.times] if self.times is not None else _times(points, self.speed or 1.0)
        if self.mode == "ping-pong":
            end = times[-1]
            points, times = points + points[-2::-1], times + [2.0 * end - time for time in times[-2::-1]]
        if self.pause > 0.0:
            points, times = _with_pauses(points, times, self.pause, self.mode != "once")
        loops, smooth = self.mode != "once", self.easing == "smooth"
        return FlatPath(tuple(points), tuple(times), loops, smooth, self.enabled, self.time)


Places = list[tuple[float, float, float]]
_START = (0.0, 0.0, 0.0)


def _times(points: Places, speed: float) -> list[float]:
    """When something that fast is at each place."""
    times = [0.0]
    for (x, y, _), (u, v, _) in pairwise(points):
        times.append(times[-1] + math.sqrt((u - x) * (u - x) + (v - y) * (v - y)) / speed)
    return times


def _with_pauses(points: Places, times: list[float], pause: float, loops: bool) -> tuple[Places, list[float]]:
    """Every place twice, so long apart; the last of a loop is the first of the next round."""
    pauses = len(points) - 1 if loops else len(points)
    found: Places = []
    when: list[float] = []
    for k, (point, time) in enumerate(zip(points, times, strict=True)):
        found += [point, point] if k < pauses else [point]
        begins, ends = time + k * pause, time + (k + 1) * pause  # never after the next one begins, however rounded
        when += [begins, ends] if k < pauses else [begins]
    return found, when
