"""How exact a comparison can be.

pymunk turns and moves shapes in the world's coordinates with its own sines, so far from the origin both engines do
not see quite the same shapes: every tolerance has a share of the size of the shapes and a share of their coordinates.
"""

from __future__ import annotations

from typing import TypeVar

from sandbox.tables import Floats

Lengths = TypeVar("Lengths", float, Floats)

TOUCH_SHARE = 1e-12
"""Shapes nearer to touching than this share of their size count as touching: either verdict is right."""
DEPTH_SHARE = 1e-9
"""Depths may differ by this share of the size of the shapes; an axis this much deeper is as good as the best one."""
ROUNDING = 1e-15
"""Rounding of world coordinates, as a share of the largest of them: 4 to 9 ulps."""


def touch_tolerance(size: Lengths, reach: Lengths) -> Lengths:
    """Metres, for bodies of extents `size` (m, added) whose largest coordinate is `reach` (m)."""
    return TOUCH_SHARE * size + ROUNDING * reach


def allowed_error(size: Lengths, reach: Lengths) -> Lengths:
    """Metres by which two right answers on a depth may differ."""
    return DEPTH_SHARE * size + ROUNDING * reach
