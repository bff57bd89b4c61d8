"""Bodies of benchmark scenes that no generator makes. They use the prefabs and materials of the scene's file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

Words = dict[str, Any]
Parts = dict[str, list[Words]]


def joint_grid(n: int = 100, held: int = 3) -> Parts:
    """Box2D: `n` by `n` discs, column by column, hinged to their neighbours; a few at the top are static."""
    middle = range(n // 2 - held, n // 2 + held + 1)
    bodies, joints = [], []
    for column in range(n):
        for row in range(n):
            kind = "static" if row == 0 and column in middle else "dynamic"
            disc = {"id": f"disc-{column}-{row}", "prefab": "disc", "type": kind}
            bodies.append({**disc, "position": [float(column), float(-row)]})
            if row > 0:
                joints.append(_hinge((column, row - 1), (column, row)))
            if column > 0 and not (row == 0 and column in middle and column - 1 in middle):
                joints.append(_hinge((column - 1, row), (column, row)))
    return {"bodies": bodies, "joints": joints}


def _hinge(a: tuple[int, int], b: tuple[int, int]) -> Words:
    names = [f"disc-{column}-{row}" for column, row in (a, b)]
    anchor = [0.5 * (a[0] + b[0]), -0.5 * (a[1] + b[1])]
    return {"id": f"{names[0]}-{names[1]}", "type": "revolute", "bodies": names, "anchor": anchor}


def slow_explosion(count: int = 5000) -> Parts:
    """pymunk: discs on a spiral that fly outwards."""
    return {"bodies": [_flying(k, _spiral(30.0 * k / count, 30.0, 5.0), 0.2) for k in range(count)]}


def mixed_static_dynamic(count: int = 6000, n: int = 150) -> Parts:
    """pymunk: discs on a spiral that fly outwards, in the middle of `n` by `n` pegs without those of a circle."""
    discs = [_flying(k, _spiral(k / count, 50.0, 10.0), 1.0) for k in range(count)]
    for disc in discs:
        disc["position"] = [at + n / 2 for at in disc["position"]]
    pegs = [
        {"circle": 0.5, "at": [float(i), float(j)], "friction": 0.0}
        for j in range(n)
        for i in range(n)
        if (i - n / 2) ** 2 + (j - n / 2) ** 2 > (n / 2 - 8) ** 2
    ]
    return {"bodies": [{"id": "ground", "type": "static", "shapes": pegs}, *discs]}


def _spiral(s: float, growth: float, core: float) -> tuple[float, float]:
    angle = 30.0 * s
    return math.cos(angle) * (s * growth + core), math.sin(angle) * (s * growth + core)


def _flying(k: int, at: tuple[float, float], speed: float) -> Words:
    velocity = [speed * at[0], speed * at[1]]
    return {"id": f"disc-{k + 1}", "prefab": "disc", "position": list(at), "velocity": velocity}


def mostly_static_single(size: int = 50) -> Parts:
    """pymunk: one static body of square tiles, with a slanting lane left free in which discs lie."""
    tiles = [
        {"box": [1.0, 1.0], "at": [float(i) - 0.5 * size, float(j)]}
        for j in range(size)
        for i in range(size)
        if abs(j - i) > 3
    ]
    return {"bodies": [{"id": "level", "type": "static", "material": "bare", "shapes": tiles}]}


def multifixture(count: int = 100) -> Parts:
    """pymunk: bodies of many tables in the same place, with ever fewer of them."""
    bodies = []
    for k in range(count):
        at = [-20.0 + (k % 6) * 7.0 + k / 10.0, -1.0 - k / 6.0 * 5.0]
        shapes = [shape for _ in range(int(50 - k / 2)) for shape in _table()]
        if shapes:
            bodies.append({"id": f"tables-{k + 1}", "position": at, "material": "bare", "shapes": shapes})
    return {"bodies": bodies}


def _table() -> Iterator[Words]:
    for left, low, right, high, density in ((-3, 3, 3, 4, 2), (-3, -2, -2, 3, 2), (2, -2, 3, 3, 0)):
        corners = [[left, low], [right, low], [right, high], [left, high]]
        yield {"polygon": corners, "density": density}
