"""What looks at a world while it runs, and keeps what a film is made of."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.world import World
from sandbox.render.camera import Camera, scene_camera
from sandbox.render.frame import Frame, capture, interesting_bounds
from sandbox.render.wardrobe import wardrobe_of
from sandbox.replay.recording.checkpoint import Checkpoint, checkpoint
from sandbox.report.bonds import bond, holding
from sandbox.report.cast import Actor, actors_of
from sandbox.report.film import Film
from sandbox.report.scenery import Sight
from sandbox.tables import Floats
from sandbox.world.records import STATIC

VIEW = (1600, 900)
"""Pixels for which the first view is chosen."""

MOST_SAMPLES = 5_000
"""Moments of a film, however few bodies there are."""


@dataclass
class _Sample:
    """One moment: the rows of the world's tables, and which bodies and joints of the film they are."""

    bodies: NDArray[np.int64]
    poses: Floats
    awake: NDArray[np.bool_]
    frozen: NDArray[np.bool_]
    joints: NDArray[np.int64]
    held: NDArray[np.bool_]


@dataclass
class Lens:
    """Looks at a world after each of its steps, up to step `end`."""

    world: World
    end: int
    most: int
    cast: dict[int, Actor] = field(default_factory=dict)
    bonds: dict[int, dict[str, Any]] = field(default_factory=dict)
    samples: list[_Sample] = field(default_factory=list)
    figures: list[Checkpoint] = field(default_factory=list)
    scenery: list[tuple[int, list[Any]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        world = self.world
        self.start = world.step_count
        self.frame: Frame = capture(world.state)
        self.wardrobe = wardrobe_of(world.state)
        self.bounds = interesting_bounds(self.frame)
        view = scene_camera(getattr(world.scene, "view", None), self.bounds, VIEW)
        self.sight = Sight(view, self.wardrobe.theme)
        steps, moving = self.end - self.start, self.frame.type != STATIC
        # What never moves takes no room in a page, but does here.
        weight = max(int(moving.sum()) + int((~moving).sum()) // 8, 1)
        self.every = max(1, -(-weight * steps // self.most), -(-steps // MOST_SAMPLES))
        self._meet()
        self._keep()

    def look(self) -> None:
        """Keep the moment if it is one to keep."""
        if (self.world.step_count - self.start) % self.every == 0:
            self._keep()

    def film(self, commands: tuple[tuple[int, str], ...], cut: str) -> Film:
        """All that was kept."""
        if self.figures[-1].step != self.world.step_count:
            self._keep()
        shape = len(self.cast), len(self.samples)
        poses = np.full((*shape, 3), np.nan)
        awake, frozen = np.zeros(shape, bool), np.zeros(shape, bool)
        held = np.zeros((len(self.bonds), len(self.samples)), bool)
        for k, sample in enumerate(self.samples):
            poses[sample.bodies, k] = sample.poses
            awake[sample.bodies, k], frozen[sample.bodies, k] = sample.awake, sample.frozen
            held[sample.joints, k] = sample.held
        view = self._view(poses)
        return Film(
            self.start, self.world.step_count, self.every, 1.0 / float(self.world.state.settings[0].step_seconds),
            tuple(self.cast.values()), poses, awake, frozen, tuple(self.figures), tuple(self.bonds.values()), held,
            tuple(self.scenery), (*view.center, VIEW[1] / view.scale), commands, cut,
        )  # fmt: skip

    def _view(self, poses: Floats) -> Camera:
        """The view that the scene asks for, or one that holds what moves, as long as it does not go too far."""
        x0, y0, x1, y1 = self.bounds
        room = max(x1 - x0, y1 - y0)
        moving = [not actor.data.get("static") for actor in self.cast.values()]
        reach = np.array([actor.data["reach"] for actor in self.cast.values()])[moving, None]
        for axis, (low, high) in enumerate(((x0, x1), (y0, y1))):
            places = poses[moving, :, axis]
            ends = np.array([np.nanmin(places - reach, initial=low), np.nanmax(places + reach, initial=high)])
            ends = np.clip(ends, low - room, high + room)
            x0, x1, y0, y1 = (*ends.tolist(), y0, y1) if axis == 0 else (x0, x1, *ends.tolist())
        return scene_camera(getattr(self.world.scene, "view", None), (x0, y0, x1, y1), VIEW)

    def _meet(self) -> None:
        """Get to know who came."""
        roster = self.world.state.roster
        self.wardrobe = self.wardrobe.fitting(self.frame)
        actors = actors_of(self.frame, self.wardrobe)
        for serial, actor in zip(roster.bodies.serials, actors, strict=True):
            self.cast.setdefault(serial, actor)
        places = {serial: slot for slot, serial in enumerate(self.cast)}
        self.rows = np.array([places[serial] for serial in roster.bodies.serials], np.int64)
        for serial, row in zip(roster.joints.serials, self.world.state.joints, strict=True):
            self.bonds.setdefault(serial, bond(row, self.rows.tolist()))
        places = {serial: slot for slot, serial in enumerate(self.bonds)}
        self.joint_rows = np.array([places[serial] for serial in roster.joints.serials], np.int64)

    def _keep(self) -> None:
        state = self.world.state
        layout = self.frame.mesh.layout
        self.frame = frame = capture(state, self.frame.mesh)
        if frame.mesh.layout != layout:
            self._meet()
        poses = np.column_stack([frame.center, frame.angle])
        known = self.rows, poses, frame.awake, frame.frozen, self.joint_rows, holding(state)
        self.samples.append(_Sample(*known))
        self.figures.append(checkpoint(self.world))
        scenery = self.sight.scenery(frame.fields, state, self.rows.tolist())
        if not self.scenery or scenery != self.scenery[-1][1]:
            self.scenery.append((len(self.samples) - 1, scenery))
