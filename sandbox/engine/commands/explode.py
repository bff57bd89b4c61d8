"""The command that pushes everything near a point away from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from sandbox._jit import Door, kernel_argument
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.bodies.blast import BLAST, BLASTED, UNKNOWN, push_away
from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec
from sandbox.engine.commands.checks import SPEED_LIMIT, title
from sandbox.engine.commands.pushes import ApplyImpulse
from sandbox.errors import CommandError
from sandbox.geometry.checks import LARGEST, SMALLEST
from sandbox.geometry.collide import holds
from sandbox.tables import Floats, Integers, Records, plain
from sandbox.world.runs import run_starts
from sandbox.world.state import State

_PUSH_AWAY = Door(push_away)


@dataclass(frozen=True)
class Explode(Command):
    """Push all dynamic bodies within `radius` (m) away from `point` (m) at once.

    A shape gets `impulse` (N s) for each metre of its width as seen from the point, at its nearest place, less the
    farther away that is: nothing at the radius, all of it at the point. A negative impulse pulls. Walls do not shield.
    """

    point: Vec
    radius: float
    impulse: float

    def apply(self, target: CommandTarget) -> Touched:
        """Push all or none: bodies that cannot take their push keep the others from theirs."""
        if not SMALLEST <= self.radius <= LARGEST:
            bounds = f"from {SMALLEST:g} to {LARGEST:g} m"
            raise CommandError(f"Explode: radius must be {bounds}, not {self.radius:g}; give one within these")
        state, rows = target.state, _rows_in_reach(target, self)
        bodies = plain(state.bodies)
        before, reached = bodies[rows], _Reached.of(state, rows)
        try:
            reached.push(state, self)
        except CommandError:
            bodies[rows] = before
            raise
        pushed = plain(reached.shapes)["body"][plain(reached.shapes)["pushed"] == 1]
        return Touched(bodies=wake_bodies(state, pushed))


def _rows_in_reach(target: CommandTarget, command: Explode) -> Integers:
    """The rows of the dynamic bodies with a solid shape in reach, in order."""
    from sandbox.engine.queries.filter import Filter
    from sandbox.geometry.shapes import Circle

    seen = target.query.overlap_shape(Circle(command.point, command.radius), Filter(types=("dynamic",)))
    return np.unique(plain(target.state.shapes)["body"][np.array([hit.shape for hit in seen], np.int64)])


class _Reached(NamedTuple):
    """The solid shapes of some bodies: rows of `BLASTED`, and the corners of their cores in the world (m)."""

    shapes: Records
    xs: Floats
    ys: Floats

    @classmethod
    def of(cls, state: State, rows: Integers) -> _Reached:
        """Those of the bodies in those rows, as their author numbered the corners."""
        items = state.census.bodies.items
        solid = [(row, shape) for row in rows.tolist() for shape in items[row].shapes if not shape.sensor]
        counts = np.array([len(shape.vertices) for _, shape in solid], np.int64)
        shapes = BLASTED.zeros(len(solid))
        shapes.body, shapes.holds = [row for row, _ in solid], UNKNOWN
        shapes.start, shapes.count = run_starts(counts), counts
        shapes.radius = [shape.radius for _, shape in solid]
        corners = np.array([corner for _, shape in solid for corner in shape.vertices], float).reshape(-1, 2)
        u, v = corners.T
        body = plain(state.bodies)[np.repeat(shapes.body, counts)]
        x, y, cos, sin = (body[name] for name in ("position_x", "position_y", "rotation_cos", "rotation_sin"))
        return cls(shapes, x + (cos * u - sin * v), y + (sin * u + cos * v))

    def push(self, state: State, command: Explode) -> None:
        """Push them all, one after the other. Raises `CommandError` at the first that cannot take its push."""
        blast = BLAST.zeros(1)
        blast[0] = (*command.point, command.radius, command.impulse, SPEED_LIMIT)
        arguments = kernel_argument((state.bodies, self.shapes, self.xs, self.ys, blast))
        row = 0
        while (row := _PUSH_AWAY(*arguments, row)) < len(self.shapes):
            shape = self.shapes[row]
            if shape.holds != UNKNOWN:
                raise _refusal(state, shape)
            own = slice(shape.start, shape.start + shape.count)
            core = tuple(zip(self.xs[own].tolist(), self.ys[own].tolist(), strict=True))
            shape.holds = holds(_Core(core, float(shape.radius)), command.point)


class _Core(NamedTuple):
    """The core of a shape in the world (m)."""

    vertices: tuple[Vec, ...]
    radius: float


def _refusal(state: State, shape: Any) -> CommandError:
    """Why the body of a shape cannot take the push that is noted there."""
    name = state.census.bodies.names[shape.body]
    place = None if shape.at_center else (float(shape.x), float(shape.y))
    push = ApplyImpulse(name, (float(shape.impulse_x), float(shape.impulse_y)), point=place)
    try:
        push.checked().change(state, shape.body)
    except CommandError as error:
        text = str(error).removeprefix(f"{title(push)}: ")
    return CommandError(f"Explode: its push on {name!r} {text}; give a smaller impulse")
