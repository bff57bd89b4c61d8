"""The command that pushes everything near a point away from it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import compress
from typing import TYPE_CHECKING

from sandbox.engine.active.wake import wake_body
from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec
from sandbox.engine.commands.checks import title
from sandbox.engine.commands.pushes import ApplyImpulse
from sandbox.errors import CommandError
from sandbox.geometry.checks import LARGEST, SMALLEST

if TYPE_CHECKING:
    from sandbox.geometry.shapes import Shape


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
        state = target.state
        before = state.bodies.copy()
        for row, push in _blasts(target, self):
            try:
                push.checked().change(state, row)
            except CommandError as error:
                state.bodies[:] = before
                text = str(error).removeprefix(f"{title(push)}: ")
                raise CommandError(f"Explode: its push on {push.body!r} {text}; give a smaller impulse") from None
            wake_body(state, row)
        return Touched()


def _blasts(target: CommandTarget, command: Explode) -> Iterator[tuple[int, ApplyImpulse]]:
    """The impulse on every shape in reach, with the row of its body, in the order of bodies and shapes."""
    from sandbox.engine.queries.filter import Filter
    from sandbox.geometry.shapes import Circle
    from sandbox.world.body_shapes import body_shapes

    state = target.state
    seen = target.query.overlap_shape(Circle(command.point, command.radius), Filter(types=("dynamic",)))
    for row in sorted({target.directory.body(hit.body) for hit in seen}):
        name, body = state.census.bodies.names[row], state.bodies[row]
        center = float(body.center_x), float(body.center_y)
        solid = (state.shapes.sensor[state.shapes.body == row] == 0).tolist()
        for shape in compress(body_shapes(state, row), solid):
            push = _blast(name, shape, center, command)
            if push is not None:
                yield row, push


def _blast(name: str, shape: Shape, center: Vec, command: Explode) -> ApplyImpulse | None:
    """What an explosion does to one shape; None if it is out of reach."""
    nearest, gap = _nearest(shape, command.point)
    if gap >= command.radius:
        return None
    towards = nearest if gap > 0.0 else center
    x, y = towards[0] - command.point[0], towards[1] - command.point[1]
    length = math.sqrt(x * x + y * y)
    if length == 0.0:
        return None
    x, y = x / length, y / length
    across = [x * v - y * u for u, v in shape.vertices]
    width = max(across) - min(across) + 2.0 * shape.radius
    size = command.impulse * width * (1.0 - max(gap, 0.0) / command.radius)
    return ApplyImpulse(name, (size * x, size * y), point=nearest if gap > 0.0 else None)


def _nearest(shape: Shape, point: Vec) -> tuple[Vec, float]:
    """The place of a shape that is nearest to a point, and how far away it is; 0 if the shape holds the point."""
    from sandbox.geometry.collide import contains

    if contains(shape, point):
        return point, 0.0
    core = shape.vertices
    (x, y), away = min((_on_edge(a, b, point) for a, b in zip(core, (*core[1:], core[0]), strict=True)), key=_second)
    if away == 0.0:  # so near that it cannot be told from the edge
        return point, 0.0
    share = shape.radius / away
    return (x + (point[0] - x) * share, y + (point[1] - y) * share), away - shape.radius


def _on_edge(a: Vec, b: Vec, point: Vec) -> tuple[Vec, float]:
    """The point of an edge that is nearest to a point, and their distance."""
    x, y = b[0] - a[0], b[1] - a[1]
    square = x * x + y * y
    along = ((point[0] - a[0]) * x + (point[1] - a[1]) * y) / square if square > 0.0 else 0.0
    along = min(max(along, 0.0), 1.0)
    near = (a[0] + along * x, a[1] + along * y)
    dx, dy = point[0] - near[0], point[1] - near[1]
    return near, math.sqrt(dx * dx + dy * dy)


def _second(found: tuple[Vec, float]) -> float:
    return found[1]
