"""The gap between two bodies: the least signed distance of any shape of one from any shape of the other."""

from __future__ import annotations

from typing import Any

from sandbox._jit import entry_point, kernel
from sandbox.engine.queries.boxes import bound
from sandbox.engine.queries.question import ask_about, contact_point, distance_to
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.geometry.sat import FAR
from sandbox.tables import Integers, Records


@entry_point
def find_gap(tables: QueryTables, memory: Memory, shapes_a: Integers, shapes_b: Integers, hits: Records) -> None:
    """Fill `hits[0]` with the closest shape and point of a, `hits[1]` with those of b; `fraction` is the distance.

    `shapes_a` and `shapes_b` are the shapes of both bodies. Normals point out of each body towards the other. Of equal
    distances the first pair counts.
    """
    bodies = tables.bodies
    shapes = tables.shapes
    cores = memory.cores
    boxes: Any = memory.boxes
    question = memory.question[0]
    a = hits[0]
    b = hits[1]
    b.fraction = FAR
    for m in range(shapes_b.shape[0]):
        bound(tables, memory, shapes_b[m], boxes[m])
    for k in range(shapes_a.shape[0]):
        i = shapes_a[k]
        body = bodies[shapes[i].body]
        box = boxes[shapes_b.shape[0]]
        bound(tables, memory, i, box)
        ask_about(cores, shapes[i], body, question)
        for m in range(shapes_b.shape[0]):
            j = shapes_b[m]
            if _box_gap(box, boxes[m]) < b.fraction:
                other = bodies[shapes[j].body]
                x = body.center_x
                y = body.center_y
                gap = distance_to(cores, question, shapes[j], other, x, y)
                if gap.distance < b.fraction:
                    a.shape_index = i
                    b.shape_index = j
                    b.fraction = gap.distance
                    b.normal_x = gap.normal_x
                    b.normal_y = gap.normal_y
    _place(tables, cores, question, int(a.shape_index), int(b.shape_index), a, b)


@kernel
def _box_gap(a: Records, b: Records) -> float:
    """How far two boxes are apart along the better axis, negative if they overlap: shapes in them are not nearer."""
    x = a.lower_x - b.upper_x if a.lower_x - b.upper_x > b.lower_x - a.upper_x else b.lower_x - a.upper_x
    y = a.lower_y - b.upper_y if a.lower_y - b.upper_y > b.lower_y - a.upper_y else b.lower_y - a.upper_y
    return float(x if x > y else y)


@kernel
def _place(tables: QueryTables, cores: Records, question: Records, i: int, j: int, a: Records, b: Records) -> None:
    """Fill in the closest points, and a's side of what is known of b's."""
    shapes = tables.shapes
    shape = shapes[i]
    body = tables.bodies[int(shape.body)]
    other = tables.bodies[int(shapes[j].body)]
    nx = b.normal_x
    ny = b.normal_y
    ask_about(cores, shape, body, question)
    b.body = shapes[j].body
    b.x, b.y = contact_point(cores, question, shapes[j], other, body.center_x, body.center_y, nx, ny)
    a.body = shape.body
    a.fraction = b.fraction
    a.normal_x = -nx
    a.normal_y = -ny
    a.x = b.x + b.fraction * nx
    a.y = b.y + b.fraction * ny
