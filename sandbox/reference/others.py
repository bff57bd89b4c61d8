"""Who else steps a scene: pymunk, and the simple solver. Each gives its bodies as records, to be measured alike."""

from __future__ import annotations

import math
from typing import Literal, Protocol

from sandbox.reference.pymunk_run import PymunkRun
from sandbox.reference.simple.world import SimpleWorld, told_apart
from sandbox.reference.space import left_out
from sandbox.scene.flat import FlatScene
from sandbox.tables import Records
from sandbox.world.records import BODY

TwinName = Literal["pymunk", "simple"]


class Other(Protocol):
    """A scene in other hands. `label` names them in pictures, `notes` say what they do otherwise, a line each."""

    label: str
    notes: tuple[str, ...]

    def step(self) -> None:
        """Go on by one step of the scene."""

    def records(self) -> Records:
        """Poses and velocities of now as our table of bodies."""


class SimpleTwin:
    """The scene under the simple solver, with the techniques of its settings.

    Raises `SandboxError` for a scene with more in it than contacts.
    """

    label = "simple solver"

    def __init__(self, scene: FlatScene) -> None:
        self._world = SimpleWorld(scene)
        self.notes = told_apart(scene)

    def step(self) -> None:
        """Go on by one step of the scene."""
        self._world.step()

    def records(self) -> Records:
        """Poses and velocities of now as our table of bodies."""
        return self._world.records()


class PymunkTwin:
    """The scene in pymunk at its defaults, with one `Space.step` for each step; `start` are our bodies at its start."""

    label = PymunkRun.label

    def __init__(self, scene: FlatScene, start: Records) -> None:
        self._run = PymunkRun(scene, sleeps=False)
        self._names = [body.id for body in scene.bodies]
        self._start = BODY.zeros(len(start))
        self._start[:] = start
        self.notes = (*left_out(scene), *self._run.notes)

    def step(self) -> None:
        """Go on by one step of the scene."""
        self._run.step()

    def records(self) -> Records:
        """Poses and velocities of now as our table of bodies; angles within a turn."""
        rows = BODY.zeros(len(self._start))
        rows[:] = self._start
        for row, name in zip(rows, self._names, strict=True):
            x, y, cos, sin, row.velocity_x, row.velocity_y, row.angular_velocity = self._run.pose(name)
            row.position_x, row.position_y, row.rotation_cos, row.rotation_sin = x, y, cos, sin
            row.angle = math.atan2(sin, cos)
            row.center_x = x + (cos * row.local_center_x - sin * row.local_center_y)
            row.center_y = y + (sin * row.local_center_x + cos * row.local_center_y)
        return rows


def other_hands(name: TwinName, scene: FlatScene, start: Records) -> Other:
    """A scene in the hands of `name`; `start` are the bodies of our world at its start."""
    return SimpleTwin(scene) if name == "simple" else PymunkTwin(scene, start)
