"""Which features of two rounded cores are closest, or overlap least: a face and what is nearest to it, or two vertices.

Faces are the axes of the separating-axis test. Where rounded cores do not overlap and are closest at two vertices,
the axis between those vertices decides instead.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.closest_vertices import closest_vertices
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import face_separation, pair_size
from sandbox.tables import Records

APART, FACE_OF_A, FACE_OF_B, VERTICES = -1, 0, 1, 2
"""Whose feature gives the axis of two cores; `APART` if they are too far apart to ask."""

_ROUNDING = 4e-15
"""How far a computed separation may be off, as a share of the pair's size."""


class Features(NamedTuple):
    """The closest features of two cores.

    `owner` is `FACE_OF_A` (face `a`), `FACE_OF_B` (face `b`), `VERTICES` (vertex `a` of a and `b` of b), or `APART`,
    when nothing else counts. The unit normal points from a to b. `distance` (m) is along it from core to core,
    `separation` from surface to surface; negative is the overlap.
    """

    owner: int
    a: int
    b: int
    normal_x: float
    normal_y: float
    distance: float
    separation: float


@inlined_kernel
def closest_features(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, margin: float, face_bias: float
) -> Features:
    """The features of two cores that give their axis of least overlap, or of their distance.

    `margin` (m): surfaces farther apart than this are `APART`. `face_bias` (m): by how much a face of b has to beat the
    best face of a; 0 gives the exact minimum. Of sharp cores that are apart, it is the best face that counts.
    """
    if a.vertex_count == 1 and b.vertex_count == 1:
        return _closest_discs(cores, a, b, dx, dy, margin)
    radii = a.radius + b.radius
    reach = radii + margin
    separation_a, face_a = face_separation(cores, a, b, dx, dy, reach)
    if separation_a > reach:
        return Features(APART, face_a, face_a, 0.0, 0.0, separation_a, separation_a)
    separation_b, face_b = face_separation(cores, b, a, -dx, -dy, reach)
    if separation_b > reach:
        return Features(APART, face_b, face_b, 0.0, 0.0, separation_b, separation_b)
    flip = face_a < 0 or (face_b >= 0 and separation_b > separation_a + face_bias)
    distance = separation_b if flip else separation_a
    if radii > 0.0 or (a.vertex_count <= 2 and b.vertex_count <= 2):
        # Points and lines in one line overlap on all their face normals, however far apart they are, and so do slivers
        # to rounding: only a clear overlap of the cores rules their corners out.
        slack = _ROUNDING * pair_size(cores, a, b, dx, dy)
        if distance > -slack:
            # Faces flat on each other are as close at their corners: there the face gives the better manifold.
            least = distance + 3.0 * slack + face_bias
            face = face_b if flip else face_a
            corner, i, j, nx, ny, length = closest_vertices(cores, a, b, dx, dy, flip, face, least)
            if corner:
                owner = APART if length > reach else VERTICES
                return Features(owner, i, j, nx, ny, length, length - a.radius - b.radius)
    row = cores[b.start + face_b if flip else a.start + face_a]
    nx = -row.normal_x if flip else row.normal_x
    ny = -row.normal_y if flip else row.normal_y
    return Features(FACE_OF_B if flip else FACE_OF_A, face_a, face_b, nx, ny, distance, distance - radii)


@kernel
def _closest_discs(cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, margin: float) -> Features:
    """Two discs. Concentric ones part along +y: some axis has to be chosen, and always the same one."""
    gx = cores[b.start].x + dx - cores[a.start].x
    gy = cores[b.start].y + dy - cores[a.start].y
    distance = math.sqrt(gx * gx + gy * gy)
    separation = distance - a.radius - b.radius
    if separation > margin:
        return Features(APART, 0, 0, 0.0, 0.0, distance, separation)
    nx = 0.0
    ny = 1.0
    if distance > 0.0:
        nx = gx / distance
        ny = gy / distance
    return Features(VERTICES, 0, 0, nx, ny, distance, separation)
