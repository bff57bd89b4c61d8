"""A world at this moment beside the same bodies and joints as they came into it: what has changed shows in between."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from sandbox.arguments import check_kind
from sandbox.errors import ArgumentError
from sandbox.scene.flat import FlatScene
from sandbox.scene.scene import Scene
from sandbox.tables import plain
from sandbox.world.build import build_state
from sandbox.world.checked_world import check_world
from sandbox.world.export.remarks import Remarks
from sandbox.world.field_records import NEVER
from sandbox.world.records import DYNAMIC, SURFACE
from sandbox.world.state import State

Flags = NDArray[np.bool_]

_POSE = ("center_x", "center_y", "angle")
_MOTION = ("velocity_x", "velocity_y", "angular_velocity", "type")
_REPORTED = (
    *(f"impulse_{k}" for k in range(5)), *(f"preload_{k}" for k in range(3)), "force_x", "force_y", "torque"
)  # fmt: skip
"""What a joint did in the last step, and in the first one."""
_PLACED = ("anchor_ax", "anchor_ay", "anchor_bx", "anchor_by", "axis_x", "axis_y")


class Motion(NamedTuple):
    """Place and motion of a body: columns of its record, as Python's own numbers."""

    position_x: float
    position_y: float
    angle: float
    velocity_x: float
    velocity_y: float
    angular_velocity: float
    center_x: float
    center_y: float
    rotation_cos: float
    rotation_sin: float
    local_center_x: float
    local_center_y: float
    type: int


class AnyWorld(Protocol):
    """As much of a world as is needed to write it down."""

    @property
    def state(self) -> State:
        """Its records."""

    @property
    def scene(self) -> Any:
        """What it was made of."""


class Present:
    """The `state` of a world, the `scene` it began with, and `start`: its rows as if they had just been built.

    Flags are row by row; those of bodies have one more at the end, for the world, which is row -1.
    """

    def __init__(self, call: str, world: AnyWorld, scene: Scene | None) -> None:
        check_world(call, world)
        if scene is not None:
            check_kind(call, "a Scene for scene", scene, Scene)
        self.state = world.state
        self.scene = _author(world, scene)
        self.start = build_state(self.state.roster.flat)
        self.remarks = Remarks()
        self.now = int(self.state.counters[0].step_count)
        self.step_rate = self.scene.settings.step_rate

    @cached_property
    def moved(self) -> Flags:
        """Bodies that are elsewhere than they came."""
        return _with_world(_differ(self.state.bodies, self.start.bodies, _POSE))

    @cached_property
    def in_motion(self) -> Flags:
        """Bodies that are elsewhere, or on another way, than they came."""
        return self.moved | _with_world(_differ(self.state.bodies, self.start.bodies, _MOTION))

    @cached_property
    def resurfaced(self) -> Flags:
        """Bodies of which some shape has another surface."""
        state, found = self.state, np.zeros(len(self.moved), np.bool_)
        found[state.shapes.body[_differ(state.shapes, self.start.shapes, SURFACE)]] = True
        return found

    @cached_property
    def rethrust(self) -> Flags:
        """Bodies of which some thruster pushes otherwise, or at other times from now on."""
        thrusters, start = self.state.thrusters, self.start.thrusters
        found = np.zeros(len(self.moved), np.bool_)
        others = _differ(thrusters, start, ("force_x", "force_y"))
        for row in range(len(thrusters)):
            if others[row] or self.rescheduled(thrusters[row], start[row]):
                found[thrusters.body[row]] = True
        return found

    @cached_property
    def paths(self) -> dict[int, int]:
        """The row of its path for each body that follows one."""
        return {body: row for row, body in enumerate(plain(self.state.paths)["body"].tolist())}

    @cached_property
    def changed(self) -> Flags:
        """Bodies of which anything is different."""
        found = self.in_motion | self.resurfaced | self.rethrust
        found[plain(self.state.paths)["body"][_differ(self.state.paths, self.start.paths, ("steps", "enabled"))]] = True
        return found

    @cached_property
    def motions(self) -> tuple[list[Motion], list[Motion]]:
        """Place and motion of every body now, and as it came."""
        return _motions(self.state), _motions(self.start)

    @cached_property
    def held_still(self) -> Flags:
        """Joints whose bodies, anchors and axes are where they were."""
        joints: Any = self.state.joints
        moved = self.moved[joints.body_a] | self.moved[joints.body_b]
        still: Flags = ~moved & ~_differ(joints, self.start.joints, _PLACED)
        return still

    @cached_property
    def rejoined(self) -> Flags:
        """Joints of which anything is different."""
        joints = self.state.joints
        columns = [name for name in plain(joints).dtype.names or () if name not in _REPORTED]
        return ~self.held_still | _differ(joints, self.start.joints, columns)

    def is_fixed(self, row: int) -> bool:
        """Whether a body, or the world (-1), cannot be pushed."""
        return row < 0 or int(self.state.bodies[row].type) != DYNAMIC

    def rescheduled(self, row: Any, first: Any) -> tuple[int, int] | None:
        """First step of a region or thruster and the first one after it, from now on; (NEVER, NEVER) once over.

        None if they are those that it began with, as `first`.
        """
        before, after = (int(first.start_step), int(first.end_step)), (int(row.start_step), int(row.end_step))
        if self.now == 0 and before == after:
            return None
        start, end = max(after[0] - self.now, 0), after[1] if after[1] == NEVER else after[1] - self.now
        found = (start, end) if start < end else (NEVER, NEVER)
        return None if found == before else found


def _author(world: AnyWorld, scene: Scene | None) -> Scene:
    """The scene that a world began with."""
    found = world.scene if scene is None else scene
    if isinstance(found, FlatScene) or not isinstance(found, Scene):
        raise ArgumentError("the world was made of a flat scene: give the Scene that it came from, as scene=")
    flat = world.state.census.scene
    if found.flatten() is not flat and found.flatten() != flat:
        raise ArgumentError("the world did not begin with this scene: give the one that it was made of")
    return found


def _motions(state: State) -> list[Motion]:
    bodies = plain(state.bodies)
    return list(map(Motion._make, zip(*(bodies[name].tolist() for name in Motion._fields), strict=True)))


def _with_world(flags: Flags) -> Flags:
    """With a row for the world, of which nothing changes."""
    return np.append(flags, np.False_)


def _differ(rows: Any, others: Any, names: Any) -> Flags:
    found = np.zeros(len(rows), np.bool_)
    for name in names:
        found |= plain(rows)[name] != plain(others)[name]
    return found
