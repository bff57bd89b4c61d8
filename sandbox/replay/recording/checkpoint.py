"""A few figures of a state that a person can judge, taken now and then."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sandbox.engine.world import World
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State

EVERY = 60
"""Steps between two checkpoints; the last step has one too."""


@dataclass(frozen=True)
class Checkpoint:
    """After `step` steps: kinetic and potential `energy` (J, zero at rest at the world's origin), touching `contacts`,
    dynamic bodies `awake`, and the `deepest` overlap of two shapes (m). Rounded to six digits.
    """

    step: int
    energy: float
    contacts: int
    awake: int
    deepest: float


def checkpoint(world: World) -> Checkpoint:
    """The figures of a world as it is now."""
    contacts = world.contacts
    return Checkpoint(
        world.step_count,
        _rounded(_energy(world.state)),
        int(np.count_nonzero(contacts.touching)),
        world.awake_count,
        _rounded(_deepest(contacts)),
    )


def _energy(state: State) -> float:
    rows = state.bodies[state.bodies.type == DYNAMIC]
    settings = state.settings[0]
    square = rows["velocity_x"] ** 2 + rows["velocity_y"] ** 2
    kinetic = 0.5 * (rows["mass"] * square + rows["inertia"] * rows["angular_velocity"] ** 2)
    lift = settings.gravity_x * rows["center_x"] + settings.gravity_y * rows["center_y"]
    # An exact sum: NumPy's own order of adding differs between processors.
    return math.fsum(kinetic - rows["mass"] * rows["gravity_scale"] * lift)


def _deepest(contacts: np.recarray) -> float:
    one = contacts.separation1
    two = np.where(contacts.point_count > 1, contacts.separation2, 0.0)
    return max(0.0, -float(min(one.min(initial=0.0), two.min(initial=0.0))))


def _rounded(value: float) -> float:
    return float(f"{value:.6g}")
