"""What a pass over factorised parts is for, and where it keeps the impulses that it finds."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.engine.joints.direct import places as at

MOVE = 0
"""Before the move: the joints are to be kept after it."""
RELAX = 1
"""After the move: velocities are to keep them, too."""
BLOW = 2
"""In an impact: velocities are to keep them, and only what is rigid can answer in no time."""


@inlined_kernel
def impulse_of(purpose: int) -> int:
    """The field of a row's impulse in such a pass."""
    if purpose == MOVE:
        return at.IMPULSE
    return at.RELAXING if purpose == RELAX else at.BLOW
