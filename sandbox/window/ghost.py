"""The ghost: another run of the scene, stepped in a thread, seen as outlines where it is not like the one shown."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.render.camera import Camera, Floats
from sandbox.render.contour import contour
from sandbox.render.frame import Frame, blend, capture
from sandbox.render.marks import Marks
from sandbox.render.strokes import joined, strokes
from sandbox.render.theme import Color
from sandbox.replay.golden.run import Run
from sandbox.replay.player import Player
from sandbox.replay.recording.recording_fields import Pose
from sandbox.window.threads import start_thread

AHEAD, KEPT = 8, 20
"""Steps that are taken before they are asked for, and moments that are kept."""
WIDTH, SEEN_PIXELS, MOST = 1.6, 0.75, 400
"""Of outlines, in pixels; how far a shape must be off to be outlined; how many are drawn at most."""


@dataclass(frozen=True)
class GhostMoment:
    """After a step: what is to be seen, and the records of the bodies `names`."""

    frame: Frame
    names: tuple[str, ...]
    bodies: Any

    def record(self, name: str) -> Any:
        """The record of a body; None if it is not there."""
        return self.bodies[self.names.index(name)] if name in self.names else None


class Ghost:
    """Plays `run` beside the one that is shown. `want` says where it is, `at` gives what is known."""

    def __init__(self, run: Run) -> None:
        self.length = run.steps
        self.trouble = ""
        """Why it goes no further; empty if it does."""
        self._moments: dict[int, GhostMoment] = {}
        self._wanted = 0
        self._closed = False
        self._goes = True
        self._changed = threading.Condition()
        self._run = run
        self._thread = start_thread(self._work, self.close)

    def want(self, step: int) -> None:
        """The step that is shown now."""
        if step != self._wanted:
            with self._changed:
                self._wanted = step
                self._changed.notify_all()

    def at(self, step: int) -> GhostMoment | None:
        """The moment after a step; None if it is not known yet."""
        return self._moments.get(step)

    def wait(self, step: int) -> GhostMoment | None:
        """The moment after a step, waited for; None if the run does not come there."""
        self.want(step)
        with self._changed:
            self._changed.wait_for(lambda: step in self._moments or step > self.length or not self._goes)
        return self.at(step)

    def frame(self, step: int, alpha: float) -> Frame | None:
        """What is seen between the step before and this one; None if it is not known yet."""
        here, before = self.at(step), self.at(step - 1)
        if here is None:
            return None
        return here.frame if before is None else blend(before.frame, here.frame, alpha)

    def close(self) -> None:
        """Play no more."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def _work(self) -> None:
        try:
            player = Player(self._run)
            while True:
                with self._changed:
                    while (step := self._next()) is None and not self._closed:
                        self._changed.wait()
                    if self._closed or step is None:
                        return
                player.seek(step)
                self._keep(step, player.world)
        except Exception as error:
            self.trouble = str(error)
            if not isinstance(error, SandboxError):
                raise  # a mistake of this program is told where it was made as well
        finally:
            with self._changed:
                self._goes = False
                self._changed.notify_all()

    def _next(self) -> int | None:
        """The step to go to: the one before the one wanted, to blend with, that itself, then those ahead."""
        here = min(self._wanted, self.length)
        steps = range(max(here - 1, 0), min(here + AHEAD, self.length) + 1)
        return next((step for step in steps if step not in self._moments), None)

    def _keep(self, step: int, world: World) -> None:
        known = self._moments.get(step - 1) or self._moments.get(step + 1)
        frame = capture(world.state, known.frame.mesh if known is not None else None)
        moment = GhostMoment(frame, tuple(world.names), world.state.bodies.copy())
        kept = sorted((one for one in self._moments if one != step), key=lambda one: abs(one - self._wanted))
        with self._changed:
            self._moments = {step: moment, **{one: self._moments[one] for one in kept[:KEPT]}}
            self._changed.notify_all()


def frame_at_poses(frame: Frame, bodies: Any, poses: dict[str, Pose]) -> Frame:
    """A frame with bodies at other poses of their origins; `bodies` are their records in `frame`."""
    center, angle = frame.center.copy(), frame.angle.copy()
    for row, name in enumerate(frame.roster.names):
        if name not in poses:
            continue
        x, y, turned = poses[name]
        body = bodies[row]
        c, s = np.cos(turned), np.sin(turned)
        u, v = body.local_center_x, body.local_center_y
        center[row] = x + c * u - s * v, y + s * u + c * v
        angle[row] = turned
    return replace(frame, center=center, angle=angle, rotation=np.column_stack([np.cos(angle), np.sin(angle)]))


def ghost_marks(ghost: Frame, shown: Frame, camera: Camera, color: Color) -> Marks:
    """Outlines of the shapes of `ghost` that are elsewhere than in `shown`, or not there at all."""
    alike: dict[bytes, list[int]] = {}
    for shape in _elsewhere(ghost, shown, camera.scale)[:MOST].tolist():
        alike.setdefault(_look(ghost, shape), []).append(shape)
    origin, axis = ghost.shape_poses()
    lines = []
    for shapes in alike.values():
        sides = _turned(_sides(ghost, shapes[0], camera.scale)[None], axis[shapes].T[:, :, None, None])
        ends = camera.to_screen(origin[shapes][:, None, None] + sides).reshape(-1, 2, 2)
        lines.append(strokes(ends[:, 0], ends[:, 1], WIDTH, color, 0.9))
    return Marks(strokes=joined(lines))


def _elsewhere(ghost: Frame, shown: Frame, scale: float) -> Any:
    """Rows of the shapes that are off by a visible amount, the farthest first."""
    here = _rows(ghost.roster.names, shown.roster.names)
    both = here >= 0
    off, turn = np.full(len(here), np.inf), np.zeros(len(here))
    off[both] = np.hypot(*(ghost.center[both] - shown.center[here[both]]).T)
    turn[both] = np.minimum(np.abs(ghost.angle[both] - shown.angle[here[both]]), 2.0)
    body = ghost.mesh.body
    pixels = (off[body] + turn[body] * ghost.mesh.reach) * scale
    order = np.argsort(-pixels, kind="stable")
    return order[pixels[order] > SEEN_PIXELS]


def _rows(names: Sequence[str], among: Sequence[str]) -> Any:
    """Where each of `names` is in `among`; -1 if it is not there."""
    if names == among:
        return np.arange(len(names))
    rows = {name: row for row, name in enumerate(among)}
    return np.array([rows.get(name, -1) for name in names], np.int64)


def _look(frame: Frame, shape: int) -> bytes:
    """The same for shapes that have the same outline in their own frames."""
    mesh = frame.mesh
    if shape in mesh.outlines:
        return mesh.outlines[shape].sides.tobytes()
    return mesh.core(shape).tobytes() + float(mesh.radius[shape]).hex().encode()


def _sides(frame: Frame, shape: int, scale: float) -> Floats:
    """The sides (k, 2, 2) of a shape's outline in its own frame, in metres."""
    mesh = frame.mesh
    if shape in mesh.outlines:
        return mesh.outlines[shape].sides
    corners = contour(mesh.core(shape), float(mesh.radius[shape]), 0.25 / scale)
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)


def _turned(points: Floats, axis: Floats) -> Floats:
    """Points (..., 2) turned by axes (cos, sin), each of which fits `points[..., 0]`."""
    c, s = axis
    x, y = points[..., 0], points[..., 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)
