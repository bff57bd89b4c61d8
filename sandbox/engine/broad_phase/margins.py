"""How far pairs look ahead, and how deep they may get into each other before that is caught."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Records

MARGIN = 0.02
"""Largest speculative margin of contacts at low speed, in metres; four times the usual slop of 5 mm."""
MARGIN_SHARE = 0.1
"""The same for small bodies, as a share of their extent."""

DEEPLY = 0.1
"""Share of the smaller body's extent past which an overlap is deep."""

SLOW_SHARE = 1.0 / 3.0
"""What has less than this share of another's speed may stop it: what both are about as fast goes on, if otherwise."""

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


@inlined_kernel
def meet_hard(a: Records, b: Records, seconds: float) -> bool:
    """Whether the bodies of two proxies come nearer by so much in a step that, if one of them is stopped by the other,
    what follows it closely would overlap it deeply."""
    x = b.center_x - a.center_x
    y = b.center_y - a.center_y
    nearer = -seconds * (x * (b.velocity_x - a.velocity_x) + y * (b.velocity_y - a.velocity_y))
    deep = DEEPLY * (a.extent if a.extent < b.extent else b.extent)
    return bool((nearer > 0.0) & (nearer * nearer > deep * deep * (x * x + y * y)))


@kernel
def allowed_depth(a: Records, b: Records) -> float:
    """How deep two shapes may get into each other unforeseen, in metres."""
    share = DEEP_SHARE * (a.thin + b.thin)
    share = share if share < DEEP else DEEP
    return float(share if share > _LEAST_DEEP else _LEAST_DEEP)
