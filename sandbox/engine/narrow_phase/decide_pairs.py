"""The separating-axis test decides pairs: whether, when and how their shapes touch within the step."""

from __future__ import annotations

import math
from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import prefetch_head
from sandbox.engine.broad_phase.pairs import comes_before
from sandbox.engine.broad_phase.proxies import FIXED, SLANTING
from sandbox.engine.contact_solver.closing_speed import SLOW
from sandbox.engine.narrow_phase.decision_bits import decision_bits, is_deep
from sandbox.engine.narrow_phase.examine_pair import FACE_BIAS, TOUCHING, Approach, collide_pair, examine_pair
from sandbox.engine.narrow_phase.outline import EdgeTables
from sandbox.engine.narrow_phase.sleeping_contacts import first_not_before
from sandbox.engine.narrow_phase.speculative import closing_distance, first_touch, speculative_impact
from sandbox.engine.records.colliders import Colliders
from sandbox.engine.records.decisions import DEEP, Decisions
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED


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
        slow = distance <= margin
        if not slow:
            t, vx, vy, margin = speculative_impact(bodies, shapes, proxies, cores, i, j, margin, fall, seconds)
        if t < 0.0 or not collide_pair(proxies, cores, i, j, vx * t, vy * t, margin, bias, manifold):
            continue
        if slow:
            t = first_touch(proxies, cores, i, j, vx, vy, manifold[0], margin, seconds)
            if t > 0.0 and not collide_pair(proxies, cores, i, j, vx * t, vy * t, margin, bias, manifold):
                continue
        known = k < old_count and old[k].shape_a == i and old[k].shape_b == j
        if (a.traits | b.traits) & (SEAMED | ONE_WAY):
            tables = EdgeTables(bodies, shapes, cores, state.seams, unit)
            overlap = -manifold[0].separation if t == 0.0 else 0.0
            # It needs two rows, and the next manifold may be another worker's.
            scratch: Any = decisions.scratch[2 * worker :]
            scratch[0] = manifold[0]
            t = examine_pair(tables, proxies, i, j, known, Approach(vx, vy, t, seconds, margin), scratch)
            manifold[0] = scratch[0]
            if t < 0.0:  # another part may push it out, or none
                held = (a.traits ^ b.traits) & FIXED
                made.bits = DEEP if held and is_deep(shapes, i, j, overlap, unit) else 0
                continue
        shift_x = vx * t
        shift_y = vy * t
        fresh = not known and t == 0.0
        travels = distance > SLOW * unit * seconds
        made.bits = decision_bits(state, proxies, i, j, manifold[0], fresh, travels, shift_x, shift_y, unit)
        made.row = 0
        made.old = k if known else -1
        if known:
            prefetch_head(old, k)  # its impulses are asked for when the contact is written
        made.shift_x = shift_x
        made.shift_y = shift_y


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
