"""What all engines are put through: a scene, what its driver does to it, and who is in it."""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass
from typing import Any

from sandbox.bench.drivers import DRIVERS, Driver
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.motion import SetVelocity
from sandbox.engine.commands.spawn import Spawn
from sandbox.errors import SandboxError
from sandbox.scene import Scene
from sandbox.scene.expect import Inside
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec
from sandbox.scene.known import Known
from sandbox.scene.spawned import Spawning


@dataclass(frozen=True)
class Change:
    """What happens to a scene between two steps: `commands` for this engine, and the same for those who know none."""

    commands: tuple[Command, ...]
    gone: tuple[str, ...]
    bodies: tuple[FlatBody, ...]
    joints: tuple[FlatJoint, ...]
    velocities: tuple[tuple[str, Vec, float], ...]


class Course:
    """A scene, complete, and who is in it after the steps whose `change` was asked for, in order from 0."""

    def __init__(self, scene: Scene, name: str) -> None:
        self._driver = DRIVERS.get(name, Driver())
        self.scene = _completed(scene, self._driver)
        self.flat: FlatScene = self.scene.flatten()
        self.bodies: dict[str, FlatBody] = {body.id: body for body in self.flat.bodies}
        self._joints = list(self.flat.joints)
        self._spawning = Spawning(self.scene)

    @property
    def iterations(self) -> int:
        """How many iterations pymunk takes."""
        return self._driver.iterations

    def among(self, names: Container[str]) -> FlatScene:
        """The scene with those who are in it now, as far as they are among those names."""
        bodies = {name: body for name, body in self.bodies.items() if name in names}
        there = {None, *bodies}
        joints = tuple(joint for joint in self._joints if {joint.body_a, joint.body_b} <= there)
        return FlatScene(tuple(bodies.values()), self.flat.gravity, self.flat.settings, joints)

    @property
    def inside(self) -> tuple[float, float, float, float] | None:
        """[left, bottom, right, top] (m) in which the scene expects all that moves; None if it says nothing of it."""
        found = (each.inside for each in self.scene.expect if isinstance(each, Inside) and each.of is None)
        return next(found, None)

    def change(self, step: int) -> Change | None:
        """What is done to the scene after `step` steps."""
        commands = tuple(self._driver.commands(step))
        if not commands:
            return None
        gone: list[str] = []
        velocities: list[tuple[str, Vec, float]] = []
        bodies: list[FlatBody] = []
        joints: list[FlatJoint] = []
        for command in commands:
            match command:
                case Delete():
                    gone += [command.bodies] if isinstance(command.bodies, str) else command.bodies
                case SetVelocity():
                    velocities.append((command.body, command.velocity, command.angular_velocity))
                case Spawn():
                    found = self._spawning.read(
                        _listed(command.bodies), _listed(command.joints), self._known(), "Spawn"
                    )
                    bodies += found.bodies
                    joints += found.joints
                case _:
                    raise SandboxError(f"no other engine knows the command {type(command).__name__}")
        change = Change(commands, tuple(gone), tuple(bodies), tuple(joints), tuple(velocities))
        self._note(change)
        return change

    def _known(self) -> Known:
        return Known({name: body.type for name, body in self.bodies.items()})

    def _note(self, change: Change) -> None:
        for name in change.gone:
            del self.bodies[name]
        if change.gone:
            gone = set(change.gone)
            self._joints = [joint for joint in self._joints if not {joint.body_a, joint.body_b} & gone]
        self.bodies |= {body.id: body for body in change.bodies}
        self._joints += change.joints


def _completed(scene: Scene, driver: Driver) -> Scene:
    parts = driver.parts()
    if not parts:
        return scene
    data: Mapping[str, Any] = scene.to_data()
    return Scene(**{**data, **{key: [*data.get(key, ()), *entries] for key, entries in parts.items()}})


def _listed(words: Any) -> list[Any]:
    return [words] if isinstance(words, dict) else list(words)
