"""Flat scenes in one line each: what tests of the world and the engine are built from."""

from __future__ import annotations

from typing import Any

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatScene, FlatSettings, FlatShape, Vec

AWAKE = FlatSettings(sleeping=False)


def circle(radius: float, at: Vec = (0.0, 0.0), **surface: Any) -> FlatShape:
    """A disc."""
    return FlatShape("circle", (at,), radius, **surface)


def box(width: float, height: float, at: Vec = (0.0, 0.0), **surface: Any) -> FlatShape:
    """A box with its middle at `at`; `radius` rounds it."""
    x, y = 0.5 * width, 0.5 * height
    corners = ((-x, -y), (x, -y), (x, y), (-x, y))
    return FlatShape("box", tuple((cx + at[0], cy + at[1]) for cx, cy in corners), **surface)


def capsule(half: float, radius: float, **surface: Any) -> FlatShape:
    """A lying capsule: core from (-half, 0) to (half, 0)."""
    return FlatShape("capsule", ((-half, 0.0), (half, 0.0)), radius, **surface)


def segment(start: Vec, end: Vec, **surface: Any) -> FlatShape:
    """A line."""
    return FlatShape("segment", (start, end), **surface)


def polygon(*vertices: Vec, **surface: Any) -> FlatShape:
    """A convex polygon, counter-clockwise."""
    return FlatShape("polygon", vertices, **surface)


def body(name: str, *shapes: FlatShape, **fields: Any) -> FlatBody:
    """A dynamic body, unless `type` says otherwise."""
    return FlatBody(name, fields.pop("type", "dynamic"), shapes, **fields)


def ground(width: float = 200.0, **surface: Any) -> FlatBody:
    """A static box whose top is y = 0."""
    return body("ground", box(width, 2.0, (0.0, -1.0), **surface), type="static")


def scene(*bodies: FlatBody, **fields: Any) -> FlatScene:
    """A scene under gravity that never sleeps, unless `settings` or `gravity` say otherwise."""
    return FlatScene(bodies, **{"settings": AWAKE, **fields})


def world(*bodies: FlatBody, **fields: Any) -> World:
    """A world of `scene(*bodies, **fields)`."""
    return World(scene(*bodies, **fields))
