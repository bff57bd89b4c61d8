"""Who else steps a scene: pymunk, and the simple solver. Each gives its bodies as records, to be measured alike."""

from __future__ import annotations

import math
from typing import Literal, Protocol

from sandbox.reference.ask_pymunk import PYMUNK_VERSION
from sandbox.reference.simple.world import SimpleWorld, told_apart
from sandbox.reference.space import build_space, left_out
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

    label = f"pymunk {PYMUNK_VERSION}"

    def __init__(self, scene: FlatScene, start: Records) -> None:
        self._space, self._bodies = build_space(scene)
        self._seconds = 1.0 / scene.settings.step_rate
        self._start = BODY.zeros(len(start))
        self._start[:] = start
        self.notes = left_out(scene)

    def step(self) -> None:
        """Go on by one step of the scene."""
        self._space.step(self._seconds)

    def records(self) -> Records:
        """Poses and velocities of now as our table of bodies."""
        rows = BODY.zeros(len(self._start))
        rows[:] = self._start
        for row, body in zip(rows, self._bodies, strict=True):
            row.center_x, row.center_y = body.local_to_world(body.center_of_gravity)
            row.rotation_cos, row.rotation_sin = math.cos(body.angle), math.sin(body.angle)
            row.angle = body.angle
            row.velocity_x, row.velocity_y = body.velocity
            row.angular_velocity = body.angular_velocity
        return rows


def other_hands(name: TwinName, scene: FlatScene, start: Records) -> Other:
    """A scene in the hands of `name`; `start` are the bodies of our world at its start."""
    return SimpleTwin(scene) if name == "simple" else PymunkTwin(scene, start)
