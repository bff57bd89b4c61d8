"""The judge: watches a world step by step and says which of its scene's expectations hold."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from sandbox.arguments import check_kind
from sandbox.replay.conditions import Condition
from sandbox.replay.expectation_conditions import conditions
from sandbox.scene import Scene
from sandbox.scene.expect import Expectation
from sandbox.world.census import Census
from sandbox.world.checked_world import check_world
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.world import World


@dataclass(frozen=True)
class Verdict:
    """What became of expectation number `index` of a scene.

    `step` is the step that decided it. Where it does not hold, `expected` and `got` say in words, with units,
    what the condition asks and what was measured.
    """

    index: int
    holds: bool
    step: int
    expected: str = ""
    got: str = ""


class Judge:
    """Judges `scene.expect` on `world`: make it at the start, `observe` after each step, read `verdicts`.

    An expectation speaks of the bodies that are there when it is looked at; those that come count as having started
    where they are first seen. If a body that it names has been deleted, or nothing is left that a pattern of it
    matches, it does not hold. Raises `ArgumentError` for what is no scene or no world.
    """

    def __init__(self, scene: Scene, world: World) -> None:
        check_kind("Judge", "a Scene", scene, Scene)
        check_world("Judge", world)
        self._world = world
        self._start = _kept(world.state)
        self._watches = [_Watch(k, wanted, world.state) for k, wanted in enumerate(scene.expect)]
        self._open = self._watches
        self.last_step = max((wanted.last_step for wanted in scene.expect), default=0)
        """The last step that an expectation names; a run must be at least as long."""
        self.observe()

    def observe(self) -> None:
        """Look at the world as it is now. An expectation that is decided costs nothing any more."""
        step, state = self._world.step_count, self._world.state
        if state.layout != self._start.layout:
            self._start = _followed(self._start, state)
            for watch in self._open:
                watch.aim(self._start)
        for watch in self._open:
            watch.observe(step, state)
        self._open = [watch for watch in self._open if watch.verdict is None]

    @property
    def failed(self) -> bool:
        """Whether an expectation is known by now not to hold, whatever comes."""
        return any(watch.verdict is not None and not watch.verdict.holds for watch in self._watches)

    def verdicts(self) -> tuple[Verdict, ...]:
        """One verdict an expectation, in the order of the scene; the run counts as over."""
        return tuple(watch.conclude(self._world.step_count) for watch in self._watches)

    def reached(self) -> tuple[Verdict, ...]:
        """Those of `verdicts` that this run is long enough for."""
        return tuple(watch.conclude(self._world.step_count) for watch in self._watches if watch.is_reached)


def _kept(state: State) -> State:
    """A state whose bodies, and who they are, stay as they are now."""
    return replace(state, bodies=state.bodies.copy(), census=Census(state.roster))


def _followed(start: State, now: State) -> State:
    """The bodies of now, where they started."""
    found = _kept(now)
    for row, serial in enumerate(now.roster.bodies.serials):
        before = start.roster.bodies.row_of(serial)
        if before is not None:
            found.bodies[row] = start.bodies[before]
    return found


class _Watch:
    """One expectation being watched; `verdict` is None until it is decided."""

    def __init__(self, index: int, wanted: Expectation, start: State) -> None:
        self._index = index
        self._wanted = wanted
        self.verdict: Verdict | None = None
        self.aim(start)

    def aim(self, start: State) -> None:
        """Find the bodies it speaks of, among those of `start`."""
        self._conditions = conditions(self._wanted, start)

    def observe(self, step: int, state: State) -> None:
        """Decide if `step` is one that can decide."""
        first, last = self._span(step)
        if not first <= step <= last:
            return
        broken, got = self._fault(state)
        if broken is None:
            # Once is enough, except for "always", which only the end of the run can confirm.
            if self._wanted.when != "always":
                self.verdict = Verdict(self._index, True, step)
        elif step == last:
            self.verdict = Verdict(self._index, False, step, broken.expected, got)

    @property
    def is_reached(self) -> bool:
        """Whether something can be said of it now: it is decided, or has held up to here."""
        return self.verdict is not None or self._wanted.when == "always"

    def conclude(self, step: int) -> Verdict:
        """The verdict now that the run is over after `step`."""
        if self.verdict is not None:
            return self.verdict
        if self._wanted.when == "always":
            return Verdict(self._index, True, step)
        expected = f"a run of at least {self._wanted.last_step} steps"
        return Verdict(self._index, False, step, expected, f"the run ended at step {step}")

    def _span(self, step: int) -> tuple[int, int]:
        """The steps at which this expectation is looked at; a fault at the last one is final."""
        if self._wanted.within is not None:
            return self._wanted.within
        return (self._wanted.at, self._wanted.at) if self._wanted.at is not None else (step, step)

    def _fault(self, state: State) -> tuple[Condition | None, str]:
        for condition in self._conditions:
            got = condition.fault(state)
            if got is not None:
                return condition, got
        return None, ""
