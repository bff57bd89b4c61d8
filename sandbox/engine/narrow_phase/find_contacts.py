"""Stage: the separating-axis test decides each proposed pair and keeps what is known of it from the last step."""

from __future__ import annotations

from sandbox._jit import ZERO, inlined_kernel, kernel
from sandbox.engine.active.active_set import list_contact
from sandbox.engine.broad_phase.proxies import FIXED
from sandbox.engine.contact_solver.prepare import HARD
from sandbox.engine.continuous_collision.relative_sweep import allowed_depth
from sandbox.engine.narrow_phase.contact import fill_contact, match_contact
from sandbox.engine.narrow_phase.internal_edges import mend_contact
from sandbox.engine.narrow_phase.one_way import comes_from_front, leads_on
from sandbox.engine.narrow_phase.sleeping_contacts import comes_before, keep_before
from sandbox.engine.narrow_phase.speculative import closing_way, look_ahead
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Integers, Records
from sandbox.world.records import ONE_WAY, SEAMED

FACE_BIAS = 1e-4
"""A face of b has to beat the best face of a by this many metres, so that resting contacts keep their face."""
LAST = 1 << 60
"""No shape has such a row: everything comes before it."""
TOUCHING = 1e-6
"""Bodies put onto each other may be so far apart, by rounding (m)."""


@kernel
def find_contacts(
    bodies: Records,
    movers: Integers,
    stirs: Integers,
    holds: Records,
    shapes: Records,
    proxies: Records,
    turned: Records,
    seams: Records,
    pairs: Records,
    pair_count: int,
    fall: float,
    seconds: float,
    manifold: Records,
    old: Records,
    old_count: int,
    contacts: Records,
    live: Integers,
    strikers: Integers,
    keeper: Records,
    runs: Records,
) -> int:
    """Write a contact for every pair that touches or will touch within `seconds`; return how many.

    `live` and `strikers` are filled as by `list_live`; `stirs` is of `take_census`, `keeper` and `runs` of `keeping`.
    `fall` (m) is what gravity adds to a way within that time. Pairs and old contacts are both sorted by (shape_a,
    shape_b): one walk through both matches them, and impulses of points with the same feature id carry over (warm
    starting). Contacts among sleeping bodies, which the grid does not propose, are kept as they are.
    """
    for i in movers:
        holds[i].deep = 0
        holds[i].fresh = 0
    live[0] = 0
    strikers[0] = 0
    count = ZERO
    k = 0
    for n in range(pair_count):
        i = pairs[n].shape_a
        j = pairs[n].shape_b
        if k < old_count and comes_before(old[k], i, j):
            k, count = keep_before(
                bodies, stirs, old, k, old_count, i, j, contacts, count, live, strikers, keeper, runs
            )  # fmt: skip
        a = proxies[i]
        b = proxies[j]
        margin = 2.0 * (a.margin if a.margin < b.margin else b.margin)
        t = 0.0
        vx = b.velocity_x - a.velocity_x
        vy = b.velocity_y - a.velocity_y
        way = closing_way(a, b, vx, vy, seconds)
        if way > margin:
            t, vx, vy, margin = look_ahead(bodies, shapes, proxies, turned, i, j, margin, fall, seconds, manifold)
        if t < 0.0 or not _collide(proxies, turned, i, j, vx * t, vy * t, margin, manifold):
            continue
        known = k < old_count and old[k].shape_a == i and old[k].shape_b == j
        if (a.traits | b.traits) & (SEAMED | ONE_WAY):
            t = _examine(bodies, shapes, proxies, turned, seams, i, j, known, vx, vy, t, seconds, margin, manifold)
            if t < 0.0:
                continue
        contact = contacts[count]
        fill_contact(proxies, i, j, vx * t, vy * t, manifold[0], contact)
        list_contact(contact, count, way > HARD * seconds, live, strikers)
        if known:
            match_contact(old[k], contact)
            k += 1
        elif t == 0.0 and manifold[0].separation <= TOUCHING:
            holds[a.body].fresh = 1
            holds[b.body].fresh = 1
        if (a.traits ^ b.traits) & FIXED and manifold[0].separation < 0.0:
            _mark_deep(holds, shapes, i, j, -manifold[0].separation)
        count += 1
    k, count = keep_before(
        bodies, stirs, old, k, old_count, LAST, 0, contacts, count, live, strikers, keeper, runs
    )  # fmt: skip
    return count


@inlined_kernel
def _collide(
    proxies: Records, turned: Records, i: int, j: int, shift_x: float, shift_y: float, margin: float, manifold: Records
) -> bool:
    """Manifold of a pair of shapes, with b moved against a by (shift_x, shift_y) metres."""
    a = proxies[i]
    b = proxies[j]
    return (
        collide_cores(
            turned,
            a.vertex_start,
            a.vertex_count,
            a.radius,
            b.vertex_start,
            b.vertex_count,
            b.radius,
            b.center_x - a.center_x + shift_x,
            b.center_y - a.center_y + shift_y,
            margin,
            FACE_BIAS,
            manifold,
        )
        > 0
    )


@kernel
def _mark_deep(holds: Records, shapes: Records, i: int, j: int, overlap: float) -> None:
    """Mark the bodies of a pair that overlap by more than a little (m)."""
    if overlap > allowed_depth(shapes[i], shapes[j]):
        holds[shapes[i].body].deep = 1
        holds[shapes[j].body].deep = 1


@kernel
def _examine(
    bodies: Records,
    shapes: Records,
    proxies: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    known: bool,
    vx: float,
    vy: float,
    t: float,
    seconds: float,
    margin: float,
    manifold: Records,
) -> float:
    """The time of which the manifold of a pair with seams or a one-way shape is, put right; -1 if it does not hold.

    What is fast may first touch a part across a seam: it is looked at where the step will bring it. `known` if the
    pair has a contact already.
    """
    x = proxies[j].center_x - proxies[i].center_x
    y = proxies[j].center_y - proxies[i].center_y
    traits = shapes[i].traits | shapes[j].traits
    now = t == 0.0
    while traits & SEAMED and not mend_contact(
        bodies, shapes, turned, seams, i, j, x + vx * t, y + vy * t, vx * seconds, vy * seconds, margin, FACE_BIAS,
        now, manifold,
    ):  # fmt: skip
        if now or t == seconds:
            return -1.0
        t = seconds
        if not _collide(proxies, turned, i, j, vx * t, vy * t, margin, manifold):
            return -1.0
    if traits & ONE_WAY == 0:
        return t
    if not leads_on(bodies, shapes, i, j, manifold[0].normal_x, manifold[0].normal_y):
        return -1.0
    slop = allowed_depth(shapes[i], shapes[j])
    return t if known or comes_from_front(bodies, shapes, turned, i, j, x, y, slop) else -1.0
