"""The state of a world: a handful of record arrays and the names of its bodies."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.tables import Records


@dataclass
class State:
    """Everything that a step reads and writes, and nothing else. Scratch memory lives in the engine.

    `contacts` has spare rows; the first `counters[0].contact_count` are in use. `settings` and `counters` have one
    row each. `names[i]` is the scene id of body `i`, `joint_names[i]` that of joint `i`.
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
    names: tuple[str, ...]
    joint_names: tuple[str, ...] = ()

    @property
    def arrays(self) -> tuple[Records, ...]:
        """The record arrays in the order of `records.TABLES`."""
        return (
            self.bodies, self.shapes, self.vertices, self.outlines, self.seams, self.contacts, self.joints, self.drags,
            self.regions, self.edges, self.thrusters, self.settings, self.counters,
        )  # fmt: skip
