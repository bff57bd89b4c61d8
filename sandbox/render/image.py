"""Picture files: PNG stills and GIF films, drawn without a display."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from sandbox._atomic_write import write_bytes
from sandbox.render.draw_list import DrawList
from sandbox.render.surface_painter import SurfacePainter

PALETTE_COLORS = 160
"""Colours of a film: fewer make the file smaller, more make antialiased edges smoother."""
PALETTE_SAMPLES = 6
"""Frames, spread over the film, that the palette is made from."""


def gif_seconds(fps: float) -> float:
    """Seconds a frame nearest to `fps` that a GIF can hold: whole hundredths, at least two."""
    return max(round(100.0 / fps), 2) / 100.0


def gif_pictures(pictures: Sequence[DrawList]) -> Iterator[Any]:
    """All pictures as Pillow images with one shared palette, one after the other."""
    painter = SurfacePainter()
    samples = spread(pictures, PALETTE_SAMPLES)
    palette = shared_palette([painter.paint(picture) for picture in samples], PALETTE_COLORS)
    for picture in pictures:
        yield painter.paint(picture).quantize(palette=palette, dither=0)


def spread(pictures: Sequence[Any], most: int) -> Sequence[Any]:
    """At most so many of the pictures, spread over all of them."""
    return pictures[:: -(-len(pictures) // most)]


def shared_palette(samples: Sequence[Any], colors: int) -> Any:
    """A Pillow image whose palette of `colors` fits all of the samples, RGB images.

    A colour weighs as much as the root of how often it is there: large plain areas leave some for what is small, and
    what is looked through are some ten thousand pixels instead of millions.
    """
    counts: Counter[tuple[int, int, int]] = Counter()
    for sample in samples:
        counts.update({color: count for count, color in sample.getcolors(sample.width * sample.height)})
    weights = np.sqrt(list(counts.values())).astype(np.int64)
    pixels = np.array(list(counts), np.uint8).repeat(weights, axis=0)
    sheet = Image.frombytes("RGB", (len(pixels), 1), pixels.tobytes())
    return sheet.quantize(colors=colors, method=Image.Quantize.MEDIANCUT, kmeans=1)


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
