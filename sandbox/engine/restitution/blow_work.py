"""The work of a blow, `power * x + slowing * x * x` (J) of the share x of its impulses that is given.

Restitution e gives back no more than its square of the work that stopping takes, so that no blow gains energy.

Source: W. J. Stronge, "Rigid body collisions with friction", Proceedings of the Royal Society A 431 (1990).
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel


@inlined_kernel
def share_within(share: float, power: float, slowing: float, most: float) -> float:
    """A share, or the one up to which no more work (J) than `most` is done."""
    work = share * (power + share * slowing)
    if work <= most or slowing <= 0.0:
        return share
    square = power * power + 4.0 * slowing * most
    found = 0.5 * (math.sqrt(square) - power) / slowing if square > 0.0 else 0.0
    found = found if found > 0.0 else 0.0
    return found if found < share else share
