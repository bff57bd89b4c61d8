"""What ways to colour have in common: categories by name, and a ramp between two values."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Floats
from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.palette import is_light
from sandbox.render.overlays.pen import Pen
from sandbox.render.overlays.scale import amount, round_scale
from sandbox.render.theme import Theme, hex_color
from sandbox.world.records import DYNAMIC, STATIC

_ON_DARK = ("#46527e", "#7a57ad", "#c8568f", "#f08a5b", "#ffdf6b")
_ON_LIGHT = ("#d9d2bd", "#e8ae62", "#d2605f", "#93358a", "#3c2b84")
MOST_LEGEND = 8
STATIC_SHARE = 0.55
"""How far static bodies take a colour."""


def ramp(theme: Theme, shares: Floats) -> Floats:
    """Colours (n, 3) from little (0) to much (1), whose lightness only rises, on paper only falls: after the colour map
    plasma, which the colour-blind read as others do.
    """
    stops = np.array([hex_color(text) for text in (_ON_LIGHT if is_light(theme) else _ON_DARK)])
    place = np.clip(np.asarray(shares, np.float64), 0.0, 1.0) * (len(stops) - 1)
    return np.column_stack([np.interp(place, range(len(stops)), stops[:, part]) for part in range(3)])


def by_names(look: Look, names: Sequence[str], without: str) -> Marks:
    """A colour for each name, in the order of how many bodies have it; "" is told in the legend as `without`."""
    pen = Pen(look)
    count = Counter(names)
    ranked = sorted((name for name in count if name), key=lambda name: (-count[name], name))
    number = {name: k for k, name in enumerate(ranked)}
    inks = look.palette.categories(np.arange(max(len(ranked), 1)))
    rows = np.array([number.get(name, -1) for name in names], np.int64)
    colors = inks[np.maximum(rows, 0)]
    colors[rows < 0] = look.palette.quiet
    pen.tint(colors, _share(look))
    for name in ranked[:MOST_LEGEND]:
        pen.legend(inks[number[name]], f"{name}: {counted(count[name], 'body', 'bodies')}")
    if len(ranked) > MOST_LEGEND:
        pen.legend(look.palette.text, f"and {len(ranked) - MOST_LEGEND} more")
    if count[""]:
        pen.legend(look.palette.quiet, f"{without}: {counted(count[''], 'body', 'bodies')}")
    return pen.marks(calm=False)


def by_amount(look: Look, values: Floats, unit: str, of: NDArray[np.bool_]) -> Marks:
    """A ramp from 0 to a round number near the greatest of the `values` (n,), for the bodies `of` (n,) them."""
    pen = Pen(look)
    top = round_scale(values[of], 0.98)
    pen.tint(ramp(look.theme, values / top), of.astype(np.float64))
    _ramp_legend(pen, [0.0, top / 4.0, top / 2.0, top], [0.0, 0.25, 0.5, 1.0], unit)
    return pen.marks(calm=False)


def by_size(look: Look, values: Floats, unit: str, of: NDArray[np.bool_]) -> Marks:
    """A ramp over the logarithms of positive `values` (n,), from the least to the greatest of the bodies `of` (n,)."""
    pen = Pen(look)
    known = of & (values > 0.0) & np.isfinite(values)
    if not known.any():
        return pen.marks(calm=False)
    logs = np.log10(np.where(known, values, 1.0))
    low, high = float(logs[known].min()), float(logs[known].max())
    wide = max(high - low, 1e-9)
    share = np.full(len(values), 0.5) if high - low < 1e-6 else (logs - low) / wide
    pen.tint(ramp(look.theme, share), known.astype(np.float64))
    stops = [0.5] if high - low < 1e-6 else [0.0, 1 / 3, 2 / 3, 1.0]
    _ramp_legend(pen, [10.0 ** (low + stop * (high - low)) for stop in stops], stops, unit)
    return pen.marks(calm=False)


def _ramp_legend(pen: Pen, values: Sequence[float], shares: Sequence[float], unit: str) -> None:
    for value, ink in zip(values, ramp(pen.look.theme, np.array(shares)), strict=True):
        pen.legend(ink, amount(value, unit) if math.isfinite(value) else "")


def dynamic(look: Look) -> NDArray[np.bool_]:
    """Which bodies (n,) move freely."""
    return np.asarray(look.frame.type == DYNAMIC)


def _share(look: Look) -> Floats:
    return np.where(look.frame.type == STATIC, STATIC_SHARE, 1.0)
