"""Picture files: PNG stills and GIF films, drawn without a display."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image

from sandbox._atomic_write import write_bytes
from sandbox.engine.world import World
from sandbox.render.body_colors import BodyColors, body_colors_of
from sandbox.render.camera import Camera, Size, scene_camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import Frame, capture, interesting_bounds
from sandbox.render.surface_painter import SurfacePainter

PALETTE_COLORS = 160
"""Colours of a film: fewer make the file smaller, more make antialiased edges smoother."""
PALETTE_SAMPLES = 6
"""Frames, spread over the film, that the palette is made from."""


class FrameRenderer:
    """One camera and the colours of the bodies: turns frames into Pillow images."""

    def __init__(self, camera: Camera, body_colors: BodyColors) -> None:
        self.camera = camera
        self.body_colors = body_colors
        self._painter = SurfacePainter()

    def picture(self, frame: Frame) -> Any:
        """The frame as a `PIL.Image.Image` in RGB."""
        self.body_colors = self.body_colors.for_frame(frame)
        return self._painter.paint(build_draw_list(frame, self.camera, self.body_colors))

    def save_png(self, frame: Frame, path: Path) -> None:
        """Write one frame as a PNG file. Raises `OSError`."""
        save_png(self.picture(frame), path)

    def film(self, frames: Sequence[Frame]) -> Iterator[Any]:
        """All frames as images with one shared palette, one after the other."""
        palette = self._palette(frames)
        for frame in frames:
            yield self.picture(frame).quantize(palette=palette, dither=0)

    def _palette(self, frames: Sequence[Frame]) -> Any:
        step = max(len(frames) // PALETTE_SAMPLES, 1)
        samples = [self.picture(frame) for frame in frames[::step]]
        width, height = self.camera.size
        sheet = Image.new("RGB", (width, height * len(samples)))
        for i, sample in enumerate(samples):
            sheet.paste(sample, (0, i * height))
        return sheet.quantize(colors=PALETTE_COLORS, method=Image.Quantize.MEDIANCUT, kmeans=1)


def renderer_of(world: World, size: Size) -> FrameRenderer:
    """The renderer for a world at its start: the view and the colours that its scene asks for."""
    camera = scene_camera(getattr(world.scene, "view", None), interesting_bounds(capture(world.state)), size)
    return FrameRenderer(camera, body_colors_of(world.state))


def save_png(picture: Any, path: Path) -> None:
    """Write a Pillow image as a PNG file. Raises `OSError`."""
    data = BytesIO()
    picture.save(data, "PNG", optimize=True)
    write_bytes(path, data.getvalue())


def save_gif(images: Iterable[Any], path: Path, seconds_a_frame: float) -> None:
    """Write palette images as an endless GIF. Frames that show nothing new only lengthen the one before.

    Raises `OSError`.
    """
    pictures = iter(images)
    first = next(pictures)
    delay = round(seconds_a_frame * 1000)
    data = BytesIO()
    first.save(data, "GIF", save_all=True, append_images=pictures, duration=delay, loop=0, disposal=1)
    write_bytes(path, data.getvalue())
