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
def shape_margin(extent: float, unit: float) -> float:
    """Half of the speculative margin of a pair of slow bodies, given the body's extent, where a metre is so many units
    of length."""
    share = MARGIN_SHARE * extent
    most = MARGIN * unit
    return 0.5 * (share if share < most else most)


@inlined_kernel
def pair_margin(a: Records, b: Records, unit: float) -> float:
    """Speculative margin of a pair of slow bodies, where a metre is so many units of length."""
    margin_a = shape_margin(a.extent, unit)
    margin_b = shape_margin(b.extent, unit)
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
def allowed_depth(a: Records, b: Records, unit: float) -> float:
    """How deep two shapes may get into each other unforeseen, where a metre is so many units of length."""
    share = DEEP_SHARE * (a.thin + b.thin)
    most = DEEP * unit
    least = _LEAST_DEEP * unit
    share = share if share < most else most
    return float(share if share > least else least)
