"""The race: a scene in several engines, a few steps each in turns, all in one process.

Times are CPU times of this process: other work on the machine slows it down, but is not counted. Where an engine has
several workers, they are the times of a clock. As a slow moment meets all engines alike, the median of the turns'
ratios is steadier than any time.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from sandbox.bench.contestants import Contestant, Ours, contestant
from sandbox.bench.course import Change, Course
from sandbox.bench.memory import peak_resident_bytes, table_bytes
from sandbox.bench.quality import Judge, Quality
from sandbox.engine.compile_step import wait_for_all
from sandbox.scene import Scene
from sandbox.world.build import build_state

TURNS = 10


@dataclass(frozen=True)
class Own:
    """What is known of this engine alone. `stages` are milliseconds a step by part, empty unless it was profiled."""

    digest: str
    contacts: int
    awake: int
    frozen: int
    table_bytes: int
    stages: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Result:
    """One engine's race. Times in milliseconds: to `build` it, of the `first` step, and a step in each of the `turns`.

    What is changed between steps is part of both; `changes` is its share of a step in the turns, ms. `ratio` is the
    median over the turns of our time over this engine's; None without us, or without turns.
    """

    name: str
    label: str
    notes: tuple[str, ...]
    build: float
    first: float
    turns: tuple[float, ...]
    changes: float
    ratio: float | None
    quality: Quality
    own: Own | None

    @property
    def step(self) -> float | None:
        """The median of the turns, ms; None if there was but one step."""
        return statistics.median(self.turns) if self.turns else None


@dataclass(frozen=True)
class Race:
    """All engines on one scene, and how large it was at the end."""

    steps: int
    bodies: int
    shapes: int
    joints: int
    peak_resident_bytes: int | None
    results: tuple[Result, ...]


class _Lane:
    """One engine and its times, in seconds."""

    def __init__(self, name: str, course: Course, profile: bool, clock: Callable[[], float]) -> None:
        self.name = name
        self._clock = clock
        start = clock()
        self.contestant: Contestant = contestant(name, course, profile)
        self.build = clock() - start
        self.first = self.changing = 0.0
        self.turns: list[float] = []

    def begin_turns(self) -> None:
        """The turns begin: what the first step took is not theirs."""
        self.changing = 0.0
        if isinstance(self.contestant, Ours) and self.contestant.stages is not None:
            self.contestant.stages.forget_times()

    def go(self, changes: Sequence[Change | None]) -> float:
        """Take a step for each of `changes`, after it; how long one took, on the mean."""
        engine, clock = self.contestant, self._clock
        start = clock()
        for change in changes:
            if change is not None:
                before = clock()
                engine.apply(change)
                self.changing += clock() - before
            engine.step()
        return (clock() - start) / len(changes)


def run_race(
    course: Course, engines: Sequence[str], steps: int, profile: bool, on_steps: Callable[[int], None] | None = None
) -> Race:
    """Put `engines` through so many steps (1 or more) of a new course, in up to `TURNS` turns after the first step.

    `on_steps` hears how many steps all have taken. Raises `MissingDependencyError` for an engine that is not installed,
    and what a scene may raise that cannot be stepped.
    """
    _warm_up(engines, bool(course.flat.joints))
    alone = all(" " not in name for name in engines)
    clock = time.process_time if alone else time.perf_counter
    lanes = [_Lane(name, course, profile, clock) for name in engines]
    first = [course.change(0)]
    for lane in lanes:
        lane.first = lane.go(first)
        lane.begin_turns()
    for begin, end in _turns(steps):
        changes = [course.change(step) for step in range(begin, end)]
        for lane in lanes:
            lane.turns.append(lane.go(changes))
        lanes.append(lanes.pop(0))  # nobody always goes first
        if on_steps is not None:
            on_steps(end)
    return _finished(course, sorted(lanes, key=lambda lane: engines.index(lane.name)), steps)


def _turns(steps: int) -> list[tuple[int, int]]:
    """(first step, step after the last) of each turn; the very first step is none of them."""
    count = min(TURNS, steps - 1)
    return list(pairwise(1 + (steps - 1) * k // count for k in range(count + 1))) if count else []


def _finished(course: Course, lanes: Sequence[_Lane], steps: int) -> Race:
    ours = next((lane for lane in lanes if isinstance(lane.contestant, Ours)), None)
    here = ours.contestant.world.state if ours and isinstance(ours.contestant, Ours) else None
    if here is not None and set(here.names) == set(course.bodies):
        judged = here
    else:  # rules have brought bodies or taken some away, which other engines know nothing of
        judged = build_state(course.among(course.bodies if here is None else set(here.names)))
    judge = Judge(judged, course.inside)
    results = tuple(_result(lane, ours, judge.judge(lane.contestant.poses(judged.names)), steps) for lane in lanes)
    state = judged if here is None else here
    sizes = len(state.bodies), len(state.shapes), len(state.joints)
    for lane in lanes:
        lane.contestant.close()
    return Race(steps, *sizes, peak_resident_bytes(), results)


def _result(lane: _Lane, ours: _Lane | None, quality: Quality, steps: int) -> Result:
    engine = lane.contestant
    return Result(
        lane.name, engine.label, engine.notes, 1e3 * lane.build, 1e3 * lane.first,
        tuple(1e3 * seconds for seconds in lane.turns), 1e3 * lane.changing / max(1, steps - 1), _ratio(ours, lane),
        quality,
        _own(engine, steps) if isinstance(engine, Ours) else None,
    )  # fmt: skip


def _ratio(ours: _Lane | None, lane: _Lane) -> float | None:
    if ours is None:
        return None
    # A clock that ticks slowly may not have seen a turn.
    ratios = [a / b for a, b in zip(ours.turns, lane.turns, strict=True) if b > 0.0]
    return statistics.median(ratios) if ratios else None


def _own(contestant: Ours, steps: int) -> Own:
    world, stages = contestant.world, {}
    if contestant.stages is not None and steps > 1:
        stages = {name: 1e3 * seconds / (steps - 1) for name, seconds in contestant.stages.seconds.items()}
    digest, contacts, frozen = world.digest(), len(world.contacts), len(world.frozen)
    return Own(digest, contacts, world.awake_count, frozen, table_bytes(world), stages)


def _warm_up(engines: Sequence[str], joints: bool) -> None:
    """Import, compile or load what a step needs before anything is timed, so that a first step is the scene's own."""
    shapes = [{"circle": 0.5}]
    bodies = [
        {"id": "ball", "shapes": shapes},
        {"id": "shot", "shapes": shapes, "position": [0.0, 9.0], "velocity": [0.0, -900.0], "bullet": True},
    ]
    pins = [{"id": "pin", "type": "revolute", "bodies": ["ball", None], "anchor": [0.0, 0.0]}] if joints else []
    scene = Scene(bodies=bodies, joints=pins)
    for name in engines:
        engine = contestant(name, Course(scene, ""), False)
        engine.step()
        engine.step()
        if isinstance(engine, Ours):
            engine.world._stepper.bind_workers()  # so small a scene is not shared
    wait_for_all()
