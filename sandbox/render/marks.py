"""What an overlay gives to the painters: strokes, fills, labels, and what it does to the look of the bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sandbox.render.camera import Floats
from sandbox.render.label import Label
from sandbox.render.strokes import NO_STROKES, Fills, Strokes
from sandbox.render.theme import Color


@dataclass(frozen=True)
class Tint:
    """Colours laid over the bodies: `color` (n, 3) sRGB and how far each body takes it, `amount` (n,) 0..1."""

    color: Floats
    amount: Floats


@dataclass(frozen=True)
class LegendEntry:
    """What a colour means. With `length` (pixels) it is a scale: so long is what the text says."""

    color: Color
    text: str
    length: float = 0.0


@dataclass(frozen=True)
class Marks:
    """A layer over the bodies: fills, strokes over them, labels over all layers. `tints` colour the bodies
    themselves, `hollow` leaves only their outlines, `calm` fades
    them, so that what lies over them shows; `legend` says what the colours mean.
    """

    fills: Sequence[Fills] = ()
    strokes: Strokes = NO_STROKES
    labels: Sequence[Label] = ()
    tints: Sequence[Tint] = ()
    hollow: bool = False
    calm: bool = False
    legend: Sequence[LegendEntry] = ()

    def __bool__(self) -> bool:
        """Whether there is anything in it."""
        any_ = (self.fills, self.labels, self.tints, self.hollow, self.calm, self.legend)
        return len(self.strokes) > 0 or any(bool(part) for part in any_)
