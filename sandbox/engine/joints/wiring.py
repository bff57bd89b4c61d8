"""What decides how joints hang together: while it stays the same, nothing has to be assembled anew."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers, Records, plain
from sandbox.world.joint_records import JOINT

_WHOLE = [k for k, field in enumerate(JOINT.fields) if field.kind == "i8"]


def wiring(joints: Records, bodies: Records) -> bytes:
    """All that `assemble` looks at: the whole numbers of joints, and which bodies joints can move."""
    if not len(joints):
        return b""
    own = plain(joints).view(np.int64).reshape(len(joints), -1)[:, _WHOLE]
    return own.tobytes() + movable(bodies).tobytes()


def movable(bodies: Records, rows: Integers | slice = slice(None)) -> NDArray[np.bool_]:
    """Which bodies of some rows joints can move: those with a mass, unless bad numbers froze them."""
    table = plain(bodies)
    flags: NDArray[np.bool_] = (table["mass"][rows] > 0.0) & (table["frozen_step"][rows] < 0)
    return flags
