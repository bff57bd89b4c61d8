"""Fat boxes: the boxes of shapes with room to move in, as much as pays off.

The more room, the longer they hold, but the more of their pairs are needless, and the more levels of the grid they lie
on.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.engine.broad_phase.proxies import ACTIVE, DRIVEN
from sandbox.engine.records.colliders import Colliders
from sandbox.tables import Records

SLACK = 0.1
"""Most room (m) that a fat box leaves on each side."""
SLACK_SHARE = 0.1
"""The same for small bodies, as a share of their extent."""
AHEAD = 8.0
"""For so many further steps at most (a power of two) a fat box covers what the velocity leads to: fewer where many
pairs come of it."""
_NEEDLESS = 0.5
"""Boxes look less far ahead when the cache has more needless pairs than so many for each shape and each pair that is
selected, and further again when it has a fourth of that."""
_LASTING = 3
"""Pairs of fat boxes are worth it if they hold for so many steps: to find them takes up to twice as long."""
_WAIT = 32
"""How often the grid is built without fat boxes once they have not been worth it."""


@inlined_kernel
def adapt_fat(info: Records, shapes: int) -> None:
    """Look less far ahead where many pairs are needless, further where few are. Where pairs hold for less than
    `_LASTING` steps, do without fat boxes for a while."""
    cache = info[0]
    needless = cache.count - cache.selected
    most = _NEEDLESS * (cache.selected + shapes)
    if cache.ahead == 0.0:
        cache.wait -= 1
        cache.ahead = 1.0 if cache.wait <= 0 else 0.0
        return
    if needless > most:
        look_less_far(cache)
    elif 4 * needless < most and cache.ahead < AHEAD:
        cache.ahead *= 2.0
    elif cache.age < _LASTING:
        _do_without(cache)


@inlined_kernel
def look_less_far(cache: Records) -> None:
    """Look half as far ahead; at last, do without fat boxes."""
    if cache.ahead > 1.0:
        cache.ahead *= 0.5
    else:
        _do_without(cache)


@inlined_kernel
def _do_without(cache: Records) -> None:
    cache.ahead = 0.0
    cache.wait = _WAIT


@inlined_kernel
def fatten(colliders: Colliders, i: int, ahead: float, most: float, fat: Records) -> None:
    """Write the fat box of a shape: what moves gets room where its velocity leads to within a time `ahead` (s), and a
    little on all sides, at most `most` (m); none if that is 0."""
    box = colliders.boxes[i]
    proxy = colliders.proxies[i]
    grow = x = y = 0.0
    if ahead > 0.0 and colliders.filters[i].moves & (ACTIVE | DRIVEN):
        extent = proxy.extent
        slack = SLACK_SHARE * extent
        swing = ahead * proxy.swing
        grow = (slack if slack < most else most) + (swing if swing < 2.0 * extent else 2.0 * extent)
        x = ahead * proxy.velocity_x
        y = ahead * proxy.velocity_y
    fat.lower_x = box.lower_x + (x if x < 0.0 else 0.0) - grow
    fat.lower_y = box.lower_y + (y if y < 0.0 else 0.0) - grow
    fat.upper_x = box.upper_x + (x if x > 0.0 else 0.0) + grow
    fat.upper_y = box.upper_y + (y if y > 0.0 else 0.0) + grow
    fat.shape_index = i
