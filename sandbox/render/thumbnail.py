"""A small picture of a scene, some moments after it has begun."""

from __future__ import annotations

from typing import Any

from sandbox.engine.world import World
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Size, scene_camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.surface_painter import SurfacePainter
from sandbox.scene import Scene
from sandbox.scene.duration import planned_steps

MOMENT = 1.2
"""Seconds after the start: things have begun to move, and few have left the view. Of a short run at most its half."""
FEW, MANY = 400, 4000
"""Up to so many bodies the whole time is simulated; above so many, nothing."""
OVERSAMPLING = 2
"""The picture is drawn so many times as large and then made smaller, so that thin lines stay."""


def thumbnail(scene: Scene, size: Size) -> Any:
    """A `PIL.Image.Image` of `size` pixels. Raises what `World` and its steps raise."""
    from PIL import Image

    world = World(scene)
    start = capture(world.state)
    count = max(len(world.names), 1)
    share = 0.0 if count > MANY else min(FEW / count, 1.0)
    moment = min(MOMENT * scene.settings.step_rate, planned_steps(scene) / 2)
    world.step(round(moment * share))
    large = size[0] * OVERSAMPLING, size[1] * OVERSAMPLING
    camera = scene_camera(scene.view, interesting_bounds(start), large)
    picture = SurfacePainter().paint(build_draw_list(capture(world.state), camera, body_colors_of(world.state)))
    return picture.resize(size, Image.Resampling.LANCZOS)
