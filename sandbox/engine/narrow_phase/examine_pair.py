"""What a pair with seams, or a one-way shape, makes of its manifold: whether it holds, and of which moment it is."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.narrow_phase.internal_edges import PlacedPair, fix_internal_edge
from sandbox.engine.narrow_phase.one_way import holds, leads_on
from sandbox.engine.narrow_phase.outline import EdgeTables
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""
TOUCHING = 1e-6
"""Bodies put onto each other may be so far apart, by rounding (m)."""


class Approach(NamedTuple):
    """Velocity (m/s) of b against a, the time (s) at which the pair is looked at, the length of the step (s), and how
    far from touching it may be then (m)."""

    vx: float
    vy: float
    t: float
    seconds: float
    margin: float


@inlined_kernel
def collide_pair(
    proxies: Records,
    cores: Records,
    i: int,
    j: int,
    shift_x: float,
    shift_y: float,
    margin: float,
    face_bias: float,
    manifold: Records,
) -> bool:
    """Manifold of a pair of shapes, with b moved against a by (shift_x, shift_y) metres."""
    a = proxies[i]
    b = proxies[j]
    return (
        collide_cores(
            cores,
            core_of(a),
            core_of(b),
            b.center_x - a.center_x + shift_x,
            b.center_y - a.center_y + shift_y,
            margin,
            face_bias,
            manifold,
        )
        > 0
    )


@kernel
def examine_pair(
    tables: EdgeTables, proxies: Records, i: int, j: int, known: bool, approach: Approach, manifold: Records
) -> float:
    """The time of which the manifold of a pair with seams or a one-way shape is, put right; -1 if it does not hold.

    What may first touch a part across a seam is looked at where the step will bring it. `known` if the
    pair has a contact already.
    """
    x = proxies[j].center_x - proxies[i].center_x
    y = proxies[j].center_y - proxies[i].center_y
    traits = tables.shapes[i].traits | tables.shapes[j].traits
    vx = approach.vx
    vy = approach.vy
    seconds = approach.seconds
    t = approach.t
    now = t == 0.0
    bias = FACE_BIAS * tables.units_per_meter
    travels = seconds * (abs(vx) + abs(vy)) > TOUCHING * tables.units_per_meter
    while traits & SEAMED and not fix_internal_edge(
        tables, PlacedPair(i, j, x + vx * t, y + vy * t), vx * seconds, vy * seconds, approach.margin, bias, now,
        manifold,
    ):  # fmt: skip
        if t == seconds or not travels:
            return -1.0
        t = seconds
        now = False
        if not collide_pair(proxies, tables.cores, i, j, vx * t, vy * t, approach.margin, bias, manifold):
            return -1.0
    if traits & ONE_WAY == 0:
        return t
    if not leads_on(tables.bodies, tables.shapes, i, j, manifold[0].normal_x, manifold[0].normal_y):
        return -1.0
    slop = allowed_depth(tables.shapes[i], tables.shapes[j], tables.units_per_meter)
    if known or holds(tables.bodies, tables.shapes, tables.cores, i, j, x, y, vx * seconds, vy * seconds, slop):
        return t
    return -1.0
