"""Reads the expressions of a sweep while a world runs."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from sandbox.engine.world import World
from sandbox.errors import ArgumentError, UnknownBodyError, UnknownJointError
from sandbox.scene.flat import FlatScene
from sandbox.scene.near_names import did_you_mean
from sandbox.sweeps.expression import Collected
from sandbox.sweeps.readings import Numbers, Read, counter


def check_names(expressions: Sequence[Collected], scene: FlatScene, steps: int) -> None:
    """Whether a scene has all that the expressions read, and so many steps. Raises `ArgumentError`."""
    known = {
        "body": [body.id for body in scene.bodies],
        "joint": [joint.id for joint in scene.joints if joint.id],
        "counter": [each.id for each in scene.counters],
    }
    for each in expressions:
        kind, name = each.subject.kind, each.subject.id
        if kind in known and name not in known[kind]:
            hint = did_you_mean(name, known[kind]) or _there(known[kind])
            raise ArgumentError(f"collect {each.text}: no {kind} {name!r} in this scene; {hint}")
        if not 0 <= each.step <= steps:
            raise ArgumentError(f"collect {each.text}: a run has the steps 0 to {steps}")


def _there(names: list[str]) -> str:
    most = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
    return f"there are {most}" if names else "there are none"


def run_and_collect(world: World, steps: int, expressions: Sequence[Collected]) -> tuple[float, ...]:
    """Step a world to `steps` and return what the expressions say, a number for each column.

    What is read of a body or joint that has been deleted is NaN, which `min` and `max` pass over.
    """
    gauges = [_Gauge(world, each) for each in expressions]
    for gauge in gauges:
        gauge.observe(0)
    if any(gauge.watches for gauge in gauges):
        for step in range(1, steps + 1):
            world.step()
            for gauge in gauges:
                gauge.observe(step)
    else:
        _leap(world, steps, gauges)
    return tuple(number for gauge in gauges for number in gauge.value())


def _leap(world: World, steps: int, gauges: Sequence[_Gauge]) -> None:
    """Step in one call from one place that is asked for to the next."""
    stops = sorted({gauge.step for gauge in gauges if 0 < gauge.step < steps} | {steps})
    for stop in stops:
        world.step(stop - world.step_count)
        for gauge in gauges:
            gauge.observe(stop)


class _Gauge:
    """One expression in one run."""

    def __init__(self, world: World, expression: Collected) -> None:
        self._read = _bound(world, expression)
        self._when, self.step, self._part = expression.when, expression.step, expression.part
        self._seen = 0
        self._kept: Numbers = (math.nan,) * len(expression.columns)
        self.watches = self._when in ("min", "max", "mean")

    def observe(self, step: int) -> None:
        """The world has come to that step."""
        if self._when == "at" and step == self.step:
            self._kept = self._now()
        elif self.watches:
            self._seen += 1
            self._kept = tuple(map(self._joined, self._kept, self._now()))

    def value(self) -> Numbers:
        """What came of it, at the end of the run."""
        return self._now() if self._when == "final" else self._kept

    def _joined(self, kept: float, now: float) -> float:
        if self._seen == 1 or math.isnan(kept):
            return now
        if self._when == "mean":
            return kept + (now - kept) / self._seen
        if math.isnan(now):
            return kept
        return max(kept, now) if self._when == "max" else min(kept, now)

    def _now(self) -> Numbers:
        try:
            numbers = self._read()
        except (UnknownBodyError, UnknownJointError):
            return (math.nan,) * len(self._kept)
        return numbers if self._part is None else (numbers[self._part],)


def _bound(world: World, expression: Collected) -> Callable[[], Numbers]:
    """How an expression is read of a world."""
    kind, name = expression.subject.kind, expression.subject.id
    read: Read = expression.reading.read
    if kind == "counter":
        return lambda: counter(name).read(world)
    if kind == "world":
        return lambda: read(world)
    thing = world.body(name) if kind == "body" else world.joint(name)
    return lambda: read(thing)
