"""A film of the window itself, panels and all."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sandbox.window.display import Display

EVERY = 4
"""Pictures of the window for one of the film."""
SECONDS = EVERY / 60
COLORS = 128
SAMPLES = 8
"""Pictures, spread over the film, that its palette is made from."""


class Reel:
    """Collects every fourth picture until it is saved as a GIF."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._pictures: list[Any] = []
        self._seen = 0

    @property
    def due(self) -> bool:
        """Whether the next picture is one of the film."""
        return self._seen % EVERY == 0

    def see(self, display: Display) -> None:
        """A picture has been drawn, and is not shown yet."""
        if self.due:
            self._pictures.append(display.picture())
        self._seen += 1

    def save(self) -> None:
        """Write the film. Raises `OSError`."""
        from PIL import Image

        from sandbox.render.image import save_gif, shared_palette, spread

        if not self._pictures:
            return
        palette = shared_palette(spread(self._pictures, SAMPLES), COLORS)
        pictures = (picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in self._pictures)
        save_gif(pictures, self.path, SECONDS)
