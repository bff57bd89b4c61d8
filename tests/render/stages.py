"""Small worlds to draw: flat scenes with every kind of shape, turned into states."""

from __future__ import annotations

import math

from sandbox.scene import Scene
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape
from sandbox.world.build import build_state
from sandbox.world.state import State


def box(width: float, height: float, radius: float = 0.0, at: tuple[float, float] = (0.0, 0.0)) -> FlatShape:
    x, y = width / 2, height / 2
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return FlatShape("box", tuple((at[0] + u, at[1] + v) for u, v in corners), radius)


def circle(radius: float, at: tuple[float, float] = (0.0, 0.0)) -> FlatShape:
    return FlatShape("circle", (at,), radius)


def rod(length: float, radius: float) -> FlatShape:
    kind = "capsule" if radius else "segment"
    return FlatShape(kind, ((-length / 2, 0.0), (length / 2, 0.0)), radius)


def ngon(n: int, size: float, radius: float = 0.0) -> FlatShape:
    angles = [2 * math.pi * k / n for k in range(n)]
    return FlatShape("polygon", tuple((size * math.cos(a), size * math.sin(a)) for a in angles), radius)


def ground(width: float = 40.0) -> FlatBody:
    return FlatBody("ground", "static", (box(width, 1.0),), (0.0, -0.5))


def zoo() -> State:
    """One of everything, turned a little."""
    wedge = FlatShape("polygon", ((-1.0, 0.0), (1.4, 0.0), (-1.0, 1.2)))
    compound = (box(1.6, 0.4), circle(0.5, (0.9, 0.2)), circle(0.3, (-0.8, 0.0)))
    bodies = (
        ground(),
        FlatBody("wall", "static", (rod(6.0, 0.0),), (-7.0, 2.0), math.radians(80)),
        FlatBody("lift", "kinematic", (box(3.0, 0.3),), (5.5, 2.6), 0.1),
        FlatBody("crate", "dynamic", (box(1.2, 1.2),), (-4.5, 0.8), 0.3),
        FlatBody("plank", "dynamic", (box(3.0, 0.3),), (-1.5, 2.9), -0.2),
        FlatBody("pillow", "dynamic", (box(1.0, 0.6, 0.25),), (-1.9, 0.9), 0.5),
        FlatBody("ball", "dynamic", (circle(0.8),), (0.6, 0.8), 0.7),
        FlatBody("pill", "dynamic", (rod(1.5, 0.35),), (2.6, 1.0), 0.9),
        FlatBody("wedge", "dynamic", (wedge,), (4.2, 0.0), 0.0),
        FlatBody("gem", "dynamic", (ngon(5, 0.7, 0.12),), (6.6, 0.9), 0.4),
        FlatBody("coin", "dynamic", (ngon(64, 0.6),), (5.2, 3.5), 1.0),
        FlatBody("tool", "dynamic", compound, (0.7, 3.4), 0.6),
        FlatBody("wire", "dynamic", (rod(2.0, 0.0),), (3.0, 3.3), 0.4),
        FlatBody("dozer", "dynamic", (box(0.8, 0.8),), (-6.0, 0.4)),
        FlatBody("broken", "dynamic", (box(1.0, 1.0),), (-4.2, 3.0), 0.2),
    )
    state = build_state(FlatScene(bodies))
    state.bodies[13].awake = 0
    state.bodies[14].frozen_step = 5
    return state


def pyramid(rows: int, size: float = 1.0) -> State:
    shapes = (box(size, size),)
    crates = [
        FlatBody(
            f"crate/{r * rows + k}",
            "dynamic",
            shapes,
            ((k - (rows - 1 - r) / 2) * size * 1.02, (r + 0.5) * size),
        )
        for r in range(rows)
        for k in range(rows - r)
    ]
    return build_state(FlatScene((ground(rows * size * 2 + 10), *crates)))


def letters(kind: str = "dynamic") -> State:
    """Concave polygons, some with holes, turned; one of them frozen."""
    gear = [[r * math.cos(k * math.pi / 12 + t), r * math.sin(k * math.pi / 12 + t)] for k in range(24) for t, r in
            ((0.0, 0.8 if k % 2 else 1.1), (math.pi / 24, 0.8 if k % 2 else 1.1))]  # fmt: skip
    square = [[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3], [-0.3, 0.3]]
    shapes = {
        "L": {"polygon": [[0, 0], [1.4, 0], [1.4, 0.5], [0.5, 0.5], [0.5, 2], [0, 2]]},
        "T": {"polygon": [[-1, 1.5], [-0.3, 1.5], [-0.3, 0], [0.3, 0], [0.3, 1.5], [1, 1.5], [1, 2], [-1, 2]]},
        "gear": {"polygon": gear, "holes": [square]},
        "A": {
            "polygon": [[0, 0], [0.5, 0], [0.7, 0.6], [1.3, 0.6], [1.5, 0], [2, 0], [1.25, 2.2], [0.75, 2.2]],
            "holes": [[[0.8, 1], [1.2, 1], [1, 1.6]]],
        },
    }
    bodies = [
        {"id": name, "type": kind, "position": [3 * k - 5, 0.5], "angle": 17 * k, "shapes": [shape]}
        for k, (name, shape) in enumerate(shapes.items())
    ]
    state = build_state(Scene(bodies=bodies).flatten())
    state.bodies[1].frozen_step = 5
    return state
