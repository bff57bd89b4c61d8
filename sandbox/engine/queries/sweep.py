"""Rays and shape casts: what something meets on a straight way. A ray is the cast of a point."""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.queries.filter import is_seen
from sandbox.engine.queries.question import cast_against, contact_point, distance_to
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.engine.queries.walk import begin_walk, next_box
from sandbox.tables import Floats, Records


@entry_point
def first_hits(tables: QueryTables, memory: Memory, rays: Floats, hits: Records) -> None:
    """The first hit of each way, row by row; a row without one gets shape -1, fraction 1 and the end of its way.

    `rays` are rows (x, y, translation x, translation y) in metres. Of equal fractions the lowest shape counts.
    """
    w = memory.walk[0]
    question = memory.question[0]
    ordered = memory.grid.ordered
    for k in range(rays.shape[0]):
        begin_walk(w, question, rays[k, 0], rays[k, 1], rays[k, 2], rays[k, 3], 0.0)
        hit = hits[k]
        _miss(hit, w)
        while True:
            row = next_box(w, memory.grid)
            if row < 0:
                break
            i = ordered[row].shape_index
            shape = tables.shapes[i]
            body = tables.bodies[shape.body]
            if is_seen(question, shape, body.type, memory.hidden):
                t, nx, ny = cast_against(memory.cores, question, shape, body, w, ordered[row])
                if t >= 0.0 and (t < w.limit or (t == w.limit and (hit.shape_index < 0 or i < hit.shape_index))):
                    w.limit = t
                    hit.shape_index = i
                    hit.fraction = t
                    hit.normal_x = nx
                    hit.normal_y = ny
        if hit.shape_index >= 0:
            _place(tables, memory.cores, question, w, int(hit.shape_index), hit)


@entry_point
def all_hits(tables: QueryTables, memory: Memory, rays: Floats, hits: Records) -> int:
    """Every shape that the first of `rays` meets, in the order of the grid; return how many there are.

    Those past the capacity of `hits` are counted but not written.
    """
    w = memory.walk[0]
    question = memory.question[0]
    ordered = memory.grid.ordered
    begin_walk(w, question, rays[0, 0], rays[0, 1], rays[0, 2], rays[0, 3], 0.0)
    count = 0
    while True:
        row = next_box(w, memory.grid)
        if row < 0:
            break
        i = ordered[row].shape_index
        shape = tables.shapes[i]
        body = tables.bodies[shape.body]
        if is_seen(question, shape, body.type, memory.hidden):
            t, nx, ny = cast_against(memory.cores, question, shape, body, w, ordered[row])
            if t >= 0.0:
                if count < hits.shape[0]:
                    hit = hits[count]
                    hit.shape_index = i
                    hit.fraction = t
                    hit.normal_x = nx
                    hit.normal_y = ny
                    _place(tables, memory.cores, question, w, int(hit.shape_index), hit)
                count += 1
    return count


@kernel
def _miss(hit: Records, walk: Records) -> None:
    hit.shape_index = -1
    hit.body = -1
    hit.fraction = 1.0
    hit.x = walk.x + walk.translation_x
    hit.y = walk.y + walk.translation_y
    hit.normal_x = 0.0
    hit.normal_y = 0.0


@kernel
def _place(tables: QueryTables, cores: Records, question: Records, walk: Records, i: int, hit: Records) -> None:
    """Fill in the body and the point of a hit: for a ray where it has come to, for a cast where the shapes touch."""
    shape = tables.shapes[i]
    body = tables.bodies[int(shape.body)]
    x = walk.x + hit.fraction * walk.translation_x
    y = walk.y + hit.fraction * walk.translation_y
    nx = hit.normal_x
    ny = hit.normal_y
    hit.body = shape.body
    hit.x = x
    hit.y = y
    if question.extent > 0.0:
        if nx == 0.0 and ny == 0.0:
            _distance, nx, ny, _slack = distance_to(cores, question, shape, body, x, y)
        hit.x, hit.y = contact_point(cores, question, shape, body, x, y, nx, ny)
