"""Whether the world of another scene can be stepped through the memory of a lane."""

from __future__ import annotations

import numpy as np

from sandbox.engine.joints.wiring import wiring
from sandbox.tables import plain
from sandbox.world.records import SURFACE
from sandbox.world.state import ARRAYS, State

_GEOMETRY = ("vertices", "outlines", "seams")


def are_alike(a: State, b: State) -> bool:
    """Whether two worlds have bodies of the same names, shapes and joints; how these lie, move and weigh may differ.

    Only then is what lies in scratch memory from the scene on, such as how thin a body is, true for both.
    """
    if a.names != b.names or a.joint_names != b.joint_names:
        return False
    if any(len(getattr(a, name)) != len(getattr(b, name)) for name in ARRAYS if name != "contacts"):
        return False
    geometry = [name for name in plain(a.shapes).dtype.names or () if name not in SURFACE]
    shapes = all(np.array_equal(plain(a.shapes)[name], plain(b.shapes)[name]) for name in geometry)
    outlines = all(np.array_equal(plain(getattr(a, name)), plain(getattr(b, name))) for name in _GEOMETRY)
    return shapes and outlines and wiring(a.joints, a.bodies) == wiring(b.joints, b.bodies)
