"""What a decision notes of a pair that has a contact: is it new, does it overlap deeply, may it have an impact."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.engine.broad_phase.margins import DEEPLY, allowed_depth
from sandbox.engine.broad_phase.proxies import FIXED
from sandbox.engine.contact_solver.closing_speed import SLOW, stops_by_several
from sandbox.engine.contact_solver.law import Anchors, pair_velocity, relative_velocity
from sandbox.engine.narrow_phase.examine_pair import TOUCHING
from sandbox.engine.records.ccd import NEW, OVERLAPS
from sandbox.engine.records.decisions import DEEP, MAY_IMPACT
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records

_SHALLOW = -1e-3
"""Separation (m) that spares the question how large the bodies are."""


@inlined_kernel
def decision_bits(
    state: StateTables,
    proxies: Records,
    i: int,
    j: int,
    m: Records,
    fresh: bool,
    travels: bool,
    shift_x: float,
    shift_y: float,
    unit: float,
) -> int:
    """The bits of a pair whose manifold is of when b has moved by the shift (m) against a.

    `fresh` if it had no contact and is looked at where it is now; `travels` if it closes in by more than what is slow.
    """
    bodies = state.bodies
    a = proxies[i]
    b = proxies[j]
    held = (a.traits ^ b.traits) & FIXED
    bits = NEW if fresh and m.separation <= TOUCHING * unit else 0
    bits |= OVERLAPS if _overlaps_deeply(bodies, a.body, b.body, m.separation, _SHALLOW * unit) else 0
    bits |= DEEP if held and is_deep(state.shapes, i, j, -m.separation, unit) else 0
    bounces = a.restitution > 0.0 or b.restitution > 0.0
    resistance = a.rolling_resistance if a.rolling_resistance > b.rolling_resistance else b.rolling_resistance
    several = stops_by_several(m.point_count, resistance)
    meets = several and travels and _closes_in(bodies, a, b, m, shift_x, shift_y, SLOW * unit)
    return bits | (MAY_IMPACT if bounces or meets else 0)


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
def _overlaps_deeply(bodies: Records, a: int, b: int, separation: float, shallow: float) -> bool:
    if separation > shallow:
        return False
    smaller = bodies[a].extent if bodies[a].extent < bodies[b].extent else bodies[b].extent
    return bool(separation < -DEEPLY * smaller)


@inlined_kernel
def is_deep(shapes: Records, i: int, j: int, overlap: float, unit: float) -> bool:
    """Whether a pair overlaps by more than a little."""
    return bool(overlap > 0.0 and overlap > allowed_depth(shapes[i], shapes[j], unit))
