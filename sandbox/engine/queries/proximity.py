"""What a shape at rest overlaps, and what lies nearest to a point."""

from __future__ import annotations

from sandbox._jit import ZERO, entry_point, kernel
from sandbox.engine.queries.filter import is_seen
from sandbox.engine.queries.question import contact_point, distance_to
from sandbox.engine.queries.walk import begin_walk, next_box
from sandbox.tables import Integers, Records


@entry_point
def overlaps(
    bodies: Records,
    shapes: Records,
    turned: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    regions: Records,
    question: Records,
    walk: Records,
    hidden: Integers,
    x: float,
    y: float,
    hits: Records,
) -> int:
    """Every shape that the query shape at (x, y) touches, in the order of the grid; return how many there are.

    `fraction` is the signed distance, never positive. Those past the capacity of `hits` are counted but not written.
    """
    w = walk[0]
    begin_walk(w, question[0], x, y, 0.0, 0.0, 0.0)
    count = ZERO
    while True:
        row = next_box(w, question[0], ordered, heads, levels, regions)
        if row < 0:
            break
        i = ordered[row].shape_index
        shape = shapes[i]
        body = bodies[shape.body]
        if is_seen(question[0], shape, body.type, hidden):
            distance, nx, ny, slack = distance_to(turned, question[0], shape, body, x, y)
            if distance <= slack:
                if count < hits.shape[0]:
                    _answer(turned, question[0], shape, body, i, x, y, distance, nx, ny, hits[count])
                count += 1
    return count


@entry_point
def nearest_shape(
    bodies: Records,
    shapes: Records,
    turned: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    regions: Records,
    question: Records,
    walk: Records,
    hidden: Integers,
    x: float,
    y: float,
    within: float,
    hits: Records,
) -> bool:
    """The shape with the least signed distance from (x, y) if it is at most `within` metres; False if there is none.

    Looks around in a box that grows until it is wider than the best distance found. Of equal ones the lowest counts.
    """
    everything = regions[regions.shape[0] - 1]
    all_x = abs(x - everything.lower_x) + abs(x - everything.upper_x)
    all_y = abs(y - everything.lower_y) + abs(y - everything.upper_y)
    most = all_x + all_y
    most = most if most < within else within
    reach = _first_reach(regions, question[0].region_count)
    while True:
        reach = reach if reach < most else most
        found = _nearest_in_box(
            bodies, shapes, turned, ordered, heads, levels, regions, question, walk, hidden, x, y, reach, hits[0]
        )
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
def _nearest_in_box(
    bodies: Records,
    shapes: Records,
    turned: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    regions: Records,
    question: Records,
    walk: Records,
    hidden: Integers,
    x: float,
    y: float,
    reach: float,
    hit: Records,
) -> bool:
    """The nearest of the shapes whose boxes come within `reach` metres along both axes."""
    w = walk[0]
    begin_walk(w, question[0], x, y, 0.0, 0.0, reach)
    found = False
    while True:
        row = next_box(w, question[0], ordered, heads, levels, regions)
        if row < 0:
            break
        i = ordered[row].shape_index
        shape = shapes[i]
        body = bodies[shape.body]
        if is_seen(question[0], shape, body.type, hidden):
            distance, nx, ny, _slack = distance_to(turned, question[0], shape, body, x, y)
            least = hit.fraction
            if not found or distance < least or (distance == least and i < hit.shape_index):
                found = True
                _answer(turned, question[0], shape, body, i, x, y, distance, nx, ny, hit)
    return found


@kernel
def _answer(
    turned: Records,
    question: Records,
    shape: Records,
    body: Records,
    index: int,
    x: float,
    y: float,
    distance: float,
    nx: float,
    ny: float,
    hit: Records,
) -> None:
    """Fill in a hit: its point is the point of the surface that is nearest to a point, or meets a shape."""
    hit.shape_index = index
    hit.body = shape.body
    hit.fraction = distance
    hit.normal_x = nx
    hit.normal_y = ny
    hit.x = x - distance * nx
    hit.y = y - distance * ny
    if question.extent > 0.0:
        hit.x, hit.y = contact_point(turned, question, shape, body, x, y, nx, ny)
