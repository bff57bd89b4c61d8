"""The separating-axis test decides pairs: whether, when and how their shapes touch within the step."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import prefetch_head
from sandbox.engine.broad_phase.margins import DEEPLY, allowed_depth
from sandbox.engine.broad_phase.pairs import comes_before
from sandbox.engine.broad_phase.proxies import FIXED, SLANTING
from sandbox.engine.contact_solver.closing_speed import SLOW, stops_by_several
from sandbox.engine.contact_solver.law import Anchors, pair_velocity, relative_velocity
from sandbox.engine.narrow_phase.internal_edges import PlacedPair, fix_internal_edge
from sandbox.engine.narrow_phase.one_way import holds, leads_on
from sandbox.engine.narrow_phase.outline import EdgeTables
from sandbox.engine.narrow_phase.sleeping_contacts import first_not_before
from sandbox.engine.narrow_phase.speculative import closing_distance, speculative_impact
from sandbox.engine.records.ccd import NEW, OVERLAPS
from sandbox.engine.records.colliders import Colliders
from sandbox.engine.records.decisions import DEEP, MAY_IMPACT, Decisions
from sandbox.engine.records.state import StateTables
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""
TOUCHING = 1e-6
"""Bodies put onto each other may be so far apart, by rounding (m)."""
_SHALLOW = -1e-3
"""Separation (m) that spares the question how large the bodies are."""


class Approach(NamedTuple):
    """Velocity (m/s) of b against a, the time (s) at which the pair is looked at, the length of the step (s), and how
    far from touching it may be then (m)."""

    vx: float
    vy: float
    t: float
    seconds: float
    margin: float


@kernel
def decide_pairs(
    state: StateTables,
    colliders: Colliders,
    pairs: Records,
    old: Records,
    decisions: Decisions,
    worker: int,
    first: int,
    end: int,
) -> None:
    """Decide the pairs first..end-1 of a batch: fill their rows of `decisions`, manifolds where something touches.

    Pairs and `old`, the contacts of the step before, are both sorted by (shape_a, shape_b): one walk through both
    matches them.
    """
    bodies = state.bodies
    shapes = state.shapes
    proxies = colliders.proxies
    cores = colliders.cores
    old_count = state.counters[0].contact_count
    setting = state.settings[0]
    # Without speculative contacts, a pair is looked at where it is now and nowhere else.
    seconds = setting.step_seconds if setting.speculative == 1 else 0.0
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)
    fall = 0.5 * gravity * seconds * seconds
    unit = setting.units_per_meter
    touching = TOUCHING * unit
    bias = FACE_BIAS * unit
    k = 0
    for n in range(first, end):
        i = pairs[n].shape_a
        j = pairs[n].shape_b
        if k < old_count and comes_before(old[k], i, j):
            k = _first_from(old, k + 1, old_count, i, j)
        made = decisions.made[n]
        manifold: Any = decisions.manifolds[n:]
        made.row = made.old = -1
        made.bits = 0
        a = proxies[i]
        b = proxies[j]
        if (a.traits | b.traits) & SLANTING and _lie_apart(colliders, i, j, fall + touching, seconds):
            continue
        margin = 2.0 * (a.margin if a.margin < b.margin else b.margin)
        t = 0.0
        vx = b.velocity_x - a.velocity_x
        vy = b.velocity_y - a.velocity_y
        distance = closing_distance(a, b, vx, vy, seconds)
        if distance > margin:
            t, vx, vy, margin = speculative_impact(bodies, shapes, proxies, cores, i, j, margin, fall, seconds)
        if t < 0.0 or not _collide(proxies, cores, i, j, vx * t, vy * t, margin, bias, manifold):
            continue
        known = k < old_count and old[k].shape_a == i and old[k].shape_b == j
        held = (a.traits ^ b.traits) & FIXED
        if (a.traits | b.traits) & (SEAMED | ONE_WAY):
            tables = EdgeTables(bodies, shapes, cores, state.seams, unit)
            overlap = -manifold[0].separation if t == 0.0 else 0.0
            # It needs two rows, and the next manifold may be another worker's.
            scratch: Any = decisions.scratch[2 * worker :]
            scratch[0] = manifold[0]
            t = _examine(tables, proxies, i, j, known, Approach(vx, vy, t, seconds, margin), scratch)
            manifold[0] = scratch[0]
            if t < 0.0:  # another part may push it out, or none
                made.bits = DEEP if held and _is_deep(shapes, i, j, overlap, unit) else 0
                continue
        m = manifold[0]
        bits = NEW if not known and t == 0.0 and m.separation <= touching else 0
        bits |= OVERLAPS if _overlaps_deeply(bodies, a.body, b.body, m.separation, _SHALLOW * unit) else 0
        bits |= DEEP if held and _is_deep(shapes, i, j, -m.separation, unit) else 0
        bounces = a.restitution > 0.0 or b.restitution > 0.0
        resistance = a.rolling_resistance if a.rolling_resistance > b.rolling_resistance else b.rolling_resistance
        several = stops_by_several(m.point_count, resistance)
        slow = SLOW * unit
        meets = several and distance > slow * seconds and _closes_in(bodies, a, b, m, vx * t, vy * t, slow)
        made.bits = bits | (MAY_IMPACT if bounces or meets else 0)
        made.row = 0
        made.old = k if known else -1
        if known:
            prefetch_head(old, k)  # its impulses are asked for when the contact is written
        made.shift_x = vx * t
        made.shift_y = vy * t


@inlined_kernel
def _closes_in(
    bodies: Records, a: Records, b: Records, m: Records, shift_x: float, shift_y: float, slow: float
) -> bool:
    """Whether a point closes in faster than `slow` (m/s) now; the manifold is of when b has moved by the shift (m)
    against a."""
    dx = b.center_x - a.center_x + shift_x
    dy = b.center_y - a.center_y + shift_y
    v = pair_velocity(bodies[a.body], bodies[b.body])
    for x, y, count in ((m.x1, m.y1, 1), (m.x2, m.y2, 2)):
        vx, vy = relative_velocity(v, Anchors(x, y, x - dx, y - dy))
        if count <= m.point_count and vx * m.normal_x + vy * m.normal_y < -slow:
            return True
    return False


@inlined_kernel
def _lie_apart(colliders: Colliders, i: int, j: int, slack: float, seconds: float) -> bool:
    """Whether a shape that lies aslant has the other one's box beyond one of its faces: nothing of the pair touches.

    Boxes cover margins and ways; `slack` is what else pairs may be apart (m).
    """
    aslant = colliders.proxies[i]
    k = j
    if aslant.traits & SLANTING == 0:
        aslant = colliders.proxies[j]
        k = i
    box = colliders.boxes[k]
    x = 0.5 * (box.lower_x + box.upper_x) - aslant.center_x
    y = 0.5 * (box.lower_y + box.upper_y) - aslant.center_y
    half_x = 0.5 * (box.upper_x - box.lower_x)
    half_y = 0.5 * (box.upper_y - box.lower_y)
    reach = aslant.radius + aslant.margin + slack + seconds * colliders.proxies[k].swing
    apart = False
    for n in range(aslant.vertex_start, aslant.vertex_start + aslant.vertex_count):
        face = colliders.cores[n]
        gap = face.normal_x * (x - face.x) + face.normal_y * (y - face.y)
        apart = apart or gap - abs(face.normal_x) * half_x - abs(face.normal_y) * half_y > reach
    return apart


@kernel
def _first_from(old: Records, first: int, end: int, shape_a: int, shape_b: int) -> int:
    """First row of `old[first:end]` that does not come before a pair, or `end`: in strides that double, as most are
    near, then by bisection."""
    stride = 1
    while first + stride < end and comes_before(old[first + stride - 1], shape_a, shape_b):
        first += stride
        stride *= 2
    last = first + stride
    return first_not_before(old, first, last if last < end else end, shape_a, shape_b)


@inlined_kernel
def _collide(
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


@inlined_kernel
def _overlaps_deeply(bodies: Records, a: int, b: int, separation: float, shallow: float) -> bool:
    if separation > shallow:
        return False
    smaller = bodies[a].extent if bodies[a].extent < bodies[b].extent else bodies[b].extent
    return bool(separation < -DEEPLY * smaller)


@inlined_kernel
def _is_deep(shapes: Records, i: int, j: int, overlap: float, unit: float) -> bool:
    """Whether a pair overlaps by more than a little."""
    return bool(overlap > 0.0 and overlap > allowed_depth(shapes[i], shapes[j], unit))


@kernel
def _examine(
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
        if not _collide(proxies, tables.cores, i, j, vx * t, vy * t, approach.margin, bias, manifold):
            return -1.0
    if traits & ONE_WAY == 0:
        return t
    if not leads_on(tables.bodies, tables.shapes, i, j, manifold[0].normal_x, manifold[0].normal_y):
        return -1.0
    slop = allowed_depth(tables.shapes[i], tables.shapes[j], tables.units_per_meter)
    if known or holds(tables.bodies, tables.shapes, tables.cores, i, j, x, y, vx * seconds, vy * seconds, slop):
        return t
    return -1.0
