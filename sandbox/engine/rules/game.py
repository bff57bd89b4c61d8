"""Everything that is played in one world: what controls, paths and rules do around a step."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from sandbox.engine.events.happening import Happening
from sandbox.engine.rules.actor import Actor
from sandbox.engine.rules.base import RuledWorld
from sandbox.engine.rules.occasions import Happened, Occasion, Waiting, sensing_rows
from sandbox.engine.rules.selectors import Selector
from sandbox.scene.flat_rules import FlatCondition
from sandbox.tables import Records, plain
from sandbox.world.build_fields import step_at
from sandbox.world.build_rules import outcome_texts
from sandbox.world.rule_records import LOST, OPEN, WON

MOST_AT_ONCE = 100
"""So many times a rule is followed in one step."""
_MARKS = ["pressed", "released", "value"]
"""What is asked of a control before each step."""


class Game:
    """Controls and rules of one world. It knows nothing that is not in the state, but for what can be found again."""

    def __init__(self, world: RuledWorld) -> None:
        self._world = world
        flat = world.state.census.scene
        self._rules, self._controls = flat.rules, flat.controls
        rate = flat.settings.step_rate
        self._waiting = [
            (number, Waiting(rule, rate))
            for number, rule in enumerate(flat.rules)
            if rule.when.kind not in ("count", "press")  # those are followed as soon as it comes about
        ]
        self._cooldowns = [step_at(rule.cooldown, rate) for rule in flat.rules]
        self._touching = {
            rule.condition.touches: (Selector((rule.condition.touches[0],)), Selector((rule.condition.touches[1],)))
            for rule in flat.rules
            if rule.condition is not None and rule.condition.touches
        }
        self._senses = any(rule.when.kind in ("enter", "leave") for rule in flat.rules)
        self._counting: dict[str, list[int]] = {counter.id: [] for counter in flat.counters}
        for number, rule in enumerate(flat.rules):
            if rule.when.kind == "count":
                self._counting[rule.when.name].append(number)
        self._tallies = {counter.id: row for row, counter in enumerate(flat.counters)}
        self._texts = outcome_texts(flat)
        self._actor = Actor(world, self)
        self._reached: deque[int] = deque()

    def before_step(self) -> None:
        """What is pressed, held and let go acts."""
        self._actor.begin()
        controls = plain(self._world.state.controls)
        marks = controls[_MARKS].tolist()
        if any(map(any, marks)):  # as seldom as somebody plays
            self._obey(marks)
        self._settle()

    def _obey(self, marks: Sequence[tuple[int, int, float]]) -> None:
        """Do what belongs to the controls, of which each was pressed, was let go, or holds a value."""
        controls = plain(self._world.state.controls)
        controls["pressed"] = controls["released"] = 0
        pressed = [mark[0] == 1 for mark in marks]
        held = [bool(mark[2]) for mark in marks]
        # A control that was pressed and let go since the last step lets go after it has acted.
        taps = [press and not holds for press, holds in zip(pressed, held, strict=True)]
        self._use("release", [mark[1] == 1 and not tap for mark, tap in zip(marks, taps, strict=True)])
        self._use("press", pressed)
        self._follow_presses(pressed)
        self._use("hold", held)
        self._use("release", taps)

    def after_step(self, sensed: Records | None) -> Sequence[Happening]:
        """Rules follow what happened; `sensed` is what sensors overlap now. Returns what is to be told since the last
        time."""
        state = self._world.state
        before, now = state.sensings, sensing_rows(sensed) if self._senses else state.sensings
        state.sensings = now
        if self._waiting:
            happened = Happened(self._world, (before, now))
            step = int(plain(state.counters)["step_count"][0])
            # All occasions are known before anything is done on any of them.
            found = [(n, list(islice(each.occasions(happened, step), MOST_AT_ONCE))) for n, each in self._waiting]
            for number, occasions in found:
                for occasion in occasions:
                    self._follow(number, occasion)
        self._settle()
        told, self._actor.happenings = self._actor.happenings, []
        return told

    def count(self, name: str, value: float, adds: bool, by: str) -> None:
        """Change a counter, and note which rules wait for what it reaches."""
        row = plain(self._world.state.tallies)[self._tallies[name]]
        before = float(row["value"])
        after = min(max(before + value if adds else value, -1e15), 1e15)
        row["value"] = after
        self._actor.tell("counter", by, counter=name, value=after)
        for number in self._counting[name]:
            wanted = self._rules[number].when.value
            if before < wanted <= after or after <= wanted < before:
                self._reached.append(number)

    def end(self, won: bool, text: str, by: str) -> None:
        """The game is over; what comes later does not change how."""
        row = plain(self._world.state.outcome)[0]
        if row["result"] == OPEN:
            row["result"], row["text"] = WON if won else LOST, self._texts.index(text)
            row["step"] = int(self._world.state.counters[0].step_count)
            self._actor.tell("win" if won else "lose", by, text=text)

    def _use(self, occasion: str, which: Sequence[bool]) -> None:
        for number, (control, used) in enumerate(zip(self._controls, which, strict=True)):
            if used and getattr(control, occasion):
                self._actor.do(getattr(control, occasion), self._held(number, occasion == "hold"))

    def _held(self, number: int, scaled: bool) -> Occasion:
        row = plain(self._world.state.controls)[number]
        pointer = float(row["pointer_x"]), float(row["pointer_y"])
        return Occasion(self._controls[number].id, pointer=pointer, scale=float(row["value"]) if scaled else 1.0)

    def _follow_presses(self, pressed: Sequence[bool]) -> None:
        names = {control.id: number for number, control in enumerate(self._controls) if pressed[number]}
        for number, rule in enumerate(self._rules):
            if rule.when.kind == "press" and rule.when.name in names:
                held = self._held(names[rule.when.name], False)
                self._follow(number, Occasion(rule.id or held.source, pointer=held.pointer))

    def _settle(self) -> None:
        """Follow the rules that wait for counters, in the order in which these got there; each of them once."""
        followed: set[int] = set()
        while self._reached:
            number = self._reached.popleft()
            if number not in followed:
                followed.add(number)
                self._follow(number, Occasion(self._rules[number].id))
        self._actor.finish()

    def _follow(self, number: int, occasion: Occasion) -> None:
        rule, row = self._rules[number], plain(self._world.state.rules)[number]
        step = int(self._world.state.counters[0].step_count)
        if rule.limit is not None and row["count"] >= rule.limit:
            return
        if row["last_step"] >= 0 and step - row["last_step"] < self._cooldowns[number]:
            return
        if rule.condition is not None and not self._holds(rule.condition):
            return
        row["count"] += 1
        row["last_step"] = step
        self._actor.do(rule.do, occasion)

    def _holds(self, condition: FlatCondition) -> bool:
        if condition.counter:
            value = float(plain(self._world.state.tallies)[self._tallies[condition.counter]]["value"])
            if not condition.low <= value <= condition.high:
                return False
        if not condition.touches:
            return True
        self._actor.finish()
        return any(self._pairs_touching(condition.touches))

    def _pairs_touching(self, pair: Any) -> Iterator[bool]:
        """Whether each pair of bodies that touch now is one that is meant."""
        state, (first, second) = self._world.state, self._touching[pair]
        rows = plain(state.contacts)[: int(state.counters[0].contact_count)]
        rows = rows[rows["touching"] == 1]
        names = state.census.bodies.names
        for a, b in zip(rows["body_a"].tolist(), rows["body_b"].tolist(), strict=True):
            one, two = names[a], names[b]
            yield (one in first and two in second) or (two in first and one in second)
