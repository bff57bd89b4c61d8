"""A run as a film: taken step by step, painted without a display, written as GIF, MP4 or WebM by the file's name."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Protocol, TypeVar

from sandbox.render.image import gif_pictures, gif_seconds, save_gif
from sandbox.render.shots import Shooting, Stepping, shots
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.video import save_video

T = TypeVar("T")
GIF_FPS, VIDEO_FPS, FASTEST_GIF = 25.0, 60.0, 50.0


class Counting(Protocol):
    """What is told how far the work is."""

    def count(self, what: str, items: Iterable[T], total: int | None = None) -> Iterator[T]:
        """Pass `items` through and count them under the name `what`."""


def save_film(stepping: Stepping, shooting: Shooting, steps: int, path: Path, fps: float, progress: Counting) -> int:
    """Take `steps` steps and write what is seen meanwhile; gives the number of pictures.

    Raises `MissingDependencyError`, `OSError`, and what a step raises; then nothing is written.
    """
    if path.suffix.lower() == ".gif":
        seconds = gif_seconds(fps)
        taken = shots(stepping, progress.count("simulating", range(steps)), seconds, shooting)
        pictures = [shooting.draw_list(shot) for shot in taken]
        save_gif(progress.count("drawing", gif_pictures(pictures), len(pictures)), path, seconds)
        return len(pictures)
    painter = SurfacePainter()
    taken = shots(stepping, progress.count("filming", range(steps)), 1.0 / fps, shooting)
    return save_video((painter.paint(shooting.draw_list(shot)) for shot in taken), path, fps)
