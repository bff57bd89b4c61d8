"""Energy, penetration and heights of a state, measured by the same code whichever engine simulated it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.reference.brute_force import overlapping_pairs, that_matter
from sandbox.reference.decide import decide
from sandbox.reference.poses import Poses
from sandbox.tables import Floats, Records
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


@dataclass(frozen=True)
class Measures:
    """`energy` (J) is kinetic and potential, zero for rest at the world's origin; `penetration` (m) the deepest
    overlap of all pairs that collide; `height` (m) that of the common centre of mass; `top` (m) of the highest body.
    """

    energy: float
    penetration: float
    height: float
    top: float


class Measurer:
    """Measures dynamic bodies of a scene: masses, shapes and gravity are those of `state` when the measurer is made."""

    def __init__(self, state: State) -> None:
        self._shapes, self._vertices = state.shapes, state.vertices
        self._moving = np.flatnonzero(state.bodies.type == DYNAMIC)
        start = state.bodies[self._moving]
        self._mass: Floats = start["mass"].copy()
        self._inertia: Floats = start["inertia"].copy()
        self._weight: Floats = start["mass"] * start["gravity_scale"]
        settings = state.settings[0]
        self._gravity = np.array([settings.gravity_x, settings.gravity_y])

    def measure(self, bodies: Records) -> Measures:
        """Everything at the poses and velocities of `bodies`; a scene without dynamic bodies measures 0."""
        rows = bodies[self._moving]
        if not len(rows):
            return Measures(0.0, 0.0, 0.0, 0.0)
        square = rows["velocity_x"] ** 2 + rows["velocity_y"] ** 2
        kinetic = 0.5 * (self._mass * square + self._inertia * rows["angular_velocity"] ** 2)
        lift = self._gravity[0] * rows["center_x"] + self._gravity[1] * rows["center_y"]
        height = (self._mass * rows["center_y"]).sum() / self._mass.sum()
        energy = (kinetic - self._weight * lift).sum()
        return Measures(float(energy), self._penetration(bodies), float(height), float(rows["center_y"].max()))

    def _penetration(self, bodies: Records) -> float:
        poses = Poses.of(bodies, self._shapes, self._vertices)
        poses.bodies.awake = 1  # sleep keeps a pair from being decided again, not from overlapping
        pairs = that_matter(overlapping_pairs(poses.boxes), poses.bodies, poses.shapes)
        return max(0.0, -float(decide(poses, pairs)[0].min(initial=0.0)))
