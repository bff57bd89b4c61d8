"""Stage: the separating-axis test decides each proposed pair and keeps what is known of it from the last step."""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import list_contact
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.broad_phase.proxies import FIXED
from sandbox.engine.contact_solver.closing_speed import HARD
from sandbox.engine.narrow_phase.contact import fill_contact, match_contact
from sandbox.engine.narrow_phase.internal_edges import PlacedPair, fix_internal_edge
from sandbox.engine.narrow_phase.one_way import holds, leads_on
from sandbox.engine.narrow_phase.outline import EdgeTables
from sandbox.engine.narrow_phase.sleeping_contacts import comes_before, keep_sleeping_before
from sandbox.engine.narrow_phase.speculative import closing_distance, speculative_impact
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.ccd import NEW, OVERLAPS
from sandbox.engine.records.colliders import Colliders
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""
LAST = 1 << 60
"""No shape has such a row: everything comes before it."""
TOUCHING = 1e-6
"""Bodies put onto each other may be so far apart, by rounding (m)."""
DEEP = 0.1
"""Share of the smaller body's extent past which an overlap is deep."""
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
def find_contacts(
    state: StateTables,
    active: ActiveSet,
    colliders: Colliders,
    pairs: Records,
    contacts: Contacts,
    ccd_bodies: Records,
) -> int:
    """Write a contact for every pair that touches or will touch within the step; return how many.

    `contacts.active` and `impact_candidates` are filled as by `list_active_contacts`. Pairs and old contacts are both
    sorted by (shape_a, shape_b): one walk through both matches them, and impulses of points with the same feature id
    carry over (warm starting). Contacts among sleeping bodies, which the grid does not propose, are kept as they are.
    """
    bodies = state.bodies
    shapes = state.shapes
    proxies = colliders.proxies
    cores = colliders.cores
    manifold = contacts.manifold
    old = contacts.before
    old_count = state.counters[0].contact_count
    setting = state.settings[0]
    # Without speculative contacts, a pair is looked at where it is now and nowhere else.
    seconds = setting.step_seconds if setting.speculative == 1 else 0.0
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)
    fall = 0.5 * gravity * seconds * seconds
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        ccd_bodies[i].deep = 0
        ccd_bodies[i].unsettled = 0
    contacts.active[0] = 0
    contacts.impact_candidates[0] = 0
    count = 0
    k = 0
    for n in range(state.counters[0].pair_count):
        i = pairs[n].shape_a
        j = pairs[n].shape_b
        if k < old_count and comes_before(old[k], i, j):
            k, count = keep_sleeping_before(bodies, active.activity, contacts, k, old_count, i, j, count)
        a = proxies[i]
        b = proxies[j]
        margin = 2.0 * (a.margin if a.margin < b.margin else b.margin)
        t = 0.0
        vx = b.velocity_x - a.velocity_x
        vy = b.velocity_y - a.velocity_y
        distance = closing_distance(a, b, vx, vy, seconds)
        if distance > margin:
            t, vx, vy, margin = speculative_impact(bodies, shapes, proxies, cores, i, j, margin, fall, seconds)
        if t < 0.0 or not _collide(proxies, cores, i, j, vx * t, vy * t, margin, manifold):
            continue
        known = k < old_count and old[k].shape_a == i and old[k].shape_b == j
        if (a.traits | b.traits) & (SEAMED | ONE_WAY):
            tables = EdgeTables(bodies, shapes, cores, state.seams)
            overlap = -manifold[0].separation if t == 0.0 else 0.0
            t = _examine(tables, proxies, i, j, known, Approach(vx, vy, t, seconds, margin), manifold)
            if t < 0.0:
                if (a.traits ^ b.traits) & FIXED and overlap > 0.0:  # another part may push it out, or none
                    _mark_deep(ccd_bodies, shapes, i, j, overlap)
                continue
        contact = contacts.now[count]
        fill_contact(proxies, i, j, vx * t, vy * t, manifold[0], contact)
        list_contact(contact, count, distance > HARD * seconds, contacts.active, contacts.impact_candidates)
        if known:
            match_contact(old[k], contact)
            k += 1
        bits = NEW if not known and t == 0.0 and manifold[0].separation <= TOUCHING else 0
        bits |= OVERLAPS if _overlaps_deeply(bodies, a.body, b.body, manifold[0].separation) else 0
        ccd_bodies[a.body].unsettled |= bits
        ccd_bodies[b.body].unsettled |= bits
        if (a.traits ^ b.traits) & FIXED and manifold[0].separation < 0.0:
            _mark_deep(ccd_bodies, shapes, i, j, -manifold[0].separation)
        count += 1
    k, count = keep_sleeping_before(bodies, active.activity, contacts, k, old_count, LAST, 0, count)
    return count


@inlined_kernel
def _collide(
    proxies: Records, cores: Records, i: int, j: int, shift_x: float, shift_y: float, margin: float, manifold: Records
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
            FACE_BIAS,
            manifold,
        )
        > 0
    )


@inlined_kernel
def _overlaps_deeply(bodies: Records, a: int, b: int, separation: float) -> bool:
    if separation > _SHALLOW:
        return False
    smaller = bodies[a].extent if bodies[a].extent < bodies[b].extent else bodies[b].extent
    return bool(separation < -DEEP * smaller)


@kernel
def _mark_deep(ccd_bodies: Records, shapes: Records, i: int, j: int, overlap: float) -> None:
    """Mark the bodies of a pair that overlap by more than a little (m)."""
    if overlap > allowed_depth(shapes[i], shapes[j]):
        ccd_bodies[shapes[i].body].deep = 1
        ccd_bodies[shapes[j].body].deep = 1


@kernel
def _examine(
    tables: EdgeTables, proxies: Records, i: int, j: int, known: bool, approach: Approach, manifold: Records
) -> float:
    """The time of which the manifold of a pair with seams or a one-way shape is, put right; -1 if it does not hold.

    What is fast may first touch a part across a seam: it is looked at where the step will bring it. `known` if the
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
    while traits & SEAMED and not fix_internal_edge(
        tables, PlacedPair(i, j, x + vx * t, y + vy * t), vx * seconds, vy * seconds, approach.margin, FACE_BIAS, now,
        manifold,
    ):  # fmt: skip
        if now or t == seconds:
            return -1.0
        t = seconds
        if not _collide(proxies, tables.cores, i, j, vx * t, vy * t, approach.margin, manifold):
            return -1.0
    if traits & ONE_WAY == 0:
        return t
    if not leads_on(tables.bodies, tables.shapes, i, j, manifold[0].normal_x, manifold[0].normal_y):
        return -1.0
    slop = allowed_depth(tables.shapes[i], tables.shapes[j])
    if known or holds(tables.bodies, tables.shapes, tables.cores, i, j, x, y, vx * seconds, vy * seconds, slop):
        return t
    return -1.0
