"""How far to go with impulses that were found as if nothing but their own bodies answered."""

from __future__ import annotations

from sandbox._jit import inlined_kernel


@inlined_kernel
def until(share: float, added: float, room: float) -> float:
    """As much of a share as adds no more than there is room for, at least 1: so much does fit."""
    if share > 1.0 and added > 0.0 and share * added > room:
        share = room / added
        share = share if share > 1.0 else 1.0
    return share


@inlined_kernel
def best_share(asked: float, changed: float) -> float:
    """The share of impulses p that does most of what is asked where they change speeds by d that were to change by c:
    with `asked` p c and `changed` p d, the quadratic p d / 2 - p c is the least along p there."""
    return asked / changed if asked > 0.0 and changed > 0.0 else 0.0
