"""Recording a film: what is kept of a world while it runs."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.world import World
from sandbox.errors import CapacityError
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera, scene_camera
from sandbox.render.frame import Frame, capture, interesting_bounds
from sandbox.render.scoreboard import score_words
from sandbox.render.theme import DARK, Theme
from sandbox.replay.recording.checkpoint import Checkpoint, checkpoint
from sandbox.report.body_data import FilmBody, film_bodies
from sandbox.report.field_data import FieldSampler
from sandbox.report.film import Film
from sandbox.report.joint_data import held_joints, joint_data
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
class FilmRecorder:
    """Records a world after each of its steps, up to step `end`; keeps about `most` poses of moving bodies."""

    world: World
    end: int
    most: int
    theme: Theme = DARK
    bodies: dict[int, FilmBody] = field(default_factory=dict)
    joints: dict[int, dict[str, Any]] = field(default_factory=dict)
    samples: list[_Sample] = field(default_factory=list)
    figures: list[Checkpoint] = field(default_factory=list)
    fields: list[tuple[int, list[Any]]] = field(default_factory=list)
    score: list[tuple[int, str]] = field(default_factory=list)

    def __post_init__(self) -> None:
        world = self.world
        self.start = world.step_count
        self.frame: Frame = capture(world.state)
        self.body_colors = body_colors_of(world.state, self.theme)
        self.bounds = interesting_bounds(self.frame)
        view = scene_camera(getattr(world.scene, "view", None), self.bounds, VIEW)
        self.field_sampler = FieldSampler(view, self.theme)
        steps, moving = self.end - self.start, self.frame.type != STATIC
        # What never moves takes no room in a page, but does here.
        weight = max(int(moving.sum()) + int((~moving).sum()) // 8, 1)
        self.every = max(1, -(-weight * steps // self.most), -(-steps // MOST_SAMPLES))
        self._add_newcomers()
        self._add_sample()

    def record(self) -> None:
        """Keep the moment if it is one to keep."""
        if (self.world.step_count - self.start) % self.every == 0:
            self._add_sample()

    def film(self, commands: tuple[tuple[int, str], ...], cut: str) -> Film:
        """All that was kept."""
        if self.figures[-1].step != self.world.step_count:
            self._add_sample()
        shape = len(self.bodies), len(self.samples)
        poses = np.full((*shape, 3), np.nan)
        awake, frozen = np.zeros(shape, bool), np.zeros(shape, bool)
        held = np.zeros((len(self.joints), len(self.samples)), bool)
        for k, sample in enumerate(self.samples):
            poses[sample.bodies, k] = sample.poses
            awake[sample.bodies, k], frozen[sample.bodies, k] = sample.awake, sample.frozen
            held[sample.joints, k] = sample.held
        view = self._view(poses)
        return Film(
            self.start, self.world.step_count, self.every, 1.0 / float(self.world.state.settings[0].step_seconds),
            tuple(self.bodies.values()), poses, awake, frozen, tuple(self.figures), tuple(self.joints.values()), held,
            tuple(self.fields), (*view.center, VIEW[1] / view.scale), commands, cut, self.theme,
            tuple(self.score),
        )  # fmt: skip

    def _view(self, poses: Floats) -> Camera:
        """The view that the scene asks for, or one that holds what moves, as long as it does not go too far."""
        x0, y0, x1, y1 = self.bounds
        room = max(x1 - x0, y1 - y0)
        moving = [not body.data.get("static") for body in self.bodies.values()]
        reach = np.array([body.data["reach"] for body in self.bodies.values()])[moving, None]
        for axis, (low, high) in enumerate(((x0, x1), (y0, y1))):
            places = poses[moving, :, axis]
            ends = np.array([np.nanmin(places - reach, initial=low), np.nanmax(places + reach, initial=high)])
            ends = np.clip(ends, low - room, high + room)
            x0, x1, y0, y1 = (*ends.tolist(), y0, y1) if axis == 0 else (x0, x1, *ends.tolist())
        return scene_camera(getattr(self.world.scene, "view", None), (x0, y0, x1, y1), VIEW)

    def _add_newcomers(self) -> None:
        """Take up the bodies and joints that came into the world."""
        roster = self.world.state.roster
        self.body_colors = self.body_colors.for_frame(self.frame)
        serials = roster.bodies.serials
        new = [row for row, serial in enumerate(serials) if serial not in self.bodies]
        for row, body in zip(new, film_bodies(self.frame, self.body_colors, new), strict=True):
            self.bodies[serials[row]] = body
        places = {serial: slot for slot, serial in enumerate(self.bodies)}
        self.rows = np.array([places[serial] for serial in serials], np.int64)
        slots = self.rows.tolist()
        for serial, row in zip(roster.joints.serials, self.world.state.joints, strict=True):
            if serial not in self.joints:
                self.joints[serial] = joint_data(row, slots)
        places = {serial: slot for slot, serial in enumerate(self.joints)}
        self.joint_rows = np.array([places[serial] for serial in roster.joints.serials], np.int64)

    def _add_sample(self) -> None:
        state = self.world.state
        layout = self.frame.mesh.layout
        self.frame = frame = capture(state, self.frame.mesh)
        if frame.mesh.layout != layout:
            self._add_newcomers()
        poses = np.column_stack([frame.center, frame.angle])
        known = self.rows, poses, frame.awake, frame.frozen, self.joint_rows, held_joints(state)
        self.samples.append(_Sample(*known))
        self.figures.append(_figures(self.world))
        fields = self.field_sampler.sample(frame.fields, state, self.rows.tolist())
        if not self.fields or fields != self.fields[-1][1]:
            self.fields.append((len(self.samples) - 1, fields))
        score = score_words(self.world)
        if not self.score or score != self.score[-1][1]:
            self.score.append((len(self.samples) - 1, score))


def _figures(world: World) -> Checkpoint:
    """Those of now. Contacts are found when a step begins: before the first one, a copy takes it."""
    known = checkpoint(world)
    if world.step_count > 0:
        return known
    twin = copy(world)
    try:
        twin.step()
    except CapacityError:
        return known
    first = checkpoint(twin)
    return replace(known, contacts=first.contacts, deepest=first.deepest)
