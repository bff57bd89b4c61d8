"""Rows of the body table, and of all tables of shapes, for many bodies at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox._jit import interpreted
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat import FlatBody
from sandbox.tables import Floats, Records
from sandbox.world import records
from sandbox.world.patterns import KnownPatterns, pattern_keys
from sandbox.world.shape_rows import Rows, build_patterns

_cos_sin = interpreted(cos_sin)
_WORDS = tuple(field.name for field in records.BODY.fields)
_PLACES = [
    _WORDS.index(name)
    for name in (
        "position_x", "position_y", "angle", "velocity_x", "velocity_y", "angular_velocity", "rotation_cos",
        "rotation_sin", "center_x", "center_y",
    )
]  # fmt: skip
"""Which words of a row say where a body is and how it moves: written at once, as each by itself takes a microsecond."""
_FEW = 16
"""So many angles are quicker worked out than looked through for equal ones."""


def body_tables(bodies: Sequence[FlatBody]) -> tuple[Records, ...]:
    """Tables of bodies, shapes, vertices, outlines and seams; what one row says of others counts from 0.

    All bodies are awake. Those that share a tuple of shapes are worked out once.
    """
    return tuple(each.view(np.recarray) for each in body_rows(bodies))


def body_rows(bodies: Sequence[FlatBody], known: KnownPatterns | None = None) -> tuple[Rows, ...]:
    """`body_tables` as plain arrays. What is `known` is not worked out again; what is not will be known then."""
    numbers: dict[tuple[int, bytes], int] = {}
    found: list[FlatBody] = []
    of_body: list[int] = []
    for key, body in zip(pattern_keys(bodies), bodies, strict=True):
        number = numbers.setdefault(key, len(found))
        of_body.append(number)
        if number == len(found):
            found.append(body)
    patterns = build_patterns(found) if known is None else known.of(list(numbers), found)
    rows = np.array(of_body, np.int64)
    return _placed(bodies, patterns.bodies.take(rows)), *patterns.placed(rows)


def _placed(bodies: Sequence[FlatBody], rows: NDArray[Any]) -> NDArray[Any]:
    """Put bodies where they are to be, each turned and moving as it says."""
    numbers = [(*body.position, body.angle, *body.velocity, body.angular_velocity) for body in bodies]
    columns = np.empty((len(_PLACES), len(bodies)))
    columns[:6] = np.array(numbers, float).reshape(-1, 6).T
    x, y, angle = columns[:3]
    columns[6:8] = cosine, sine = _turned(angle)
    cx, cy = rows["local_center_x"], rows["local_center_y"]
    columns[8], columns[9] = x + (cosine * cx - sine * cy), y + (sine * cx + cosine * cy)
    columns[3:6, rows["type"] == records.STATIC] = 0.0
    rows.view(np.float64).reshape(len(bodies), len(_WORDS))[:, _PLACES] = columns.T
    return rows


def _turned(angles: Floats) -> Floats:
    """Cosines and sines; where many are asked for, each angle is worked out once."""
    if len(angles) <= _FEW:
        return np.array([_cos_sin(angle) for angle in angles.tolist()], float).reshape(-1, 2).T
    values, where = np.unique(angles, return_inverse=True)
    pairs: Floats = np.array([_cos_sin(angle) for angle in values.tolist()], float)[where].T
    return pairs
