"""Everything that changes a world from outside is a command: plain data, checked as a whole before it is applied."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

from sandbox._jit import interpreted
from sandbox.engine.active.wake import wake_body
from sandbox.engine.bodies.integrate import place_origin as place_origin_kernel
from sandbox.engine.commands.checks import check_fields, title
from sandbox.engine.commands.pushes import ApplyForce, ApplyImpulse, apply_force, apply_impulse
from sandbox.engine.commands.surfaces import SetSurface, set_surface
from sandbox.errors import CommandError
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC, STATIC
from sandbox.world.state import State

_place_origin = interpreted(place_origin_kernel)
_cos_sin = interpreted(cos_sin)
Vec = tuple[float, float]

__all__ = [
    "PUSHES",
    "ApplyForce",
    "ApplyImpulse",
    "Command",
    "EndDrag",
    "MoveDrag",
    "SetPose",
    "SetSurface",
    "SetVelocity",
    "StartDrag",
    "apply_command",
]

DRAG_HERTZ = 5.0
DRAG_DAMPING_RATIO = 0.7


@dataclass(frozen=True)
class SetPose:
    """Put a body at `position` (m) and `angle` (rad) at once, without touching its velocity."""

    body: str
    position: Vec
    angle: float


@dataclass(frozen=True)
class SetVelocity:
    """Give a body a velocity (m/s) and an angular velocity (rad/s). Static bodies refuse."""

    body: str
    velocity: Vec
    angular_velocity: float


@dataclass(frozen=True)
class StartDrag:
    """Take hold of a dynamic body at a world `point` (m); pull it there with at most `max_force` (N).

    Without `max_force` the limit is a thousand times the body's weight at 1 g.
    """

    body: str
    point: Vec
    max_force: float | None = None


@dataclass(frozen=True)
class MoveDrag:
    """Move the target of a body's drag (m)."""

    body: str
    target: Vec


@dataclass(frozen=True)
class EndDrag:
    """Let go of a body."""

    body: str


PUSHES = (SetVelocity, ApplyForce, ApplyImpulse, StartDrag, MoveDrag, EndDrag)
"""Commands that change nothing of an awake dynamic body but how it goes on."""

Command: TypeAlias = SetPose | SetVelocity | SetSurface | ApplyForce | ApplyImpulse | StartDrag | MoveDrag | EndDrag


def apply_command(state: State, index: int, command: Command) -> None:
    """Apply a command to body `index`. Raises `CommandError`, and changes nothing, if it cannot be done."""
    check_fields(command)
    body = state.bodies[index]
    match command:
        case SetPose():
            _set_pose(body, command)
        case SetVelocity():
            _set_velocity(body, command)
        case SetSurface():
            set_surface(state, index, command)
        case ApplyForce():
            _needs_dynamic(body, command)
            apply_force(body, command)
        case ApplyImpulse():
            _needs_dynamic(body, command)
            apply_impulse(body, command)
        case StartDrag():
            _start_drag(state, index, command)
        case MoveDrag():
            drag = _drag_of(state, index, command.body)
            drag.target_x, drag.target_y = command.target
        case EndDrag():
            _drag_of(state, index, command.body).body = -1
    wake_body(state, index)


def _set_pose(body: Records, command: SetPose) -> None:
    body.posed = 1
    body.angle = command.angle
    body.rotation_cos, body.rotation_sin = _cos_sin(command.angle)
    x, y = body.local_center_x, body.local_center_y
    body.center_x = command.position[0] + (body.rotation_cos * x - body.rotation_sin * y)
    body.center_y = command.position[1] + (body.rotation_sin * x + body.rotation_cos * y)
    _place_origin(body)


def _set_velocity(body: Records, command: SetVelocity) -> None:
    if body.type == STATIC:
        raise CommandError(f"{title(command)}: a static body has no velocity; make it kinematic in the scene")
    body.velocity_x, body.velocity_y = command.velocity
    body.angular_velocity = command.angular_velocity


def _start_drag(state: State, index: int, command: StartDrag) -> None:
    body = state.bodies[index]
    _needs_dynamic(body, command)
    rows = [row for row in state.drags if row.body == index] or [row for row in state.drags if row.body < 0]
    if not rows:
        raise CommandError(f"{title(command)}: {len(state.drags)} bodies are dragged already; end one first")
    drag = rows[0]
    dx, dy = command.point[0] - body.center_x, command.point[1] - body.center_y
    drag.body = index
    drag.target_x, drag.target_y = command.point
    drag.local_x = body.rotation_cos * dx + body.rotation_sin * dy
    drag.local_y = body.rotation_cos * dy - body.rotation_sin * dx
    drag.hertz, drag.damping_ratio = DRAG_HERTZ, DRAG_DAMPING_RATIO
    drag.max_force = command.max_force if command.max_force is not None else 9810.0 * body.mass
    drag.impulse_x = drag.impulse_y = 0.0


def _needs_dynamic(body: Records, command: Command) -> None:
    if body.type != DYNAMIC:
        raise CommandError(f"{title(command)}: only a dynamic body can be pushed or dragged")


def _drag_of(state: State, index: int, name: str) -> Any:
    for row in state.drags:
        if row.body == index:
            return row
    raise CommandError(f"{name!r} is not being dragged; start with StartDrag")
