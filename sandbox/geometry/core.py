"""A rounded convex core as one argument: where its vertices are, and its radius."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
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
