"""The pairs of bodies that the grid proposes at this moment, and which of them the narrow phase makes a contact of."""

from __future__ import annotations

import copy
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sandbox.errors import SandboxError
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.memory import proposed_pairs

MOST_COPIED = 3000
"""Bodies of a world up to which the step to come is asked; above that, the step that was."""

Bodies = np.ndarray[Any, np.dtype[np.int64]]


@dataclass(frozen=True)
class Candidates:
    """`bodies` (n, 2) are rows of bodies, each pair once; `touching` (n,) tells which have a contact."""

    bodies: Bodies
    touching: np.ndarray[Any, np.dtype[np.bool_]]

    def of(self, row: int | None) -> Candidates:
        """Only those of one body; None: all."""
        if row is None:
            return self
        mine = (self.bodies == row).any(axis=1)
        return Candidates(self.bodies[mine], self.touching[mine])

    def only(self, touching: bool) -> Candidates:
        """Those that touch, or those that do not."""
        wanted = self.touching == touching
        return Candidates(self.bodies[wanted], self.touching[wanted])


def candidates_of(look: Look, running: bool) -> Candidates:
    """The pairs of a world: where time stands, those that the next step will be proposed; else those of the last."""
    world = look.world
    if not running and len(world.names) <= MOST_COPIED:
        world = copy.copy(world)
        try:
            world.step()
        except SandboxError:
            world = look.world
    owner = np.asarray(world.state.shapes.body, dtype=np.int64)
    bodies = np.sort(owner[proposed_pairs(replace(look, world=world))], axis=1)
    contacts: Any = world.contacts
    met = np.sort(np.stack([contacts.body_a, contacts.body_b], axis=1).astype(np.int64), axis=1)
    both = np.unique(np.concatenate([bodies.reshape(-1, 2), met]), axis=0)
    width = len(world.names) + 1
    touching = np.isin(both[:, 0] * width + both[:, 1], met[:, 0] * width + met[:, 1])
    return Candidates(both, touching)
