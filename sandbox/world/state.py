"""The state of a world: a handful of record arrays and who is behind their rows."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.tables import Records
from sandbox.world.roster import Roster

ARRAYS = (
    "bodies", "shapes", "vertices", "outlines", "seams", "contacts", "joints", "drags", "regions", "edges", "thrusters",
    "settings", "counters",
)  # fmt: skip
"""The record arrays of a state in the order of `records.TABLES`."""


@dataclass
class State:
    """Everything that a step reads and writes, and nothing else. Scratch memory lives in the engine.

    `contacts` has spare rows; the first `counters[0].contact_count` are in use. `settings` and `counters` have one
    row each. `roster` says who is behind the rows, and `layout` counts how often they have moved, or centres of mass
    in their bodies: while it stays the same, row `i` is the same body, and its shapes lie where they did.
    """

    bodies: Records
    shapes: Records
    vertices: Records
    outlines: Records
    seams: Records
    contacts: Records
    joints: Records
    drags: Records
    regions: Records
    edges: Records
    thrusters: Records
    settings: Records
    counters: Records
    roster: Roster
    layout: int = 0

    @property
    def names(self) -> tuple[str, ...]:
        """The ids of the bodies, row by row."""
        return self.roster.bodies.names

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The ids of the joints, row by row."""
        return self.roster.joints.names

    @property
    def arrays(self) -> tuple[Records, ...]:
        """The record arrays in the order of `records.TABLES`."""
        return tuple(getattr(self, name) for name in ARRAYS)
