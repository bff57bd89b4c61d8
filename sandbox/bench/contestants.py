"""The engines that take part, behind one face."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from sandbox.bench.course import Change, Course
from sandbox.bench.stages import TimedCalls
from sandbox.engine.world import World
from sandbox.reference.run import OtherRun, Pose

_POSE_COLUMNS = (
    "position_x", "position_y", "rotation_cos", "rotation_sin", "velocity_x", "velocity_y", "angular_velocity",
)  # fmt: skip
"""The columns of our table of bodies that make a `Pose`."""


class Contestant(Protocol):
    """A scene in the hands of one engine."""

    label: str

    @property
    def notes(self) -> tuple[str, ...]:
        """What of the scene the engine does otherwise or leaves out, a line each."""

    def apply(self, change: Change) -> None:
        """Do what happens between two steps."""

    def step(self) -> None:
        """Go on by one step."""

    def poses(self, names: Sequence[str]) -> list[Pose]:
        """Where bodies are and how they move."""

    def close(self) -> None:
        """Give back what it holds; nothing else may be asked after it."""


class Ours:
    """The scene in this engine, stepped by so many workers; with `profile`, the parts of its step are timed."""

    notes: tuple[str, ...] = ()

    def __init__(self, course: Course, profile: bool = False, workers: int = 1) -> None:
        self.label = "sandbox" if workers == 1 else f"sandbox, {workers} workers"
        self.world = World(course.scene, workers)
        self.stages: TimedCalls | None = TimedCalls.in_place(self.world) if profile else None
        self.step: Callable[[], None] = self.world.step

    def apply(self, change: Change) -> None:
        """Apply the commands."""
        for command in change.commands:
            self.world.apply(command)

    def poses(self, names: Sequence[str]) -> list[Pose]:
        """Where bodies are and how they move."""
        rows = self.world.state.bodies[[self.world.directory.body(name) for name in names]]
        columns = np.stack([rows[column] for column in _POSE_COLUMNS], axis=1)
        return [Pose(*row) for row in columns.tolist()]

    def close(self) -> None:
        """There is nothing to give back."""


class Theirs:
    """The scene in the hands of another engine."""

    def __init__(self, run: OtherRun) -> None:
        self._run = run
        self.label = run.label
        self.step: Callable[[], None] = run.step

    @property
    def notes(self) -> tuple[str, ...]:
        """What it does otherwise or leaves out of all that has been in the scene."""
        return self._run.notes

    def apply(self, change: Change) -> None:
        """Take out, bring in and push."""
        self._run.remove(change.gone)
        self._run.add(change.bodies, change.joints)
        for name, velocity, angular_velocity in change.velocities:
            self._run.set_velocity(name, velocity, angular_velocity)

    def poses(self, names: Sequence[str]) -> list[Pose]:
        """Where bodies are and how they move."""
        return [self._run.pose(name) for name in names]

    def close(self) -> None:
        """Give back what it holds; nothing else may be asked after it."""
        self._run.close()


def _pymunk(course: Course, _profile: bool) -> Contestant:
    from sandbox.reference.pymunk_run import PymunkRun

    return Theirs(PymunkRun(course.flat, course.iterations))


def _box2d(course: Course, _profile: bool) -> Contestant:
    from sandbox.reference.box2d_run import Box2dRun

    return Theirs(Box2dRun(course.flat))


ENGINES: dict[str, Callable[[Course, bool], Contestant]] = {"sandbox": Ours, "pymunk": _pymunk, "box2d": _box2d}
"""What builds a course in an engine, by the engine's name; `MissingDependencyError` where it is not installed."""


def contestant(name: str, course: Course, profile: bool) -> Contestant:
    """A course in an engine of `ENGINES`, or in `with_workers` of ours."""
    engine, _, workers = name.partition(" ")
    return Ours(course, profile, int(workers)) if workers else ENGINES[engine](course, profile)


def with_workers(workers: int) -> str:
    """The name of this engine when it has so many workers."""
    return "sandbox" if workers == 1 else f"sandbox {workers}"
