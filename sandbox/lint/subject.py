"""What rules see of a scene: as it is written, as it comes down to, and as its world begins."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import cos, hypot, sin
from typing import Any

from sandbox.engine.world import World
from sandbox.scene import Scene
from sandbox.scene.body_refs import matching_ids
from sandbox.scene.finding import Path, path_of
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec
from sandbox.scene.flat_rules import FlatAction, FlatCount, FlatSetting, FlatSpawn

Box = tuple[float, float, float, float]
"""Left, bottom, right, top, m."""


@dataclass(frozen=True)
class Subject:
    """A scene that loads."""

    scene: Scene

    @cached_property
    def data(self) -> dict[str, Any]:
        """As its author wrote it, as plain data."""
        return self.scene.written()

    @cached_property
    def words(self) -> dict[str, Any]:
        """The same with its expressions, if it has any."""
        found: dict[str, Any] = json.loads(self.scene.text) if self.scene.text is not None else self.data
        return found

    @cached_property
    def flat(self) -> FlatScene:
        """What it comes down to."""
        return self.scene.flatten()

    @cached_property
    def bodies(self) -> Mapping[str, FlatBody]:
        """The bodies by their ids."""
        return {body.id: body for body in self.flat.bodies}

    @cached_property
    def world(self) -> World:
        """The world after its first step, whose contacts are those of the start."""
        world = World(self.scene)
        world.step()
        return world

    @cached_property
    def masses(self) -> Mapping[str, float]:
        """kg, of dynamic bodies by their ids."""
        rows = World(self.scene).state.bodies
        pairs = zip(self.flat.bodies, rows.mass.tolist(), strict=True)
        return {body.id: mass for body, mass in pairs if body.type == "dynamic"}

    @cached_property
    def boxes(self) -> Mapping[str, Box]:
        """The box about each body at the start."""
        return {body.id: _box(body) for body in self.flat.bodies}

    @cached_property
    def actions(self) -> tuple[FlatAction, ...]:
        """All that rules and controls do."""
        done = [action for rule in self.flat.rules for action in rule.do]
        for control in self.flat.controls:
            done += [*control.press, *control.hold, *control.release]
        return tuple(done)

    def changes(self, counter: str) -> list[FlatCount]:
        """What rules and controls do to a counter."""
        return [action for action in self.actions if isinstance(action, FlatCount) and action.counter == counter]

    def start(self, counter: str) -> float:
        """What a counter starts with."""
        return self.scene.counters[counter]

    @cached_property
    def spawned(self) -> tuple[FlatBody, ...]:
        """Bodies that rules and controls bring, under the ids of their entries."""
        return tuple(a.body for a in self.actions if isinstance(a, FlatSpawn) and a.body is not None)

    def is_played(self, body: str) -> bool:
        """Whether rules or controls do something to a body, as far as can be told before."""
        return any(may_mean(action, body) for action in self.actions if not _is_about(action, "joint", "region"))

    def is_driven(self, joint: FlatJoint) -> bool:
        """Whether rules or controls change a joint."""
        return any(may_mean(action, joint.id) for action in self.actions if _is_about(action, "joint"))

    def named(self, ids: str | tuple[str, ...]) -> list[str]:
        """The bodies that ids and patterns mean, of those that are there at the start."""
        return matching_ids(ids, [*self.bodies])

    def ends(self, joint: FlatJoint) -> Iterator[tuple[FlatBody, Vec]]:
        """The bodies that a joint holds, each with its anchor."""
        for name, anchor in ((joint.body_a, joint.anchor_a), (joint.body_b, joint.anchor_b)):
            if name is not None and joint.joints is None:
                yield self.bodies[name], anchor


def path_to(part: FlatBody | FlatJoint) -> Path:
    """Where the entry stands that made a body or joint."""
    return path_of(part.pointer)


def reach(body: FlatBody) -> float:
    """From the origin of a body to its farthest point, m."""
    return max((hypot(x, y) + shape.radius for shape in body.shapes for x, y in shape.vertices), default=0.0)


def _box(body: FlatBody) -> Box:
    c, s, (px, py) = cos(body.angle), sin(body.angle), body.position
    rims = [(px + c * x - s * y, py + s * x + c * y, shape.radius) for shape in body.shapes for x, y in shape.vertices]
    return (
        min(x - r for x, _, r in rims), min(y - r for _, y, r in rims),
        max(x + r for x, _, r in rims), max(y + r for _, y, r in rims),
    )  # fmt: skip


def _is_about(action: FlatAction, *parts: str) -> bool:
    return isinstance(action, FlatSetting) and action.what in parts


def may_mean(action: FlatAction, name: str) -> bool:
    """Whether an action is for a body or joint; those of an event may be any."""
    return any(given.startswith("@") for given in action.of) or bool(matching_ids(action.of, [name]))
