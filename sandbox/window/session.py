"""A scene being played: world, clock, the last two frames and the hand that drags. Knows no window."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sandbox.engine.commands.drags import EndDrag, MoveDrag, StartDrag
from sandbox.engine.world import World
from sandbox.errors import CommandError, SandboxError
from sandbox.render.camera import Bounds, Vec
from sandbox.render.frame import Frame, blend, capture, interesting_bounds
from sandbox.render.pick import pick
from sandbox.window.clock import StepClock
from sandbox.window.session_recorder import SessionRecorder

if TYPE_CHECKING:
    from sandbox.replay.recording.command_words import TimedCommand
    from sandbox.scene import Scene

MOST_STEPS = 8
"""Steps a frame at most, however much time has passed."""
FRAME_BUDGET = 0.05
"""Seconds a frame may spend on steps, so that a heavy scene runs slower but stays responsive."""
DRAG_ACCELERATION = 500.0
"""Limit of the drag force for each kilogram, in m/s^2."""


class Session:
    """One scene from its start; `restart` begins again. `script` is what a recording did to it."""

    def __init__(self, scene: Scene, world: World, script: Sequence[TimedCommand] = ()) -> None:
        self.scene = scene
        self.world = world
        self._script = script
        self._recorder = SessionRecorder(world, script)
        self.trouble = ""
        """What went wrong last, for the user."""
        self.clock = StepClock(float(world.state.settings[0].step_seconds))
        self.step_cost = 0.0
        self._held: int | None = None
        self.target: Vec = (0.0, 0.0)
        self._grip: Vec = (0.0, 0.0)
        self.previous = self.current = capture(world.state)
        self.home = interesting_bounds(self.current)
        """What is worth looking at when the scene begins, in metres."""

    def update(self, elapsed: float) -> int:
        """Let `elapsed` seconds of real time pass; gives the number of steps taken."""
        most = MOST_STEPS if self.step_cost == 0.0 else int(FRAME_BUDGET / self.step_cost)
        steps = self.clock.advance(elapsed, min(max(most, 1), MOST_STEPS))
        for _ in range(steps):
            self._step()
        return steps

    def step_once(self) -> None:
        """Take one step and show it exactly."""
        self._step()
        self.clock.snap_to_step()

    def skip(self, steps: int) -> None:
        """Take many steps unseen."""
        for _ in range(steps):
            self._recorder.step()
        self.previous = self.current = capture(self.world.state, self.current.mesh)

    def restart(self) -> None:
        """Begin again from the scene as it was written."""
        self._held = None
        self.world = World(self.scene, self.world.workers)
        self._recorder = SessionRecorder(self.world, self._script)
        self.previous = self.current = capture(self.world.state, self.current.mesh)

    def save_recording(self, folder: Path) -> Path:
        """Write all steps and commands since the start into a new file in `folder`, for `sandbox replay`.

        Raises `RecordingError` if there is nothing to write, `OSError` if it cannot be written.
        """
        return self._recorder.save(folder)

    def frame(self) -> Frame:
        """What is to be seen now: between the last two steps, as far as the clock says."""
        if self.current.mesh.layout != self.world.layout:  # bodies came or went between two steps
            self.previous = self.current = capture(self.world.state)
        return blend(self.previous, self.current, self.clock.alpha)

    def bounds(self) -> Bounds:
        """What is worth looking at now, in metres."""
        return interesting_bounds(self.current)

    @property
    def grabbed(self) -> int | None:
        """The row of the body that is held; None if there is none, or no more."""
        return None if self._held is None else self.world.state.census.bodies.row_of(self._held)

    def grab(self, point: Vec, slack: float) -> bool:
        """Take hold of the dynamic body at `point` (metres); False if there is none within `slack` metres."""
        frame = self.frame()
        body = pick(frame, point, slack)
        if body is None:
            return False
        grip = _to_body(frame, body, point)
        # The picture lags behind the world by up to a step: catch the point that was seen, where it is now.
        held, seen = frame.roster.serials[body], _to_world(self.current, body, grip)
        row = self.world.state.census.bodies.row_of(held)
        if row is None or not self._send_grab(row, seen):
            return False
        self._held, self._grip = held, grip
        self.drag(point)
        return True

    def drag(self, point: Vec) -> None:
        """Pull the grabbed body towards `point`."""
        if self.grabbed is not None and point != self.target:
            self._recorder.apply(MoveDrag(self.world.names[self.grabbed], point))
            self.target = point

    def release(self) -> None:
        """Let go."""
        if self.grabbed is not None:
            self._recorder.apply(EndDrag(self.world.names[self.grabbed]))
        self._held = None

    def grip(self, frame: Frame) -> Vec:
        """Where the grabbed point of the body is in `frame`, in metres."""
        assert self._held is not None
        row = frame.roster.row_of(self._held)
        assert row is not None
        return _to_world(frame, row, self._grip)

    def _send_grab(self, body: int, point: Vec) -> bool:
        force = DRAG_ACCELERATION * float(self.world.state.bodies[body].mass)
        try:
            self._recorder.apply(StartDrag(self.world.names[body], point, force))
        except CommandError:
            return False
        self.target = point
        return True

    def _step(self) -> None:
        try:
            cost = self._recorder.step()
        except SandboxError as error:
            self.trouble, cost = str(error), self._recorder.step()
        self.step_cost = cost if self.step_cost == 0.0 else 0.9 * self.step_cost + 0.1 * cost
        self.previous, self.current = self.current, capture(self.world.state, self.current.mesh)


def _to_body(frame: Frame, body: int, point: Vec) -> Vec:
    """A world point in the body's frame, from its centre of mass."""
    (c, s), (x, y) = frame.rotation[body], frame.center[body]
    dx, dy = point[0] - x, point[1] - y
    return float(c * dx + s * dy), float(c * dy - s * dx)


def _to_world(frame: Frame, body: int, local: Vec) -> Vec:
    """The inverse of `_to_body`."""
    (c, s), (x, y), (u, v) = frame.rotation[body], frame.center[body], local
    return float(x + c * u - s * v), float(y + s * u + c * v)
