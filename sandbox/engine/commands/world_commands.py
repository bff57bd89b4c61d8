"""Commands that speak of the whole world: gravity and explosions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import compress
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from sandbox.engine.commands.body_commands import apply_command
from sandbox.engine.commands.checks import check_fields
from sandbox.engine.commands.pushes import ApplyImpulse
from sandbox.errors import CommandError
from sandbox.world.records import DYNAMIC

if TYPE_CHECKING:
    from sandbox.engine.world import World
    from sandbox.geometry.shapes import Shape

Vec = tuple[float, float]


@dataclass(frozen=True)
class SetGravity:
    """Change the gravity of the world (m/s^2). Wakes everything."""

    gravity: Vec


@dataclass(frozen=True)
class Explode:
    """Push all dynamic bodies within `radius` (m) away from `point` (m) at once.

    A shape gets `impulse` (N s) for each metre of its width as seen from the point, at its nearest place, less the
    farther away that is: nothing at the radius, all of it at the point. A negative impulse pulls. Walls do not shield.
    """

    point: Vec
    radius: float
    impulse: float


WorldCommand: TypeAlias = SetGravity | Explode


def apply_world_command(world: World, command: WorldCommand) -> None:
    """Apply a command. Raises `CommandError`, and changes nothing, if it cannot be done."""
    check_fields(command)
    if isinstance(command, SetGravity):
        _set_gravity(world, command)
    else:
        _explode(world, command)


def _set_gravity(world: World, command: SetGravity) -> None:
    setting = world.state.settings[0]
    setting.gravity_x, setting.gravity_y = command.gravity
    bodies = world.state.bodies
    asleep = np.flatnonzero((bodies.type == DYNAMIC) & (bodies.awake == 0))
    bodies.awake[asleep], bodies.sleep_time[asleep], bodies.island[asleep] = 1, 0.0, 0


def _explode(world: World, command: Explode) -> None:
    """Push all or none: bodies that cannot take their push keep the others from theirs."""
    if command.radius <= 0.0:
        raise CommandError(f"Explode: radius must be greater than 0 m, not {command.radius:g}")
    before = world.state.bodies.copy()
    try:
        for push in _blasts(world, command):
            apply_command(world.state, world.names.index(push.body), push)
    except CommandError as error:
        world.state.bodies[:] = before
        raise CommandError(f"Explode: {error}") from None


def _blasts(world: World, command: Explode) -> Iterator[ApplyImpulse]:
    """The impulse on every shape in reach, in the order of bodies and shapes."""
    from sandbox.engine.queries.filter import Filter
    from sandbox.engine.views.body_shapes import body_shapes
    from sandbox.geometry.shapes import Circle

    seen = world.query.overlap_shape(Circle(command.point, command.radius), Filter(types=("dynamic",)))
    shapes = world.state.shapes
    for name in sorted({hit.body for hit in seen}, key=world.names.index):
        solid = (shapes.sensor[shapes.body == world.names.index(name)] == 0).tolist()
        for shape in compress(body_shapes(world, name), solid):
            push = _blast(name, shape, world.body(name).center, command)
            if push is not None:
                yield push


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
