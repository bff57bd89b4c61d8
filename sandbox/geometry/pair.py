"""Two shapes in front of the engine's kernels: laid out as they want it, and the doors that Python may go through."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

from sandbox._jit import entry_point, kernel_argument
from sandbox.geometry.closest import closest_points
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


@entry_point
def manifold_of_pair(
    cores: Records,
    a_count: int,
    a_radius: float,
    b_count: int,
    b_radius: float,
    dx: float,
    dy: float,
    share: float,
    out: Records,
) -> tuple[float, float]:
    """The narrow phase on one pair, a's rows first: fills `out[0]`; returns (separation, size of the pair), metres.

    Surfaces farther apart than `share` of the size give no points, and a separation of 1e300 or what it is.
    """  # fmt: skip
    size = pair_size(cores, 0, a_count, a_count, b_count, dx, dy) + a_radius + b_radius
    out[0].separation = FAR
    collide_cores(cores, 0, a_count, a_radius, a_count, b_count, b_radius, dx, dy, share * size, 0.0, out)
    return out[0].separation, size


@entry_point
def manifold_on_axis(
    cores: Records,
    a_count: int,
    a_radius: float,
    b_count: int,
    b_radius: float,
    dx: float,
    dy: float,
    owner: int,
    edge: int,
    corner: int,
    nx: float,
    ny: float,
    out: Records,
) -> int:
    """Fill `out[0]` on the axis that (owner, edge, corner of b) name, whether or not it is the best; at least a point.

    `nx, ny` is the unit normal, from a to b.
    """
    m = out[0]
    b = a_count
    if owner == 2:
        along = nx * (cores[b + corner].x + dx - cores[edge].x) + ny * (cores[b + corner].y + dy - cores[edge].y)
        return corner_manifold(cores, 0, edge, a_radius, corner, b_radius, nx, ny, along, m)
    m.separation = -1.0  # an overlap: it has a point
    return face_manifold(cores, 0, a_count, a_radius, b, b_count, b_radius, dx, dy, 0.0, owner == 1, edge, m)


@entry_point
def nearest_of_pair(
    cores: Records, a_count: int, b_count: int, dx: float, dy: float
) -> tuple[float, float, float, float, float, bool, int, int]:
    """`closest_points` of one pair of disjoint cores."""
    return closest_points(cores, 0, a_count, a_count, b_count, dx, dy)


class Pair(NamedTuple):
    """Both cores in one table, each from its own centre; `center` is that of a, `way` leads from it to that of b."""

    cores: Any
    counts: tuple[int, int]
    radii: Vec
    center: Vec
    way: Vec

    def manifold(self, share: float) -> tuple[float, float, Any]:
        """`manifold_of_pair`: (separation, size of the pair, manifold row)."""
        out = MANIFOLD.zeros(1)
        (m, n), (r, q) = self.counts, self.radii
        separation, size = manifold_of_pair(self.cores, m, r, n, q, *self.way, share, kernel_argument(out))
        return separation, size, out[0]

    def manifold_on(self, axis: Axis) -> Any:
        """`manifold_on_axis`: the manifold row."""
        out = MANIFOLD.zeros(1)
        (m, n), (r, q), named = self.counts, self.radii, (axis.owner, axis.edge, axis.corner)
        manifold_on_axis(self.cores, m, r, n, q, *self.way, *named, *axis.normal, kernel_argument(out))
        return out[0]

    def nearest(self) -> tuple[float, Vec, Vec]:
        """(distance, point of a, point of b) of disjoint cores; points from the centre of a, metres."""
        square, ax, ay, bx, by, *_vertices = nearest_of_pair(self.cores, *self.counts, *self.way)
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
