"""Two shapes in front of the engine's kernels: laid out as they want it, and the doors that Python may go through."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

from sandbox._jit import entry_point, kernel, kernel_argument
from sandbox.geometry.closest import closest_points
from sandbox.geometry.closest_features import FACE_OF_B, VERTICES
from sandbox.geometry.core import CoreRows
from sandbox.geometry.exact_axes import Axis
from sandbox.geometry.manifold import MANIFOLD, collide_cores, corner_manifold, face_manifold
from sandbox.geometry.mass import edge_normals
from sandbox.geometry.sat import FAR, pair_size
from sandbox.geometry.shapes import Core
from sandbox.tables import Field, Records, Table

CORE = Table(
    "core",
    (
        Field("x", "m", "vertex from the core's centre"),
        Field("y", "m", "vertex from the core's centre"),
        Field("normal_x", "1", "outward unit normal of the edge from this vertex to the next; 0 for a point"),
        Field("normal_y", "1", "outward unit normal of the edge from this vertex to the next; 0 for a point"),
    ),
)

Vec = tuple[float, float]
Counts = tuple[int, int]


@entry_point
def manifold_of_pair(
    cores: Records, counts: Counts, radii: Vec, displacement: Vec, share: float, out: Records
) -> tuple[float, float]:
    """The narrow phase on one pair, a's rows first: fills `out[0]`; returns (separation, size of the pair), metres.

    `counts` and `radii` are those of a and b, `displacement` leads from the centre of a to that of b.

    Surfaces farther apart than `share` of the size give no points, and a separation of 1e300 or what it is.
    """
    a, b = _two_cores(counts, radii)
    dx, dy = displacement
    size = pair_size(cores, a, b, dx, dy) + a.radius + b.radius
    out[0].separation = FAR
    collide_cores(cores, a, b, dx, dy, share * size, 0.0, out)
    return out[0].separation, size


@entry_point
def manifold_on_axis(
    cores: Records,
    counts: Counts,
    radii: Vec,
    displacement: Vec,
    named: tuple[int, int, int],
    normal: Vec,
    out: Records,
) -> int:
    """Fill `out[0]` on the axis that (owner, edge, corner of b) name, whether or not it is the best; at least a point.

    `normal` is the unit normal, from a to b.
    """
    m = out[0]
    a, b = _two_cores(counts, radii)
    dx, dy = displacement
    owner, edge, corner = named
    nx, ny = normal
    if owner == VERTICES:
        p = cores[edge]
        q = cores[b.start + corner]
        along = nx * (q.x + dx - p.x) + ny * (q.y + dy - p.y)
        return corner_manifold(cores, a, b, edge, corner, nx, ny, along, m)
    m.separation = -1.0  # an overlap: it has a point
    return face_manifold(cores, a, b, dx, dy, 0.0, owner == FACE_OF_B, edge, m)


@entry_point
def nearest_of_pair(
    cores: Records, counts: Counts, displacement: Vec
) -> tuple[float, float, float, float, float, bool, int, int]:
    """`closest_points` of one pair of disjoint cores."""
    a, b = _two_cores(counts, (0.0, 0.0))
    return closest_points(cores, a, b, displacement[0], displacement[1])


@kernel
def _two_cores(counts: Counts, radii: Vec) -> tuple[CoreRows, CoreRows]:
    """The cores of a pair, a's rows first."""
    return CoreRows(0, counts[0], radii[0]), CoreRows(counts[0], counts[1], radii[1])


class Pair(NamedTuple):
    """Both cores in one table, each from its own centre: `center` is that of a, `displacement` leads to that of b."""

    cores: Any
    counts: Counts
    radii: Vec
    center: Vec
    displacement: Vec

    def manifold(self, share: float) -> tuple[float, float, Any]:
        """`manifold_of_pair`: (separation, size of the pair, manifold row)."""
        out = MANIFOLD.zeros(1)
        arguments = (self.cores, self.counts, self.radii, self.displacement, share, kernel_argument(out))
        separation, size = manifold_of_pair(*arguments)
        return separation, size, out[0]

    def manifold_on(self, axis: Axis) -> Any:
        """`manifold_on_axis`: the manifold row."""
        out = MANIFOLD.zeros(1)
        pair, named = (self.cores, self.counts, self.radii, self.displacement), (axis.owner, axis.edge, axis.corner)
        manifold_on_axis(*pair, named, axis.normal, kernel_argument(out))
        return out[0]

    def nearest(self) -> tuple[float, Vec, Vec]:
        """(distance, point of a, point of b) of disjoint cores; points from the centre of a, metres."""
        square, ax, ay, bx, by, *_vertices = nearest_of_pair(self.cores, self.counts, self.displacement)
        return float(square) ** 0.5, (ax, ay), (bx, by)

    def in_world(self, x: float, y: float) -> Vec:
        """A point given from the centre of a, in world coordinates."""
        return float(self.center[0] + x), float(self.center[1] + y)


def pair_of(a: Core, b: Core) -> Pair:
    """Lay out two shapes. Differences from centres keep the precision far from the origin."""
    (rows_a, (ax, ay)), (rows_b, (bx, by)) = _rows(a.vertices), _rows(b.vertices)
    cores = CORE.zeros(len(rows_a) + len(rows_b))
    for i, row in enumerate((*rows_a, *rows_b)):
        cores[i] = row
    counts = len(rows_a), len(rows_b)
    return Pair(kernel_argument(cores), counts, (a.radius, b.radius), (ax, ay), (bx - ax, by - ay))


@lru_cache(maxsize=1024)
def _rows(vertices: tuple[Vec, ...]) -> tuple[tuple[tuple[float, float, float, float], ...], Vec]:
    """Rows of a core from its centre, and that centre: the middle of the box around it."""
    xs, ys = [x for x, _ in vertices], [y for _, y in vertices]
    cx, cy = min(xs) + (max(xs) - min(xs)) / 2, min(ys) + (max(ys) - min(ys)) / 2
    core = [(x - cx, y - cy) for x, y in vertices]
    return tuple((*vertex, *normal) for vertex, normal in zip(core, edge_normals(core), strict=True)), (cx, cy)
