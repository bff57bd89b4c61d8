"""How well a scene goes, measured by the same code whichever engine stepped it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.reference.brute_force import not_joined, overlapping_pairs, that_matter
from sandbox.reference.decide import decide
from sandbox.reference.poses import Poses
from sandbox.reference.run import Pose
from sandbox.tables import Floats, Records
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State

Rectangle = tuple[float, float, float, float]


@dataclass(frozen=True)
class Quality:
    """`deepest` (m) is the deepest overlap of two shapes that collide and whose bodies no joint holds, `overlapping`
    how many such pairs overlap, `kinetic` (J) the energy of motion, and `escaped` how many bodies lie outside of where
    the scene expects them, None if it says nothing. `lost` are bodies with numbers that are none.
    """

    deepest: float
    overlapping: int
    kinetic: float
    escaped: int | None
    lost: int


class Judge:
    """Judges runs of one scene: masses, shapes and joints are those of `state`, of which nothing is changed.

    `inside` is where all that moves should be (left, bottom, right, top), m; None if nobody knows.
    """

    def __init__(self, state: State, inside: Rectangle | None) -> None:
        self._state = state
        self._bonds = assemble(state.joints, state.bodies, PartLayouts(), len(state.bodies))[0].bonds
        self._moving = np.flatnonzero(self._state.bodies.type == DYNAMIC)
        self._inside = inside

    def judge(self, poses: Sequence[Pose]) -> Quality:
        """What is to be said of a run in which the bodies of `state` lie at `poses`, row by row."""
        numbers: Floats = np.array(poses, dtype=np.float64).reshape(len(poses), len(Pose._fields))
        sound = np.asarray(np.isfinite(numbers).all(axis=1))
        numbers[~sound] = (math.inf, math.inf, 1.0, 0.0, 0.0, 0.0, 0.0)
        rows = self._placed(numbers)
        deepest, overlapping = self._overlaps(rows, sound)
        moving = rows[self._moving]
        square = moving["velocity_x"] ** 2 + moving["velocity_y"] ** 2
        kinetic = 0.5 * (moving["mass"] * square + moving["inertia"] * moving["angular_velocity"] ** 2)
        return Quality(deepest, overlapping, float(kinetic.sum()), self._escaped(numbers), int((~sound).sum()))

    def _placed(self, numbers: Floats) -> Records:
        rows = self._state.bodies.copy()
        x, y, cos, sin, rows.velocity_x, rows.velocity_y, rows.angular_velocity = numbers.T
        rows.rotation_cos, rows.rotation_sin = cos, sin
        rows.center_x = x + (cos * rows.local_center_x - sin * rows.local_center_y)
        rows.center_y = y + (sin * rows.local_center_x + cos * rows.local_center_y)
        rows.awake = 1  # sleep keeps a pair from being decided again, not from overlapping
        return rows

    def _overlaps(self, rows: Records, sound: NDArray[np.bool_]) -> tuple[float, int]:
        shapes = self._state.shapes
        poses = Poses.of(rows, shapes, self._state.vertices)
        pairs = that_matter(overlapping_pairs(poses.boxes), poses.bodies, shapes)
        pairs = not_joined(pairs, self._bonds, shapes)
        pairs = pairs[sound[np.asarray(shapes.body)[pairs]].all(axis=1)]
        depths = -decide(poses, pairs)[0]
        return max(0.0, float(depths.max(initial=0.0))), int((depths > 0.0).sum())

    def _escaped(self, numbers: Floats) -> int | None:
        if self._inside is None:
            return None
        left, low, right, high = self._inside
        x, y = numbers[self._moving, 0], numbers[self._moving, 1]
        return int(((x < left) | (x > right) | (y < low) | (y > high)).sum())
