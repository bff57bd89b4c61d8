"""The separating-axis test on convex cores.

A core is a run of rows in a vertex table (`x, y, normal_x, normal_y`), counter-clockwise, already turned into world
axes but measured from its own body's centre; `dx, dy` leads from the centre of a to the centre of b. Working
with differences keeps the full precision far from the world's origin.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Vector, lanes, load_fields, select, spread, transpose
from sandbox.geometry.core import CoreRows
from sandbox.tables import Records

FAR = 1e300


@inlined_kernel
def face_separation(cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, stop: float) -> tuple[float, int]:
    """(largest separation over the face normals of a, that face): each normal is one axis of the test.

    On the axis of a face, a ends at the face itself, so only the nearest vertex of b has to be found. Negative
    means overlap on every axis of a; then it is the least overlap. Four faces are looked at side by side; the answer
    is that of the first four of which an axis separates by more than `stop` metres. A single-vertex core has no faces:
    (-1e300, -1).
    """
    best = -FAR
    face = -1
    if a.vertex_count < 2:
        return best, face
    for i in range(0, a.vertex_count, WIDTH):
        edge_x, edge_y, nx, ny = _four_vertices(cores, a, i)
        nearest = spread(FAR)
        for j in range(b.start, b.start + b.vertex_count):
            vertex = cores[j]
            along = nx * vertex.x + ny * vertex.y
            nearest = select(along < nearest, along, nearest)
        separation, number = _greatest(lanes(nearest - (nx * (edge_x - dx) + ny * (edge_y - dy))))
        if separation > best:
            best = separation
            face = i + number
        if best > stop:
            return best, face
    return best, face


@inlined_kernel
def _greatest(numbers: tuple[float, float, float, float]) -> tuple[float, int]:
    """The greatest of four numbers, and which it is; the first of equals. By choices, not jumps: nobody can guess."""
    one, two, three, four = numbers
    first = two if two > one else one
    number = 1 if two > one else 0
    last = four if four > three else three
    number = (3 if four > three else 2) if last > first else number
    return last if last > first else first, number


@inlined_kernel
def _four_vertices(cores: Records, core: CoreRows, first: int) -> tuple[Vector, Vector, Vector, Vector]:
    """x, y, normal_x and normal_y of four vertices from number `first` on; behind the last one, of `first` again."""
    row = core.start + first
    left = core.vertex_count - first
    return transpose(
        load_fields(cores, row, 0),
        load_fields(cores, row + 1 if left > 1 else row, 0),
        load_fields(cores, row + 2 if left > 2 else row, 0),
        load_fields(cores, row + 3 if left > 3 else row, 0),
    )


@inlined_kernel
def facing_edge(cores: Records, core: CoreRows, nx: float, ny: float) -> int:
    """Edge of a core that faces most against the direction (nx, ny): the incident edge."""
    lowest = FAR
    facing = 0
    for i in range(core.vertex_count):
        row = cores[core.start + i]
        along = nx * row.normal_x + ny * row.normal_y
        if along < lowest:
            lowest = along
            facing = i
    return facing


@kernel
def support_vertex(cores: Records, core: CoreRows, nx: float, ny: float) -> int:
    """Vertex of a core that lies deepest along the direction -(nx, ny); the first one of equals."""
    lowest = FAR
    deepest = 0
    for i in range(core.vertex_count):
        row = cores[core.start + i]
        along = nx * row.x + ny * row.y
        if along < lowest:
            lowest = along
            deepest = i
    return deepest


@kernel
def core_size(cores: Records, core: CoreRows) -> float:
    """Farthest vertex of a core from its own centre, |x| + |y| in metres."""
    size = 0.0
    for i in range(core.start, core.start + core.vertex_count):
        reach = abs(cores[i].x) + abs(cores[i].y)
        size = reach if reach > size else size
    return size


@kernel
def pair_size(cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float) -> float:
    """Size of two cores and the distance between them in metres: rounding errors of the test are a share of it."""
    return core_size(cores, a) + core_size(cores, b) + abs(dx) + abs(dy)
