"""The pen of overlays: lines, arrows, dots, boxes and words by the thousand, with a halo that lifts them off bodies."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from sandbox.render.camera import Floats, Vec
from sandbox.render.label import Label
from sandbox.render.marks import LegendEntry, Marks, Tint
from sandbox.render.overlays.look import Look
from sandbox.render.strokes import Fills, Strokes, fills, joined, strokes
from sandbox.render.theme import Color

HALO = 1.8
"""Pixels by which a halo is wider than what it is around."""
HEAD = 7.0
"""Pixels of an arrow's head; shorter arrows have smaller ones."""
SLENDER = 0.2
"""Width of an arrow to its length at most, so that short ones are no blobs."""
LABEL = 12.0
"""Pixels of the height of words."""
_TURN = np.linspace(0.0, 2.0 * np.pi, 17)
_CIRCLE = np.column_stack([np.cos(_TURN), np.sin(_TURN)])


class Pen:
    """Collects the marks of one overlay. Everything is in pixels; `color` is one sRGB colour or one for each row.

    Widths, dots and heads are `scale` times as large as asked for, `look.mark_scale` if it is not given; words and
    their gaps `look.scale` times.
    """

    def __init__(self, look: Look, scale: float | None = None) -> None:
        self.look = look
        self.scale = look.mark_scale if scale is None else scale
        self.palette = look.palette
        self._halo: list[Strokes] = []
        self._strokes: list[Strokes] = []
        self._fills: list[Fills] = []
        self._labels: list[Label] = []
        self._tints: list[Tint] = []
        self._legend: list[LegendEntry] = []

    def lines(
        self,
        start: Floats,
        end: Floats,
        width: ArrayLike,
        color: ArrayLike,
        opacity: ArrayLike = 1.0,
        halo: bool = False,
    ) -> None:
        """Straight lines from `start` to `end` (n, 2)."""
        if len(start) == 0:
            return
        width = self.scale * np.asarray(width, np.float64)
        if halo:
            wide = np.asarray(width, np.float64) + HALO * self.scale
            self._halo.append(strokes(start, end, wide, self.palette.halo, 0.75 * np.asarray(opacity)))
        self._strokes.append(strokes(start, end, width, color, opacity))

    def dashes(self, start: Floats, end: Floats, width: float, color: ArrayLike, opacity: float = 1.0) -> None:
        """Lines of which every other sixth of about 10 pixels is left out, up to sixteen dashes each."""
        count = int(np.clip(np.median(np.hypot(*(end - start).T)) / 10.0, 2, 16)) if len(start) else 0
        for k in range(count):
            share = np.array([k + 0.2, k + 0.7]) / count
            self.lines(start + share[0] * (end - start), start + share[1] * (end - start), width, color, opacity)

    def arrows(self, start: Floats, way: Floats, width: float, color: ArrayLike) -> None:
        """Arrows from `start` along `way` (n, 2), with a halo; what is shorter than a pixel is left out."""
        length = np.hypot(way[:, 0], way[:, 1])
        long = length > 1.0
        start, way, length = start[long], way[long], length[long]
        colors = np.broadcast_to(np.asarray(color, np.float64), (len(long), 3))[long]
        unit = way / length[:, None]
        end, head = start + way, np.minimum(HEAD * self.scale, 0.5 * length)[:, None]
        side = 0.5 * head * np.column_stack([-unit[:, 1], unit[:, 0]])
        slender = np.clip(SLENDER * length / self.scale, min(width, 0.8), width)
        self.lines(start, end, slender, colors, halo=True)
        for sign in (1.0, -1.0):
            self.lines(end, end - head * unit + sign * side, slender, colors, halo=True)

    def dots(self, at: Floats, radius: ArrayLike, color: ArrayLike, opacity: ArrayLike = 1.0) -> None:
        """Discs with a halo."""
        self.lines(at, at, 2.0 * np.asarray(radius, np.float64), color, opacity, halo=True)

    def rings(self, at: Floats, radius: ArrayLike, width: float, color: ArrayLike, opacity: float = 1.0) -> None:
        """Circles."""
        reach = np.broadcast_to(np.asarray(radius, np.float64), (len(at),))[:, None]
        colors = np.broadcast_to(np.asarray(color, np.float64), (len(at), 3))
        for k in range(len(_CIRCLE) - 1):
            self.lines(at + reach * _CIRCLE[k], at + reach * _CIRCLE[k + 1], width, colors, opacity)

    def boxes(self, low: Floats, high: Floats, width: float, color: ArrayLike, opacity: ArrayLike = 1.0) -> None:
        """Upright rectangles by two opposite corners (n, 2)."""
        corners = box_corners(low, high)
        for k in range(4):
            self.lines(corners[:, k], corners[:, (k + 1) % 4], width, color, opacity)

    def fill(self, points: Floats, color: ArrayLike, opacity: ArrayLike) -> None:
        """Convex polygons (n, k, 2)."""
        if len(points):
            self._fills.append(fills(points, color, opacity))

    def label(self, text: str, at: ArrayLike, color: Color, gap: float = 6.0, rank: float = 0.0) -> None:
        """Words beside a point."""
        x, y = np.asarray(at, np.float64).tolist()
        self._label(text, (x, y), color, gap, rank)

    def labels(
        self, texts: Iterable[str], at: Floats, color: Color, gap: float = 6.0, ranks: Floats | None = None
    ) -> None:
        """Words beside points (n, 2); those of higher rank come first where there is not room for all."""
        order = ranks.tolist() if ranks is not None else [0.0] * len(at)
        for text, place, rank in zip(texts, at.tolist(), order, strict=True):
            self._label(text, (place[0], place[1]), color, gap, rank)

    def _label(self, text: str, at: Vec, color: Color, gap: float, rank: float) -> None:
        scale = self.look.scale
        self._labels.append(Label(text, at, color, LABEL * scale, gap=gap * scale, rank=rank))

    def words(self, text: str, at: ArrayLike, color: Color, rank: float = 0.0) -> None:
        """Words centred on a point."""
        x, y = np.asarray(at, np.float64).tolist()
        self._labels.append(Label(text, (x, y), color, LABEL * self.look.scale, "middle", rank=rank))

    def tint(self, color: Floats, amount: Floats) -> None:
        """Colour the bodies themselves: a row each."""
        self._tints.append(Tint(color, amount))

    def legend(self, color: ArrayLike, text: str, length: float = 0.0) -> None:
        """Say what a colour means, or with a length in pixels, a scale."""
        red, green, blue = np.asarray(color, np.float64).tolist()
        self._legend.append(LegendEntry((red, green, blue), text, length))

    def marks(self, calm: bool = True) -> Marks:
        """All of it; `calm` fades the bodies below."""
        every = joined([*self._halo, *self._strokes])
        return Marks(self._fills, every, self._labels, self._tints, legend=self._legend, calm=calm)


def box_corners(low: Floats, high: Floats) -> Floats:
    """The corners (n, 4, 2) of rectangles by two opposite ones (n, 2)."""
    (x0, y0), (x1, y1) = low.T, high.T
    return np.stack([np.column_stack(each) for each in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))], axis=1)
