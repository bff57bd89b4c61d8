"""How large the numbers of a state may be: far beyond what a world comes to, and such that the grid can hold them."""

from __future__ import annotations

from sandbox.tables import Values

PLACE = Values(-2e9, 2e9)
"""Metres from the origin, or radians turned: twice what a body may have before it counts as lost."""
SPEED = Values(-1e30, 1e30)
"""m/s or rad/s. What is broken is frozen only when the next step begins."""
LENGTH = Values(-1e8, 1e8)
"""Metres within a body: ten times what a scene may hold."""
SHARE = Values(-1.001, 1.001)
"""Part of a unit vector."""
