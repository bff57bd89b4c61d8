"""The cart and pole as a vector environment of Gymnasium, one world of a batch for each: an example to copy.

Needs `pip install gymnasium`. Masses, lengths, bounds and reward are those of Gymnasium's CartPole-v1, after Barto,
Sutton and Anderson, "Neuronlike adaptive elements that can solve difficult learning control problems" (1983); the
motion is this engine's. https://gymnasium.farama.org/api/vector/
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector.utils import batch_space

from sandbox.batch.batch import Batch
from sandbox.resources import find_scene
from sandbox.scene import load_scene
from sandbox.tables import Floats, Integers

FORCE = 10.0
"""N, to the left or to the right."""
FARTHEST, STEEPEST = 2.4, math.radians(12.0)
"""Where an episode ends: m from the middle, rad from upright."""
LONGEST = 500
"""Steps of an episode."""
_HALF = 0.5
"""m from the hinge to the middle of the pole."""
_NEAR = 0.05
"""Poles begin that near to upright, rad."""


class CartPoles(gymnasium.vector.VectorEnv):  # type: ignore[misc]
    """`count` carts with poles: actions 0 and 1 push left and right, every step up is worth 1.

    Observations (count, 4): place m, velocity m/s, angle rad clockwise, rate rad/s. An environment whose episode has
    ended begins the next one with the step after, whose action it ignores ("next step" autoreset).
    """

    metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}  # noqa: RUF012

    def __init__(self, count: int, threads: int | None = None) -> None:
        self.num_envs = count
        self.batch = Batch(load_scene(find_scene(Path("cart-pole"))), count, threads)
        self._cart, self._pole = self.batch.row("cart"), self.batch.row("pole")
        bounds = np.array([2 * FARTHEST, np.inf, 2 * STEEPEST, np.inf])
        self.single_observation_space = gymnasium.spaces.Box(-bounds, bounds, dtype=np.float64)
        self.single_action_space = gymnasium.spaces.Discrete(2)
        self.observation_space = batch_space(self.single_observation_space, count)
        self.action_space = batch_space(self.single_action_space, count)
        self._steps = np.zeros(count, np.int64)
        self._over = np.full(count, True)

    def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> tuple[Floats, dict[str, Any]]:
        """Begin all episodes anew; the same seed gives the same ones."""
        super().reset(seed=seed)
        self._begin(np.arange(self.num_envs))
        return self._observed(), {}

    def step(self, actions: Any) -> tuple[Floats, Floats, Any, Any, dict[str, Any]]:
        """Push all carts, left for 0 and right for 1, and take a step."""
        fresh = self._over.copy()
        force = np.where(np.asarray(actions) == 1, FORCE, -FORCE)
        self.batch.apply_force("cart", np.column_stack([force, np.zeros_like(force)]))
        self.batch.step()
        self._steps += 1
        if fresh.any():
            self._begin(np.flatnonzero(fresh))
        seen = self._observed()
        fallen = (np.abs(seen[:, 0]) > FARTHEST) | (np.abs(seen[:, 2]) > STEEPEST)
        late = self._steps >= LONGEST
        self._over = fallen | late
        return seen, np.where(fresh, 0.0, 1.0), fallen, late & ~fallen, {}

    def _begin(self, worlds: Integers) -> None:
        """Put carts into the middle, and poles near to upright at random."""
        self.batch.reset(worlds)
        angles = self.np_random.uniform(-_NEAR, _NEAR, len(worlds))
        places = np.column_stack([-_HALF * np.sin(angles), _HALF * np.cos(angles)])
        self.batch.set_pose("pole", places, angles, worlds)
        self._steps[worlds] = 0
        self._over[worlds] = False

    def _observed(self) -> Floats:
        batch, cart, pole = self.batch, self._cart, self._pole
        columns = (
            batch.positions[:, cart, 0],
            batch.velocities[:, cart, 0],
            -batch.angles[:, pole],
            -batch.angular_velocities[:, pole],
        )
        return np.column_stack(columns)
