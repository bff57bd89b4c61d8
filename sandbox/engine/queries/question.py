"""One shape of the world against the shape that is asked about: both as one core, the question as a point."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.queries.records import MAX_CORE, SPARE_CORES
from sandbox.geometry.core import CoreRows, core_of
from sandbox.geometry.depth import signed_distance
from sandbox.geometry.minkowski import add_cores, touching_side
from sandbox.geometry.ray import ray_enters, ray_slack
from sandbox.tables import Records

_FLAT = 1e-10
"""Share of the sizes within which corners count as lying in one line with the touch."""


class Gap(NamedTuple):
    """The signed distance (m) of the query shape from a shape, the outward unit normal of that shape where they are
    nearest, and what rounding may hide of the distance (m)."""

    distance: float
    normal_x: float
    normal_y: float
    slack: float


@kernel
def ask_about(cores: Records, shape: Records, body: Records, question: Records) -> None:
    """Make a shape of the world the query shape; its reference point is the centre of its body."""
    mirrored = cores.shape[0] - SPARE_CORES
    for k in range(shape.vertex_count):
        source = cores[shape.vertex_start + k]
        target = cores[mirrored + k]
        target.x = -source.x
        target.y = -source.y
        target.normal_x = -source.normal_x
        target.normal_y = -source.normal_y
    question.count = shape.vertex_count
    question.radius = shape.radius
    question.extent = body.extent


@kernel
def combined_core(cores: Records, question: Records, shape: Records) -> CoreRows:
    """The core that the reference point touches when the query shape touches `shape`.

    A question of a point or a disc needs no sum: its radius is added to that of the shape.
    """
    radius = shape.radius + question.radius
    mirrored = cores.shape[0] - SPARE_CORES
    if question.count == 1 and cores[mirrored].x == 0.0 and cores[mirrored].y == 0.0:
        return CoreRows(shape.vertex_start, shape.vertex_count, radius)
    target = mirrored + MAX_CORE
    asked = CoreRows(mirrored, question.count, question.radius)
    return CoreRows(target, add_cores(cores, core_of(shape), asked, target), radius)


@kernel
def distance_to(cores: Records, question: Records, shape: Records, body: Records, x: float, y: float) -> Gap:
    """The gap between the query shape at (x, y) and a shape."""
    core = combined_core(cores, question, shape)
    px = x - body.center_x
    py = y - body.center_y
    slack = ray_slack(px, py, 0.0, 0.0, body.extent + question.extent)
    distance, nx, ny = signed_distance(cores, core, px, py, slack)
    return Gap(distance, nx, ny, slack)


@kernel
def cast_against(
    cores: Records, question: Records, shape: Records, body: Records, walk: Records, box: Records
) -> tuple[float, float, float]:
    """(fraction of the way at which the query shape touches a shape, outward normal x, y); `MISS` if it does not.

    Where they touch at the start the fraction is 0; where they overlap there, the normal is 0 as well.
    """
    core = combined_core(cores, question, shape)
    px = walk.x - body.center_x
    py = walk.y - body.center_y
    slack = ray_slack(px, py, walk.translation_x, walk.translation_y, body.extent + question.extent)
    if _bounds_meet(walk, box):
        near = ray_slack(px, py, 0.0, 0.0, body.extent + question.extent)
        distance, nx, ny = signed_distance(cores, core, px, py, near)
        if distance < -near:
            return 0.0, 0.0, 0.0
        if distance <= near:
            return 0.0, nx, ny
    return ray_enters(cores, core, px, py, walk.translation_x, walk.translation_y, slack)


@kernel
def _bounds_meet(walk: Records, box: Records) -> bool:
    """Whether the query shape lies in the bounds of a shape at the start."""
    in_x = walk.x + walk.upper_x >= box.lower_x and walk.x + walk.lower_x <= box.upper_x
    return bool(in_x and walk.y + walk.upper_y >= box.lower_y and walk.y + walk.lower_y <= box.upper_y)


@kernel
def contact_point(
    cores: Records, question: Records, shape: Records, body: Records, x: float, y: float, nx: float, ny: float
) -> tuple[float, float]:
    """Point of a shape's surface that meets the query shape at (x, y), given the normal: the middle if it is a line."""
    slack = _FLAT * (body.extent + question.extent)
    mirrored = cores.shape[0] - SPARE_CORES
    far, low, high = touching_side(cores, core_of(shape), nx, ny, slack)
    asked = CoreRows(mirrored, question.count, question.radius)
    _far, mirrored_low, mirrored_high = touching_side(cores, asked, nx, ny, slack)
    across = nx * (y - body.center_y) - ny * (x - body.center_x)
    low = low if low > across - mirrored_high else across - mirrored_high
    high = high if high < across - mirrored_low else across - mirrored_low
    middle = 0.5 * (low + high)
    far = far + shape.radius
    return body.center_x + (nx * far - ny * middle), body.center_y + (ny * far + nx * middle)
