"""What happened in a step, for rules: each occasion on which one is followed, with the bodies that it is about."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.engine.events.pair_keys import among, pair_keys, pairs_of
from sandbox.engine.rules.base import RuledWorld
from sandbox.engine.rules.selectors import Selector
from sandbox.scene.flat_rules import FlatRule
from sandbox.tables import Integers, Records, plain
from sandbox.world.build_fields import step_at
from sandbox.world.rule_records import SENSING

_NOTHING_SENSED = SENSING.zeros(0)
Vec = tuple[float, float]
Pair = tuple[str, str, float, float]
"""Ids, speed (m/s) and impulse (N s) of an event between two bodies."""


@dataclass(frozen=True)
class Occasion:
    """Why actions are done: the ids of the bodies of the event, where the pointer is, and what pushes are multiplied
    with. `source` is the id of the rule or control."""

    source: str = ""
    first: str | None = None
    second: str | None = None
    pointer: Vec | None = None
    scale: float = 1.0


class Happened:
    """The events of a step as pairs of ids, looked up once for all rules, and only if one of them asks.

    `sensed` are the rows of what sensors had in them before the step, and after it.
    """

    def __init__(self, world: RuledWorld, sensed: tuple[Records, Records]) -> None:
        self._world, self._sensed = world, sensed
        self._known: dict[str, list[Pair]] = {}
        self._numbers: dict[str, dict[str, list[int]]] = {}

    def about(self, kind: str, *sides: frozenset[str] | None) -> list[Pair]:
        """Those of `pairs` in which some body of each side may have part, in their order; None is any body.

        They are looked up by the ids of the side of which fewest are told, so that a rule does not go through what is
        told of others.
        """
        pairs = self.pairs(kind)
        if not pairs or all(side is None for side in sides):
            return pairs
        numbers = self._numbers_of(kind)
        told = [[numbers[name] for name in side if name in numbers] for side in sides if side is not None]
        fewest = min(told, key=lambda lists: sum(map(len, lists)))
        return [pairs[n] for n in sorted({n for each in fewest for n in each})]

    def _numbers_of(self, kind: str) -> dict[str, list[int]]:
        """For each id, which of the pairs of a kind it has part in."""
        if kind not in self._numbers:
            found: dict[str, list[int]] = {}
            for n, (a, b, _, _) in enumerate(self.pairs(kind)):
                found.setdefault(a, []).append(n)
                found.setdefault(b, []).append(n)
            self._numbers[kind] = found
        return self._numbers[kind]

    def pairs(self, kind: str) -> list[Pair]:
        """All events of a kind between bodies that are there.

        Hits are told once for two bodies, with the fastest of their points and all that these exert.
        """
        if kind not in self._known:
            self._known[kind] = list(self._hits() if kind == "hit" else self._found(kind))
        return self._known[kind]

    @property
    def broken(self) -> list[str]:
        """The ids of the joints that broke."""
        events = self._world.events
        return [events.joint_names[row] for row in events.joint_break.tolist()]

    def _found(self, kind: str) -> Iterator[Pair]:
        if kind in ("enter", "leave"):
            names = self._world.state.census.bodies.names
            for a, b in zip(*self._passed(kind == "enter"), strict=True):
                yield names[a], names[b], 0.0, 0.0
            return
        events = self._world.events
        rows = getattr(events, kind)
        columns = _columns(rows, "body_a", "body_b", "shape_a", "shape_b", "speed", "impulse")
        for a, b, shape_a, shape_b, speed, impulse in zip(*columns, strict=True):
            if shape_a >= 0 and shape_b >= 0:  # a body that was deleted comes apart from nothing
                yield events.names[a], events.names[b], speed, impulse

    def _passed(self, entered: bool) -> tuple[list[int], list[int]]:
        """The bodies of sensors that others have entered, or left, and those others."""
        if not any(map(len, self._sensed)):
            return [], []
        before, now = (np.sort(_sensing_keys(rows), kind="stable") for rows in self._sensed)
        keys = now[~among(now, before)] if entered else before[~among(before, now)]
        sensors, others = pairs_of(keys)
        return sensors.tolist(), others.tolist()

    def _hits(self) -> Iterator[Pair]:
        found: dict[tuple[str, str], tuple[float, float]] = {}
        for a, b, speed, impulse in self._found("hit"):
            fastest, total = found.get((a, b), (0.0, 0.0))
            found[a, b] = max(fastest, speed), total + impulse
        yield from ((*pair, *figures) for pair, figures in found.items())


def _columns(rows: Records, *names: str) -> list[list[Any]]:
    table = plain(rows)
    return [table[name].tolist() for name in names]


class Waiting:
    """What one rule waits for that is no count and no press, ready to be compared with what happened."""

    def __init__(self, rule: FlatRule, step_rate: float) -> None:
        self._trigger, self._id = rule.when, rule.id
        self._first, self._second = Selector(rule.when.first), Selector(rule.when.second)
        self._step = max(1, step_at(rule.when.start if rule.when.kind == "every" else rule.when.time, step_rate))
        self._period = max(1, step_at(rule.when.time, step_rate))

    def occasions(self, happened: Happened, step: int) -> Iterator[Occasion]:
        """Each time that it came about in the step that led to `step`."""
        kind = self._trigger.kind
        if kind == "time" or kind == "every":
            since = step - self._step
            if since == 0 or (kind == "every" and since > 0 and since % self._period == 0):
                yield Occasion(self._id)
        elif kind == "joint_break":
            yield from (Occasion(self._id) for name in happened.broken if name in self._first)
        else:
            pairs = happened.about(kind, self._first.ids, self._second.ids)
            yield from self._pairs(pairs, kind in ("enter", "leave"))

    def _pairs(self, pairs: list[Pair], ordered: bool) -> Iterator[Occasion]:
        trigger = self._trigger
        for a, b, speed, impulse in pairs:
            if trigger.kind == "hit" and (speed < trigger.speed or impulse < trigger.impulse):
                continue
            if a in self._first and b in self._second:
                yield Occasion(self._id, a, b)
            elif not ordered and b in self._first and a in self._second:
                yield Occasion(self._id, b, a)


def sensing_rows(sensed: Records | None) -> Records:
    """Each pair of bodies of which one senses the other, once, in order: `SENSING` rows."""
    if sensed is None or not len(sensed):
        return _NOTHING_SENSED
    keys = np.sort(_sensing_keys(sensed), kind="stable")  # in order already, but for bodies with several sensors
    keys = keys[np.flatnonzero(np.diff(keys, prepend=-1))]
    table = SENSING.zeros(len(keys))
    rows = plain(table)
    rows["sensor_body"], rows["body"] = pairs_of(keys)
    return table


def _sensing_keys(rows: Records) -> Integers:
    return pair_keys(plain(rows)["sensor_body"], plain(rows)["body"])
