"""Looks at small worlds for tests of overlays."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sandbox.engine.world import World
from sandbox.render.camera import Camera, fit
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.registry import draw_overlays, find_overlay
from sandbox.render.theme import DARK, Theme
from sandbox.resources import find_scene
from sandbox.scene import Scene, load_scene

SIZE = (640, 400)


def look_at(world: World, camera: Camera | None = None, theme: Theme = DARK) -> Look:
    """A look at a world as it is, at all of it unless a camera is given."""
    frame = capture(world.state)
    return Look(world, frame, camera or fit(interesting_bounds(frame), SIZE), theme)


def shipped_world(name: str, steps: int) -> World:
    """A shipped scene after some steps."""
    world = World(load_scene(find_scene(Path(name))))
    world.step(steps)
    return world


def world_of(*bodies: dict[str, Any], steps: int = 0, **fields: Any) -> World:
    """A world of bodies in the words of a scene file, after some steps."""
    world = World(Scene(bodies=list(bodies), **fields))
    world.step(steps)
    return world


GROUND = {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]}


def crate(name: str, x: float, y: float, **fields: Any) -> dict[str, Any]:
    """A box of one metre."""
    return {"id": name, "shapes": [{"box": [1, 1]}], "position": [x, y], **fields}


def own_marks(name: str, look: Look) -> Marks:
    """What one overlay draws, its own labels included."""
    return find_overlay(name).draw(look)


def words(layers: Sequence[Marks]) -> set[str]:
    """All labels."""
    return {label.text for layer in layers for label in layer.labels}


def shown(look: Look, *names: str) -> tuple[Marks, ...]:
    """The layers of some overlays."""
    return draw_overlays([find_overlay(name) for name in names], look)
