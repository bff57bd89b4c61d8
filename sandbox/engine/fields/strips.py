"""Which regions a body may be in: both axes cut into strips, each of which knows the regions that reach into it.

In: regions, edges, the step. Out: for each strip a set of regions, as bits, of those that act. A body may be in the
regions that reach into its strips along x and along y. There are as many strips as regions, over where these begin and
end: where they lie side by side, or over each other, a body is held against a few.

How far a region reaches is a linear program in two unknowns; each two of its half-planes bound it (duality), and those
that meet in its outermost corner do so best. They follow each other in its outline, which one more edge may cut.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.fields.area import acts
from sandbox.engine.fields.records import BITS, STRIPS, Fields
from sandbox.tables import Records
from sandbox.world.field_records import ATTRACTION

_ROUNDING = 1e-9
"""Share of its coordinates by which a region counts as wider: far more than what is rounded."""


@kernel
def lay_strips(fields: Fields, step: int) -> None:
    """Write down which regions act where in a step."""
    regions = fields.regions
    words = (regions.shape[0] + BITS - 1) // BITS
    for k in range(2):
        axis = fields.axes[k]
        axis.words = words
        axis.first = k * STRIPS * words
        _cut(fields, axis, 1.0 - k, 0.0 + k)
        fields.strips[axis.first : axis.first + axis.count * words] = 0
        for n in range(regions.shape[0]):
            if acts(regions[n], step):
                span = fields.spans[n]
                for strip in range(_strip_at(axis, span.lower), _strip_at(axis, span.upper) + 1):
                    fields.strips[axis.first + strip * words + n // BITS] |= 1 << (n % BITS)


@kernel
def look_up(fields: Fields, push: Records, extent: float) -> None:
    """Write to `fields.found` the set of the regions that act and may reach a body."""
    x, y = fields.axes[0], fields.axes[1]
    left, right = _strip_at(x, push.x - extent), _strip_at(x, push.x + extent)
    low, high = _strip_at(y, push.y - extent), _strip_at(y, push.y + extent)
    for word in range(x.words):
        beside = 0
        for k in range(left, right + 1):
            beside |= fields.strips[k * x.words + word]
        level = 0
        for k in range(low, high + 1):
            level |= fields.strips[y.first + k * x.words + word]
        fields.found[word] = beside & level


@inlined_kernel
def lowest_bit(bits: int) -> int:
    """The number of the lowest bit of a word that is set."""
    lowest = 0
    if bits & 0xFFFFFFFF == 0:
        bits >>= 32
        lowest = 32
    if bits & 0xFFFF == 0:
        bits >>= 16
        lowest += 16
    if bits & 0xFF == 0:
        bits >>= 8
        lowest += 8
    while bits & 1 == 0:
        bits >>= 1
        lowest += 1
    return lowest


@kernel
def _cut(fields: Fields, axis: Records, x: float, y: float) -> None:
    """Cut an axis, whose direction is (x, y), into strips, and note how far each region reaches along it."""
    regions = fields.regions
    lower = math.inf
    upper = -math.inf
    for k in range(regions.shape[0]):
        span = fields.spans[k]
        span.lower = -_reach(regions[k], fields.edges, -x, -y)
        span.upper = _reach(regions[k], fields.edges, x, y)
        lower = span.lower if -math.inf < span.lower < lower else lower
        upper = span.upper if math.inf > span.upper > upper else upper
    axis.count = 1
    if lower < upper:
        axis.count = regions.shape[0] if regions.shape[0] < STRIPS else STRIPS
    axis.lower = lower
    axis.per_metre = axis.count / (upper - lower) if lower < upper else 0.0


@inlined_kernel
def _strip_at(axis: Records, at: float) -> int:
    """The strip in which a place along an axis lies, or which is nearest to it."""
    place = (at - axis.lower) * axis.per_metre
    if not place > 0.0:
        return 0
    return axis.count - 1 if place >= axis.count else int(place)


@kernel
def _reach(region: Records, edges: Records, x: float, y: float) -> float:
    """How far a region reaches along (x, y), a unit vector, at most, m; infinity if it is unknown."""
    first, count = region.first_edge, region.edge_count
    reach = math.inf
    for k in range(count):
        bound = _bound(edges[first + k], edges[first + (k + 1) % count], x, y)
        reach = bound if bound < reach else reach
    if count > 2:  # those that meet behind an edge that cuts the outline
        bound = _bound(edges[first + count - 2], edges[first], x, y)
        reach = bound if bound < reach else reach
    if region.disc_radius > 0.0:
        bound = x * region.disc_x + y * region.disc_y + region.disc_radius
        reach = bound if bound < reach else reach
    if region.kind == ATTRACTION:
        bound = x * region.center_x + y * region.center_y + region.range
        reach = bound if bound < reach else reach
    return reach + _ROUNDING * abs(reach)


@kernel
def _bound(a: Records, b: Records, x: float, y: float) -> float:
    """How far along (x, y) what is in two half-planes reaches at most: by the shares of their normals that make it."""
    det = a.normal_x * b.normal_y - a.normal_y * b.normal_x
    if det == 0.0:
        return math.inf
    of_a = (x * b.normal_y - y * b.normal_x) / det
    of_b = (y * a.normal_x - x * a.normal_y) / det
    return of_a * a.offset + of_b * b.offset if of_a >= 0.0 and of_b >= 0.0 else math.inf
