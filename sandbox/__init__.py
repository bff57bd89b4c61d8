"""A deterministic 2D physics sandbox.

    import sandbox

    world = sandbox.World(sandbox.load_scene("crates.scene.json"))
    world.step(300)
    print(world.body("crate").position, world.digest())

Each public name has one import path: this one. Names are imported on first use (PEP 562), so `import sandbox`
itself costs nothing.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

__version__ = "0.1.0"

if TYPE_CHECKING:
    from sandbox.engine.events import Events
    from sandbox.engine.queries.filter import Filter
    from sandbox.engine.world import World
    from sandbox.errors import (
        CommandError,
        MissingDependencyError,
        Problem,
        QueryError,
        SandboxError,
        SceneError,
        ShapeError,
        SnapshotError,
        UnknownBodyError,
        UnknownJointError,
    )
    from sandbox.geometry.collide import Contact, Distance, collide, contains, distance
    from sandbox.geometry.sat_rows import SatRow
    from sandbox.geometry.sat_table import SatTable, sat_table
    from sandbox.geometry.shapes import Box, Capsule, Circle, Polygon, Segment, Shape
    from sandbox.replay.expectations import Judge, Verdict
    from sandbox.scene import Scene, load_scene

__all__ = [
    "Box",
    "Capsule",
    "Circle",
    "CommandError",
    "Contact",
    "Distance",
    "Events",
    "Filter",
    "Judge",
    "MissingDependencyError",
    "Polygon",
    "Problem",
    "QueryError",
    "SandboxError",
    "SatRow",
    "SatTable",
    "Scene",
    "SceneError",
    "Segment",
    "Shape",
    "ShapeError",
    "SnapshotError",
    "UnknownBodyError",
    "UnknownJointError",
    "Verdict",
    "World",
    "__version__",
    "collide",
    "contains",
    "distance",
    "load_scene",
    "sat_table",
]

_ERRORS = {
    "CommandError",
    "MissingDependencyError",
    "Problem",
    "QueryError",
    "SandboxError",
    "SceneError",
    "ShapeError",
    "SnapshotError",
    "UnknownBodyError",
    "UnknownJointError",
}
_TESTS = {"Contact", "Distance", "collide", "contains", "distance"}
_SHAPES = {"Box", "Capsule", "Circle", "Polygon", "Segment", "Shape"}
_HOMES = {
    **dict.fromkeys(_TESTS, "sandbox.geometry.collide"),
    **dict.fromkeys(_SHAPES, "sandbox.geometry.shapes"),
    **dict.fromkeys(_ERRORS, "sandbox.errors"),
    "Judge": "sandbox.replay.expectations",
    "Verdict": "sandbox.replay.expectations",
    "SatRow": "sandbox.geometry.sat_rows",
    "SatTable": "sandbox.geometry.sat_table",
    "sat_table": "sandbox.geometry.sat_table",
    "Scene": "sandbox.scene",
    "load_scene": "sandbox.scene",
    "Events": "sandbox.engine.events",
    "Filter": "sandbox.engine.queries.filter",
    "World": "sandbox.engine.world",
}
"""Where each public name lives."""


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'sandbox' has no attribute {name!r}")
    value = getattr(importlib.import_module(_HOMES[name]), name)
    globals()[name] = value  # next time without a detour
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
