"""What a shape at rest overlaps, and what lies nearest to a point."""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.queries.filter import is_seen
from sandbox.engine.queries.question import Gap, contact_point, distance_to
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.engine.queries.walk import begin_walk, next_box
from sandbox.tables import Records


@entry_point
def overlaps(tables: QueryTables, memory: Memory, x: float, y: float, hits: Records) -> int:
    """Every shape that the query shape at (x, y) touches, in the order of the grid; return how many there are.

    `fraction` is the signed distance, never positive. Those past the capacity of `hits` are counted but not written.
    """
    walk = memory.walk[0]
    question = memory.question[0]
    begin_walk(walk, question, x, y, 0.0, 0.0, 0.0)
    count = 0
    while True:
        row = next_box(walk, memory.grid)
        if row < 0:
            break
        i = memory.grid.ordered[row].shape_index
        shape = tables.shapes[i]
        body = tables.bodies[shape.body]
        if is_seen(question, shape, body.type, memory.hidden):
            gap = distance_to(memory.cores, question, shape, body, x, y)
            if gap.distance <= gap.slack:
                if count < hits.shape[0]:
                    hits[count].shape_index = i
                    _answer(memory.cores, question, shape, body, x, y, gap, hits[count])
                count += 1
    return count


@entry_point
def nearest_shape(tables: QueryTables, memory: Memory, x: float, y: float, within: float, hits: Records) -> bool:
    """The shape with the least signed distance from (x, y) if it is at most `within` metres; False if there is none.

    Looks around in a box that grows until it is wider than the best distance found. Of equal ones the lowest counts.
    """
    regions = memory.grid.regions
    everything = regions[regions.shape[0] - 1]
    all_x = abs(x - everything.lower_x) + abs(x - everything.upper_x)
    all_y = abs(y - everything.lower_y) + abs(y - everything.upper_y)
    most = all_x + all_y
    most = most if most < within else within
    reach = _first_reach(regions, memory.question[0].region_count)
    while True:
        reach = reach if reach < most else most
        found = _nearest_in_box(tables, memory, x, y, reach, hits[0])
        distance = hits[0].fraction
        if found and distance <= reach:
            return True
        if reach >= most:
            return False
        reach = distance if found else 4.0 * reach


@kernel
def _first_reach(regions: Records, region_count: int) -> float:
    """A cell of the finest level with many boxes, in metres."""
    return 1.0 / regions[0].cells_per_metre if region_count > 0 else 1.0


@kernel
def _nearest_in_box(tables: QueryTables, memory: Memory, x: float, y: float, reach: float, hit: Records) -> bool:
    """The nearest of the shapes whose boxes come within `reach` metres along both axes."""
    walk = memory.walk[0]
    question = memory.question[0]
    begin_walk(walk, question, x, y, 0.0, 0.0, reach)
    found = False
    while True:
        row = next_box(walk, memory.grid)
        if row < 0:
            break
        i = memory.grid.ordered[row].shape_index
        shape = tables.shapes[i]
        body = tables.bodies[shape.body]
        if is_seen(question, shape, body.type, memory.hidden):
            gap = distance_to(memory.cores, question, shape, body, x, y)
            least = hit.fraction
            if not found or gap.distance < least or (gap.distance == least and i < hit.shape_index):
                found = True
                hit.shape_index = i
                _answer(memory.cores, question, shape, body, x, y, gap, hit)
    return found


@kernel
def _answer(
    cores: Records, question: Records, shape: Records, body: Records, x: float, y: float, gap: Gap, hit: Records
) -> None:
    """Fill in a hit but for its shape: the point of the surface that is nearest to a point, or meets a shape."""
    hit.body = shape.body
    hit.fraction = gap.distance
    hit.normal_x = gap.normal_x
    hit.normal_y = gap.normal_y
    hit.x = x - gap.distance * gap.normal_x
    hit.y = y - gap.distance * gap.normal_y
    if question.extent > 0.0:
        hit.x, hit.y = contact_point(cores, question, shape, body, x, y, gap.normal_x, gap.normal_y)
