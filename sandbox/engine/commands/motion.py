"""Commands that say where a body is and how it moves."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

from sandbox._jit import interpreted
from sandbox.engine.bodies.integrate import place_origin as place_origin_kernel
from sandbox.engine.commands.base import CommandTarget, Touched, Vec
from sandbox.engine.commands.body_command import BodyCommand
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.geometry.trig import cos_sin
from sandbox.world.records import STATIC
from sandbox.world.records import BodyPlace as At
from sandbox.world.state import State
from sandbox.world.tile_rows import NO_TILES
from sandbox.world.tiling import neighbours, note_moved, rejoin_around, tiles_of

_place_origin = interpreted(place_origin_kernel)
_cos_sin = interpreted(cos_sin)


@dataclass(frozen=True)
class SetPose(BodyCommand):
    """Put a body at `position` (m) and `angle` (rad) at once, without touching its velocity."""

    position: Vec
    angle: float

    def apply(self, target: CommandTarget) -> Touched:
        """Move the body, and say where its centre was; tiles are joined anew where it was and where it is."""
        state, row = target.state, target.directory.body(self.body)
        body, flags = state.body_words(row)
        center = body[At.CENTER_X], body[At.CENTER_Y]
        tiles = tiles_of(state, row) if flags[At.TYPE] == STATIC else NO_TILES
        left = neighbours(state, tiles)
        touched = super().apply(target)
        note_moved(state, tiles)
        rejoined = rejoin_around(state, tiles, left)
        return replace(touched, displaced=(row, center), bodies=touched.bodies + rejoined)

    def change(self, state: State, row: int) -> None:
        """Write the pose."""
        body, flags = state.body_words(row)
        cos, sin = _cos_sin(self.angle)
        x, y = body[At.LOCAL_CENTER_X], body[At.LOCAL_CENTER_Y]
        center_x = self.position[0] + (cos * x - sin * y)
        center_y = self.position[1] + (sin * x + cos * y)
        pose: Any = SimpleNamespace(
            rotation_cos=cos, rotation_sin=sin, local_center_x=x, local_center_y=y, center_x=center_x, center_y=center_y
        )
        _place_origin(pose)
        flags[At.POSED] = 1
        body[At.ANGLE], body[At.ROTATION_COS], body[At.ROTATION_SIN] = self.angle, cos, sin
        body[At.CENTER_X], body[At.CENTER_Y] = center_x, center_y
        body[At.POSITION_X], body[At.POSITION_Y] = pose.position_x, pose.position_y


@dataclass(frozen=True)
class SetVelocity(BodyCommand):
    """Give a body a velocity (m/s) and an angular velocity (rad/s). Static bodies refuse."""

    velocity: Vec
    angular_velocity: float

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Write the velocity."""
        body, flags = state.body_words(row)
        if flags[At.TYPE] == STATIC:
            raise CommandError(f"{title(self)}: a static body has no velocity; make it kinematic in the scene")
        body[At.VELOCITY_X], body[At.VELOCITY_Y] = self.velocity
        body[At.ANGULAR_VELOCITY] = self.angular_velocity
