"""Rows of the body table, and of all tables of shapes, for many bodies at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox._jit import interpreted
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat import FlatBody
from sandbox.tables import Floats, Integers, Records
from sandbox.world import records
from sandbox.world.shape_rows import Patterns, build_patterns

_cos_sin = interpreted(cos_sin)
_TYPES = {"static": records.STATIC, "kinematic": records.KINEMATIC, "dynamic": records.DYNAMIC}
_SAME = ("angle", "angular_velocity", "linear_damping", "angular_damping", "gravity_scale", "sleep_speed", "bullet")


def body_tables(bodies: Sequence[FlatBody]) -> tuple[Records, Records, Records, Records, Records]:
    """Tables of bodies, shapes, vertices, outlines and seams; what one row says of others counts from 0.

    All bodies are awake. Those that share a tuple of shapes are worked out once.
    """
    numbers: dict[object, int] = {}
    found: list[FlatBody] = []
    of_body: list[int] = []
    for body in bodies:
        key = id(body.shapes) if body.center is None else (id(body.shapes), body.center)
        number = numbers.setdefault(key, len(found))
        of_body.append(number)
        if number == len(found):
            found.append(body)
    patterns = build_patterns(found)
    rows = np.array(of_body, np.int64)
    return _body_rows(bodies, patterns, rows), *patterns.placed(rows)


def _body_rows(bodies: Sequence[FlatBody], patterns: Patterns, of_body: Integers) -> Records:
    rows = records.BODY.zeros(len(bodies))
    for name in _SAME:
        rows[name] = np.array([getattr(body, name) for body in bodies], rows[name].dtype)
    rows.type = np.array([_TYPES[body.type] for body in bodies], np.int64)
    rows.awake, rows.frozen_step = 1, -1
    rows.position_x, rows.position_y = np.array([body.position for body in bodies], float).reshape(-1, 2).T
    rows.velocity_x, rows.velocity_y = np.array([body.velocity for body in bodies], float).reshape(-1, 2).T
    still = np.asarray(rows.type) == records.STATIC
    for name in ("velocity_x", "velocity_y", "angular_velocity"):
        rows[name][still] = 0.0
    cx, cy = patterns.center_x[of_body], patterns.center_y[of_body]
    cosine, sine = _turned(rows.angle)
    rows.rotation_cos, rows.rotation_sin = cosine, sine
    rows.local_center_x, rows.local_center_y, rows.extent = cx, cy, patterns.extent[of_body]
    rows.center_x = rows.position_x + (cosine * cx - sine * cy)
    rows.center_y = rows.position_y + (sine * cx + cosine * cy)
    _fill_masses(rows, bodies, patterns.mass[of_body], patterns.inertia[of_body])
    return rows


def _turned(angles: Floats) -> tuple[Floats, Floats]:
    """Cosines and sines; each angle is worked out once."""
    values, where = np.unique(angles, return_inverse=True)
    pairs = np.array([_cos_sin(angle) for angle in values.tolist()], float).reshape(-1, 2)
    return pairs[where, 0], pairs[where, 1]


def _fill_masses(rows: Records, bodies: Sequence[FlatBody], mass: Floats, inertia: Floats) -> None:
    """Mass and inertia: overrides first; a mass override alone scales the inertia with it."""
    dynamic = np.asarray(rows.type) == records.DYNAMIC
    own_mass = np.array([np.nan if body.mass is None else body.mass for body in bodies], float)
    own_inertia = np.array([np.nan if body.inertia is None else body.inertia for body in bodies], float)
    turns = np.array([not body.fixed_rotation for body in bodies], np.bool_)
    final = np.where(np.isnan(own_mass), mass, own_mass)
    scale = _ratios(final, mass)
    final_inertia = np.where(np.isnan(own_inertia), inertia * scale, own_inertia)
    rows.mass = np.where(dynamic, final, 0.0)
    rows.inertia = np.where(dynamic & turns & (final_inertia > 0.0), final_inertia, 0.0)
    rows.inverse_mass = _ratios(np.ones(len(rows)), rows.mass)
    rows.inverse_inertia = _ratios(np.ones(len(rows)), rows.inertia)


def _ratios(above: Floats, below: Floats) -> Floats:
    """One over the other, and 0 where there is nothing below."""
    return np.divide(above, below, out=np.zeros(len(above)), where=below > 0.0)
