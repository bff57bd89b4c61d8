"""A chart in an SVG picture: ruled paper, numbers beside it, curves in the colours of the style sheet."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from sandbox.render.number_text import plain
from sandbox.render.svg import Pixel, Svg, number

Range = tuple[float, float]

_LEFT, _BOTTOM = 62.0, 44.0
"""Pixels left of and below the paper, for numbers and the names of both axes."""


class Chart:
    """Curves over `x`, in a rectangle of the picture whose upper left pixel is `at`; ranges hold all that is drawn."""

    def __init__(self, svg: Svg, at: Pixel, size: tuple[float, float], x: Range, y: Range) -> None:
        self.svg = svg
        self._at = at[0] + _LEFT, at[1]
        self._size = size[0] - _LEFT, size[1] - _BOTTOM
        self._x, self._y = x, _widened(y)

    def paper(self, x_name: str, y_name: str) -> None:
        """The sheet with its lines and their numbers."""
        (left, top), (width, height) = self._at, self._size
        self.svg.rectangle(left, top, width, height, "lit", 8.0)
        for value in _ticks(self._y, height / 44.0):
            y = self.pixel(0.0, value)[1]
            self.svg.line((left, y), (left + width, y), "grid")
            self.svg.text((left - 8, y + 4), plain(value), "soft small number", "end")
        for value in _ticks(self._x, width / 70.0):
            x = self.pixel(value, 0.0)[0]
            self.svg.line((x, top), (x, top + height), "grid")
            self.svg.text((x, top + height + 18), plain(value), "soft small number", "middle")
        self.svg.text((left + width, top + height + 38), x_name, "soft small", "end")
        self.svg.text((left, top - 8), y_name, "soft small")

    def curve(self, points: Sequence[tuple[float, float]], kind: str, dots: bool = False) -> None:
        """A line through points (x, y); with a dot at each if there is room."""
        pixels = [self.pixel(x, y) for x, y in points]
        steps = " ".join(
            f"{'L' if k else 'M'}{number(x)} {number(y)}" for k, (x, y) in enumerate(pixels) if _matters(pixels, k)
        )
        self.svg.path(steps, f"{kind} axis")
        for pixel in pixels if dots else ():
            self.svg.circle(pixel, 3.0, f"{kind} dot")

    def level(self, y: float, kind: str) -> None:
        """A dashed line across the sheet."""
        self.svg.line(self.pixel(self._x[0], y), self.pixel(self._x[1], y), f"{kind} drop")

    def pixel(self, x: float, y: float) -> Pixel:
        """Where a point of the chart is in the picture."""
        (left, top), (width, height) = self._at, self._size
        across = (x - self._x[0]) / (self._x[1] - self._x[0])
        up = (y - self._y[0]) / (self._y[1] - self._y[0])
        return left + width * across, top + height * (1.0 - up)


def legend(svg: Svg, at: Pixel, entries: Iterable[tuple[str, str]]) -> None:
    """One line of (words, colour), a dash in its colour before each."""
    parts: list[tuple[str, str]] = []
    for words, kind in entries:
        # Viewers of SVG fold plain blanks into one.
        parts += [("\u2003" if parts else "", ""), ("━ ", kind), (words, "")]
    svg.spans(at, parts, "small")


def _matters(pixels: Sequence[Pixel], k: int) -> bool:
    """Whether a curve would look otherwise without its k-th point."""
    if k in (0, len(pixels) - 1):
        return True
    (x0, y0), (x1, y1), (x2, y2) = pixels[k - 1 : k + 2]
    return abs((y1 - y0) * (x2 - x0) - (y2 - y0) * (x1 - x0)) > 1e-3 * abs(x2 - x0)


def _widened(y: Range) -> Range:
    room = 0.08 * (y[1] - y[0]) or 1.0
    return y[0] - room, y[1] + room


def _ticks(span: Range, most: float) -> list[float]:
    """Round numbers within a range, no more than about `most`."""
    least = (span[1] - span[0]) / max(most, 2.0)
    power = 10.0 ** math.floor(math.log10(least))
    step = next(each * power for each in (1.0, 2.0, 5.0, 10.0) if each * power >= least)
    first, last = math.ceil(span[0] / step - 1e-9), math.floor(span[1] / step + 1e-9)
    return [float(f"{k * step:.9g}") for k in range(first, last + 1)]
