"""This engine, at the defaults of a scene except that nothing sleeps."""

from __future__ import annotations

from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene, Vec

NAME = "sandbox"


class OurRun:
    """A `Run` of this engine."""

    def __init__(self, scene: FlatScene) -> None:
        self._world = World(scene)

    def step(self, steps: int = 1) -> None:
        self._world.step(steps)

    def place(self, name: str) -> Vec:
        return self._world.body(name).center

    def angle(self, name: str) -> float:
        return self._world.body(name).angle

    def velocity(self, name: str) -> Vec:
        return self._world.body(name).velocity

    def spin(self, name: str) -> float:
        return self._world.body(name).angular_velocity
