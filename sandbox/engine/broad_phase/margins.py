"""How far pairs look ahead, and how deep they may get into each other before that is caught."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Records

MARGIN = 0.02
"""Largest speculative margin of contacts at low speed, in metres; four times the usual slop of 5 mm."""
MARGIN_SHARE = 0.1
"""The same for small bodies, as a share of their extent."""

DEEP = 0.005
"""Overlap that is let pass, in metres: it is pushed out in time."""
DEEP_SHARE = 0.25
"""Past this share of the half widths of both, shapes are about to come out on the wrong side."""
_LEAST_DEEP = 1e-9


@kernel
def shape_margin(extent: float) -> float:
    """Half of the speculative margin of a pair of bodies at low speed, in metres, given the body's extent."""
    share = MARGIN_SHARE * extent
    return 0.5 * (share if share < MARGIN else MARGIN)


@inlined_kernel
def pair_margin(a: Records, b: Records) -> float:
    """Speculative margin of a pair of slow bodies, in metres."""
    margin_a = shape_margin(a.extent)
    margin_b = shape_margin(b.extent)
    return 2.0 * (margin_a if margin_a < margin_b else margin_b)


@kernel
def allowed_depth(a: Records, b: Records) -> float:
    """How deep two shapes may get into each other unforeseen, in metres."""
    share = DEEP_SHARE * (a.thin + b.thin)
    share = share if share < DEEP else DEEP
    return float(share if share > _LEAST_DEEP else _LEAST_DEEP)
