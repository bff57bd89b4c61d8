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
from typing import TYPE_CHECKING, Any

from sandbox._version import __version__
from sandbox.notebook import render_with

if TYPE_CHECKING:
    from sandbox.engine.events.events import Events
    from sandbox.engine.queries.filter import Filter
    from sandbox.engine.world import World
    from sandbox.errors import (
        CommandError,
        FileError,
        MissingDependencyError,
        Problem,
        QueryError,
        RecordingError,
        SandboxError,
        SceneError,
        ShapeError,
        SnapshotError,
        UnknownBodyError,
        UnknownJointError,
        UnknownRegionError,
    )
    from sandbox.geometry.collide import Contact, Distance, collide, contains, distance
    from sandbox.geometry.sat_rows import SatRow
    from sandbox.geometry.sat_table import SatTable, sat_table
    from sandbox.geometry.shapes import Box, Capsule, Circle, Polygon, Segment, Shape
    from sandbox.replay.expectations import Judge, Verdict
    from sandbox.replay.golden.divergence import Difference, Divergence, Drift, Growth
    from sandbox.replay.golden.rerun import Outcome, rerun
    from sandbox.replay.golden.run import Run
    from sandbox.replay.golden.side_by_side import find_divergence
    from sandbox.replay.golden.tolerance import Tolerance
    from sandbox.replay.player import Player
    from sandbox.replay.recording.recorder import Recorder, record
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import Scene, load_scene

__all__ = [
    "Box",
    "Capsule",
    "Circle",
    "CommandError",
    "Contact",
    "Difference",
    "Distance",
    "Divergence",
    "Drift",
    "Events",
    "FileError",
    "Filter",
    "Growth",
    "Judge",
    "MissingDependencyError",
    "Outcome",
    "Player",
    "Polygon",
    "Problem",
    "QueryError",
    "Recorder",
    "Recording",
    "RecordingError",
    "Run",
    "SandboxError",
    "SatRow",
    "SatTable",
    "Scene",
    "SceneError",
    "Segment",
    "Shape",
    "ShapeError",
    "SnapshotError",
    "Tolerance",
    "UnknownBodyError",
    "UnknownJointError",
    "UnknownRegionError",
    "Verdict",
    "World",
    "__version__",
    "collide",
    "contains",
    "distance",
    "find_divergence",
    "load_scene",
    "record",
    "rerun",
    "sat_table",
]

_ERRORS = {
    "CommandError",
    "FileError",
    "MissingDependencyError",
    "Problem",
    "QueryError",
    "RecordingError",
    "SandboxError",
    "SceneError",
    "ShapeError",
    "SnapshotError",
    "UnknownBodyError",
    "UnknownJointError",
    "UnknownRegionError",
}
_TESTS = {"Contact", "Distance", "collide", "contains", "distance"}
_DIVERGENCE = {"Difference", "Divergence", "Drift", "Growth"}
_SHAPES = {"Box", "Capsule", "Circle", "Polygon", "Segment", "Shape"}
_HOMES = {
    **dict.fromkeys(_TESTS, "sandbox.geometry.collide"),
    **dict.fromkeys(_SHAPES, "sandbox.geometry.shapes"),
    **dict.fromkeys(_ERRORS, "sandbox.errors"),
    **dict.fromkeys(_DIVERGENCE, "sandbox.replay.golden.divergence"),
    "Outcome": "sandbox.replay.golden.rerun",
    "rerun": "sandbox.replay.golden.rerun",
    "Run": "sandbox.replay.golden.run",
    "find_divergence": "sandbox.replay.golden.side_by_side",
    "Tolerance": "sandbox.replay.golden.tolerance",
    "Player": "sandbox.replay.player",
    "Recorder": "sandbox.replay.recording.recorder",
    "record": "sandbox.replay.recording.recorder",
    "Recording": "sandbox.replay.recording.recording",
    "Judge": "sandbox.replay.expectations",
    "Verdict": "sandbox.replay.expectations",
    "SatRow": "sandbox.geometry.sat_rows",
    "SatTable": "sandbox.geometry.sat_table",
    "sat_table": "sandbox.geometry.sat_table",
    "Scene": "sandbox.scene",
    "load_scene": "sandbox.scene",
    "Events": "sandbox.engine.events.events",
    "Filter": "sandbox.engine.queries.filter",
    "World": "sandbox.engine.world",
}
"""Where each public name lives."""


def _html_of(value: Any) -> str:
    rendered: str = importlib.import_module("sandbox.report.notebook").html_of(value)
    return rendered


render_with(_html_of)


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'sandbox' has no attribute {name!r}")
    value = getattr(importlib.import_module(_HOMES[name]), name)
    globals()[name] = value  # next time without a detour
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
