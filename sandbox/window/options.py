"""What the window is asked to show."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sandbox.render.camera import Size


@dataclass(frozen=True)
class Options:
    """What to show and when to end: `frames` pictures, then quit, with one physics step a picture.

    Without a `size`, the window is as large as it was the last time.
    """

    scene: Path | None = None
    size: Size | None = None
    start_step: int = 0
    frames: int | None = None
    screenshot: Path | None = None
    workers: int = 1
    script: Path | None = None
    other: Path | None = None
    """A recording that says what is expected of the one that is played."""
    values: Mapping[str, Any] = field(default_factory=dict)
    """What is set in the scene, as `load_scene` takes it."""
