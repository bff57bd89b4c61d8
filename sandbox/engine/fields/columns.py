"""Which regions a body may be in: the x axis cut into columns, each of which knows the regions that reach into it.

In: regions, edges, the step. Out: for each column a set of regions, as bits, of those that act. There are as many
columns as regions, over where these begin and end: where they lie side by side, a body is in the columns of a few.

How far a region reaches is a linear program in two unknowns; each two of its half-planes bound it (duality), and those
that meet in its outermost corner do so best. They follow each other in its outline, which one more edge may cut.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.fields.area import acts
from sandbox.engine.fields.records import BITS, COLUMNS, Fields
from sandbox.tables import Records
from sandbox.world.field_records import ATTRACTION

_ROUNDING = 1e-9
"""Share of its coordinates by which a region counts as wider: far more than what is rounded."""


@kernel
def lay_columns(fields: Fields, step: int) -> None:
    """Write down which regions act where in a step."""
    regions, grid = fields.regions, fields.column_grid[0]
    count = regions.shape[0] if regions.shape[0] < COLUMNS else COLUMNS
    grid.words = (regions.shape[0] + BITS - 1) // BITS
    left = math.inf
    right = -math.inf
    for k in range(regions.shape[0]):
        span = fields.spans[k]
        span.left = -_reach(regions[k], fields.edges, -1.0)
        span.right = _reach(regions[k], fields.edges, 1.0)
        left = span.left if -math.inf < span.left < left else left
        right = span.right if math.inf > span.right > right else right
    grid.count = count if left < right else 1
    grid.left = left
    grid.per_metre = grid.count / (right - left) if left < right else 0.0
    fields.columns[: grid.count * grid.words] = 0
    for k in range(regions.shape[0]):
        if acts(regions[k], step):
            span = fields.spans[k]
            for c in range(column_at(grid, span.left), column_at(grid, span.right) + 1):
                fields.columns[c * grid.words + k // BITS] |= 1 << (k % BITS)


@inlined_kernel
def column_at(grid: Records, x: float) -> int:
    """The column in which a place lies, or which is nearest to it."""
    place = (x - grid.left) * grid.per_metre
    if not place > 0.0:
        return 0
    return grid.count - 1 if place >= grid.count else int(place)


@kernel
def look_up(fields: Fields, push: Records, extent: float) -> None:
    """Write to `fields.found` the set of the regions that act and may reach a body."""
    grid = fields.column_grid[0]
    first, last = column_at(grid, push.x - extent), column_at(grid, push.x + extent)
    for word in range(grid.words):
        found = 0
        for c in range(first, last + 1):
            found |= fields.columns[c * grid.words + word]
        fields.found[word] = found


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
def _reach(region: Records, edges: Records, way: float) -> float:
    """How far a region reaches along x (`way` is 1) or against it (-1) at most, that way; infinity if it is unknown."""
    first, count = region.first_edge, region.edge_count
    reach = math.inf
    for k in range(count):
        bound = _bound(edges[first + k], edges[first + (k + 1) % count], way)
        reach = bound if bound < reach else reach
    if count > 2:  # those that meet behind an edge that cuts the outline
        bound = _bound(edges[first + count - 2], edges[first], way)
        reach = bound if bound < reach else reach
    if region.disc_radius > 0.0:
        bound = way * region.disc_x + region.disc_radius
        reach = bound if bound < reach else reach
    if region.kind == ATTRACTION:
        bound = way * region.center_x + region.range
        reach = bound if bound < reach else reach
    return reach + _ROUNDING * abs(reach)


@kernel
def _bound(a: Records, b: Records, way: float) -> float:
    """How far along `way` what lies in two half-planes reaches at most: by the shares of their normals that make it."""
    det = a.normal_x * b.normal_y - a.normal_y * b.normal_x
    if det == 0.0:
        return math.inf
    of_a = way * b.normal_y / det
    of_b = -way * a.normal_y / det
    return of_a * a.offset + of_b * b.offset if of_a >= 0.0 and of_b >= 0.0 else math.inf
