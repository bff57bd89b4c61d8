"""What rattles in a closed box, with restitution and friction, gains no energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import sandbox

KINDS: list[dict[str, Any]] = [
    {"circle": 0.3},
    {"box": [0.6, 0.6]},
    {"box": [1.2, 0.15]},
    {"capsule": [[-0.3, 0], [0.3, 0]], "radius": 0.15},
    {"polygon": [[-0.4, -0.3], [0.4, -0.3], [0, 0.5]]},
]


def crowd(seed: int) -> sandbox.World:
    """Up to 48 bodies of all kinds and masses, thrown about at up to 30 m/s in a box of 8 m, without gravity."""
    rng = np.random.default_rng(seed)
    surface = {"restitution": float(rng.uniform(0.2, 1.0)), "friction": float(rng.choice([0.0, 0.3, 0.8, 1.5]))}
    walls = [{"box": [10, 1], "at": [0, 4.5 * s], **surface} for s in (-1, 1)]
    walls += [{"box": [1, 10], "at": [4.5 * s, 0], **surface} for s in (-1, 1)]
    bodies: list[dict[str, Any]] = [{"id": "walls", "type": "static", "shapes": walls}]
    for k, cell in enumerate(rng.permutation(49)[: rng.integers(4, 49)]):
        kind = KINDS[rng.integers(len(KINDS))] | surface | {"density": float(10.0 ** rng.uniform(-1.0, 1.0))}
        bodies.append(
            {
                "id": f"body-{k}",
                "shapes": [kind],
                "position": [1.1 * (cell % 7 - 3), 1.1 * (cell // 7 - 3)],
                "angle": float(rng.uniform(0.0, 360.0)),
                "velocity": (rng.normal(size=2) * rng.choice([1.0, 5.0, 15.0])).tolist(),
                "angular_velocity": float(300.0 * rng.normal()),
            }
        )
    return sandbox.World(sandbox.Scene(bodies=bodies, gravity=(0, 0), settings={"sleeping": False}))


def energy(world: sandbox.World) -> float:
    """Of all that moves, J."""
    b = world.state.bodies[1:]
    return float(0.5 * np.sum(b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2))


@pytest.mark.parametrize("seeds", [range(k, k + 10) for k in range(0, 40, 10)], ids=str)
def test_what_rattles_gains_no_energy(seeds):
    """Two thousandths of what there was to begin with at most, as what overlaps is pushed out."""
    for seed in seeds:
        world = crowd(seed)
        before = least = energy(world)
        for step in range(60):
            world.step()
            now = energy(world)
            assert now <= least + 2e-3 * before, f"crowd {seed}, step {step + 1}"
            least = min(least, now)
