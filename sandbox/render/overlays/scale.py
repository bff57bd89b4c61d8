"""How long arrows are: a round number of units for so many pixels, so that arrows of two pictures can be compared."""

from __future__ import annotations

import math

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.number_text import plain as shortest
from sandbox.render.overlays.look import Look
from sandbox.tables import plain

REACH, FARTHEST, SHARE = 42.0, 110.0, 0.5
"""Pixels of an arrow that is as long as the scale says: a share of the extent of a body, between the first two."""
LONGEST = 2.6
"""Longer arrows than so many times that are cut."""


def round_scale(values: Floats, share: float = 0.9) -> float:
    """The least of 1, 2, 5 times a power of ten that is not below the `share` quantile of the sizes; 1 without any."""
    sizes = np.abs(values[np.isfinite(values)])
    sizes = sizes[sizes > 1e-3 * sizes.max(initial=0.0)]
    if len(sizes) == 0:
        return 1.0
    typical = float(np.quantile(sizes, share))
    power = 10.0 ** math.floor(math.log10(typical))
    return next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= typical * (1.0 - 1e-9))


def reach(look: Look) -> float:
    """How many pixels an arrow has that is as long as the scale says: more where bodies are seen from near by."""
    rows = look.visible_bodies()
    if len(rows) == 0:
        return REACH * look.scale
    extent = float(np.median(plain(look.world.state.bodies)["extent"][rows]))
    least, most = REACH * min(look.mark_scale, look.scale), FARTHEST * look.scale
    return float(np.clip(SHARE * extent * look.camera.scale, least, most))


def lengths(values: Floats, scale: float, pixels: float) -> Floats:
    """Signed pixels for values, where `scale` is so many pixels; none is longer than `LONGEST` times that."""
    cut: Floats = pixels * np.clip(values / scale, -LONGEST, LONGEST)
    return cut


def amount(value: float, unit: str) -> str:
    """A number to three digits with its unit, in thousands and thousandths where that is shorter."""
    for factor, prefix in ((1e6, "M"), (1e3, "k")):
        if abs(value) >= factor:
            return f"{shortest(float(f'{value / factor:.3g}'))} {prefix}{unit}"
    return f"{shortest(float(f'{value:.3g}'))} {unit}"


def length_text(value: float) -> str:
    """A length in metres to three digits, in millimetres where it is below a tenth of a metre."""
    small = abs(value) < 0.1
    return f"{shortest(float(f'{1000.0 * value if small else value:.3g}'))} {'mm' if small else 'm'}"
