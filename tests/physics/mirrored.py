"""Scenes seen in a mirror that stands on the y axis."""

from __future__ import annotations

from dataclasses import replace

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape


def mirrored(scene: FlatScene) -> FlatScene:
    """The same bodies in the same order, left and right exchanged. Knows no joints and regions."""
    return replace(scene, bodies=tuple(_body(each) for each in scene.bodies))


def mirror_error(world: World, image: World) -> float:
    """Largest distance (m) along an axis of a body of `world` from where its image in `image` is."""
    found = 0.0
    for name in world.names:
        x, y = world.body(name).position
        image_x, image_y = image.body(name).position
        found = max(found, abs(x + image_x), abs(y - image_y))
    return found


def _body(each: FlatBody) -> FlatBody:
    return replace(
        each,
        shapes=tuple(_shape(shape) for shape in each.shapes),
        position=(-each.position[0], each.position[1]),
        angle=-each.angle,
        velocity=(-each.velocity[0], each.velocity[1]),
        angular_velocity=-each.angular_velocity,
    )


def _shape(shape: FlatShape) -> FlatShape:
    """In reverse order, to go round counter-clockwise again."""
    return replace(
        shape, vertices=tuple((-x, y) for x, y in reversed(shape.vertices)), surface_speed=-shape.surface_speed
    )
