"""What overlaps a line already is swept by the middle of its core: that never crosses the line.

The sweep of a shape goes by the shortest way out of the overlap. Where that leads past an end of a line, or on to its
other side, the overlap shrinks as the shape goes through. The middle of a convex core lies within it, so that its way
crosses a line only where the shape itself goes through.
Source: the fallback of continuous collision in Box2D 3 for what overlaps from the start (there by a small disc).
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.continuous_collision.relative_sweep import SweepTables
from sandbox.geometry.core import core_middle, core_of
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records

_BEYOND = 1e-9
"""Share of a line by which a crossing may lie beyond its ends: nothing slips through where two links meet."""
_KEEP = 0.1
"""Share of what is let pass by which the middle stays away from the line."""


@kernel
def sweep_center(tables: SweepTables, line: Records, shape: Records, second: bool, front: int, until: float) -> float:
    """Share of the step after which the middle of a shape comes to a static line that it would cross; -1 if not.

    Only what comes from the left of the line is stopped if `front` is 1, only from its right if -1, both if 0; and only
    before the time `until`. Axis and point of the hit are then laid into `ccd.sweep`; `second` if the shape is the
    second of the pair there.
    """
    body = tables.bodies[shape.body]
    motion = tables.motions[shape.body]
    start = tables.cores[line.vertex_start]
    end = tables.cores[line.vertex_start + 1]
    mx, my = core_middle(tables.cores, core_of(shape))
    c, s = cos_sin(motion.delta_angle)
    x = body.center_x - tables.bodies[line.body].center_x - start.x
    y = body.center_y - tables.bodies[line.body].center_y - start.y
    x0 = x - motion.delta_x + mx
    y0 = y - motion.delta_y + my
    x1 = x + (c * mx - s * my)
    y1 = y + (s * mx + c * my)
    along_x = end.x - start.x
    along_y = end.y - start.y
    square = along_x * along_x + along_y * along_y
    before = along_x * y0 - along_y * x0
    after = along_x * y1 - along_y * x1
    if (before > 0.0) == (after > 0.0) or (before > 0.0 and front < 0) or (before <= 0.0 and front > 0):
        return -1.0
    t = before / (before - after)
    place = along_x * (x0 + t * (x1 - x0)) + along_y * (y0 + t * (y1 - y0))
    if place < -_BEYOND * square or place > (1.0 + _BEYOND) * square:
        return -1.0
    length = math.sqrt(square)
    keep = _KEEP * allowed_depth(line, shape, tables.units_per_meter) * length
    ahead = before if before > 0.0 else -before
    way = ahead + (after if after > 0.0 else -after)
    t = (ahead - keep) / way if ahead > keep else 0.0
    if t >= until:
        return -1.0
    hit = tables.ccd.sweep[0]
    # From shape a to shape b, as a normal of a pair leads.
    sign = 1.0 if (before > 0.0) == second else -1.0
    hit.normal_x = -along_y * sign / length
    hit.normal_y = along_x * sign / length
    hit.point_x = mx + (hit.x + t * hit.translation_x if second else 0.0)
    hit.point_y = my + (hit.y + t * hit.translation_y if second else 0.0)
    hit.touched = 1
    return float(t)
