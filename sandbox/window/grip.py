"""The hand that drags a body of a session, by a spring at the point where it was taken."""

from __future__ import annotations

from sandbox.engine.commands.drags import EndDrag, MoveDrag, StartDrag
from sandbox.engine.world import World
from sandbox.errors import CommandError
from sandbox.render.camera import Vec
from sandbox.render.frame import Frame
from sandbox.render.pick import pick
from sandbox.replay.timeline import Timeline

DRAG_ACCELERATION = 500.0
"""Limit of the drag force for each kilogram, in m/s^2."""


class Grip:
    """Holds one body at most; `target` (m) is where it is pulled to."""

    def __init__(self, timeline: Timeline) -> None:
        self._timeline = timeline
        self._held: int | None = None
        self._point: Vec = (0.0, 0.0)
        self.target: Vec = (0.0, 0.0)

    @property
    def body(self) -> int | None:
        """The row of the body that is held; None if there is none, or no more."""
        return None if self._held is None else self._world.state.census.bodies.row_of(self._held)

    def take(self, shown: Frame, now: Frame, point: Vec, slack: float) -> bool:
        """Take hold of the dynamic body at `point` (metres) where it is `shown`, and `now` where it is in the world.

        False if there is none within `slack` metres.
        """
        body = pick(shown, point, slack)
        if body is None:
            return False
        local = _to_body(shown, body, point)
        # The picture lags behind the world by up to a step: catch the point that was seen, where it is now.
        held, seen = shown.roster.serials[body], _to_world(now, body, local)
        row = self._world.state.census.bodies.row_of(held)
        if row is None or not self._begin(row, seen):
            return False
        self._held, self._point = held, local
        self.pull(point)
        return True

    def pull(self, point: Vec) -> None:
        """Pull the body towards `point`."""
        if self.body is not None and point != self.target:
            self._timeline.apply(MoveDrag(self._world.names[self.body], point))
            self.target = point

    def let_go(self) -> None:
        """Let go."""
        if self.body is not None:
            self._timeline.apply(EndDrag(self._world.names[self.body]))
        self._held = None

    def place(self, frame: Frame) -> Vec:
        """Where the point that is held is in `frame`, in metres."""
        assert self._held is not None
        row = frame.roster.row_of(self._held)
        assert row is not None
        return _to_world(frame, row, self._point)

    @property
    def _world(self) -> World:
        return self._timeline.world

    def _begin(self, body: int, point: Vec) -> bool:
        force = DRAG_ACCELERATION * float(self._world.state.bodies[body].mass)
        name = self._world.names[body]
        self._timeline.begin_act(f"Drag {name}")
        try:
            self._timeline.apply(StartDrag(name, point, force))
        except CommandError:
            self._timeline.end_act()
            return False
        self.target = point
        return True


def _to_body(frame: Frame, body: int, point: Vec) -> Vec:
    """A world point in the body's frame, from its centre of mass."""
    (c, s), (x, y) = frame.rotation[body], frame.center[body]
    dx, dy = point[0] - x, point[1] - y
    return float(c * dx + s * dy), float(c * dy - s * dx)


def _to_world(frame: Frame, body: int, local: Vec) -> Vec:
    """The inverse of `_to_body`."""
    (c, s), (x, y), (u, v) = frame.rotation[body], frame.center[body], local
    return float(x + c * u - s * v), float(y + s * u + c * v)
