"""A rounded convex core as one argument: where its vertices are, and its radius."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Records


class CoreRows(NamedTuple):
    """Rows `start` to before `start + vertex_count` of a vertex table, counter-clockwise, rounded by `radius` metres.

    Plain numbers: kernels take it as three scalars.
    """

    start: int
    vertex_count: int
    radius: float


@inlined_kernel
def core_of(shape: Records) -> CoreRows:
    """The core of a shape, or of a proxy of one."""
    return CoreRows(shape.vertex_start, shape.vertex_count, shape.radius)


@kernel
def core_middle(cores: Records, core: CoreRows) -> tuple[float, float]:
    """Mean (m) of the vertices of a core, which lies within it."""
    x = 0.0
    y = 0.0
    for k in range(core.start, core.start + core.vertex_count):
        x += cores[k].x
        y += cores[k].y
    return float(x / core.vertex_count), float(y / core.vertex_count)
