"""Rows of the body table for bodies that are nowhere yet: what they are and what they weigh."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.scene.flat import FlatBody
from sandbox.tables import Floats, plain
from sandbox.world import records

TYPES = {"static": records.STATIC, "kinematic": records.KINEMATIC, "dynamic": records.DYNAMIC}
"""The number of each type of body."""
_SAME = ("linear_damping", "angular_damping", "gravity_scale", "sleep_speed", "bullet")


def build_prototypes(bodies: Sequence[FlatBody], weights: tuple[Floats, Floats, Floats, Floats]) -> NDArray[Any]:
    """A row for each body, awake; `weights` are mass (kg), inertia (kg m^2) and centre of mass (m) of their shapes."""
    mass, inertia, center_x, center_y = weights
    rows = plain(records.BODY.zeros(len(bodies)))
    for name in _SAME:
        rows[name] = np.array([getattr(body, name) for body in bodies], rows[name].dtype)
    rows["type"] = np.array([TYPES[body.type] for body in bodies], np.int64)
    rows["awake"], rows["frozen_step"] = 1, -1
    rows["local_center_x"], rows["local_center_y"] = center_x, center_y
    _fill_masses(rows, bodies, mass, inertia)
    return rows


def _fill_masses(rows: NDArray[Any], bodies: Sequence[FlatBody], mass: Floats, inertia: Floats) -> None:
    """Mass and inertia: overrides first; a mass override alone scales the inertia with it."""
    dynamic = rows["type"] == records.DYNAMIC
    own_mass = np.array([np.nan if body.mass is None else body.mass for body in bodies], float)
    own_inertia = np.array([np.nan if body.inertia is None else body.inertia for body in bodies], float)
    turns = np.array([not body.fixed_rotation for body in bodies], np.bool_)
    final = np.where(np.isnan(own_mass), mass, own_mass)
    scale = _ratios(final, mass)
    final_inertia = np.where(np.isnan(own_inertia), inertia * scale, own_inertia)
    rows["mass"] = np.where(dynamic, final, 0.0)
    rows["inertia"] = np.where(dynamic & turns & (final_inertia > 0.0), final_inertia, 0.0)
    rows["inverse_mass"] = _ratios(np.ones(len(rows)), rows["mass"])
    rows["inverse_inertia"] = _ratios(np.ones(len(rows)), rows["inertia"])


def _ratios(above: Floats, below: Floats) -> Floats:
    """One over the other, and 0 where there is nothing below."""
    return np.divide(above, below, out=np.zeros(len(above)), where=below > 0.0)
