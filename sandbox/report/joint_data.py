"""The joints of a film, as plain data that a canvas can draw."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.world import joint_records as kinds
from sandbox.world.state import State

_LOOKS = {
    kinds.DISTANCE: "rod",
    kinds.REVOLUTE: "pin",
    kinds.PRISMATIC: "rail",
    kinds.WELD: "weld",
    kinds.WHEEL: "pin",
    kinds.PULLEY: "pulley",
    kinds.MOTOR: "goal",
    kinds.TARGET: "goal",
    kinds.FRICTION: "pin",
    kinds.GEAR: "",
}
"""How each kind is drawn; a gear shows in what it turns."""


def held_joints(state: State) -> NDArray[np.bool_]:
    """Which joints hold, row by row: neither broken nor switched off."""
    held: NDArray[np.bool_] = (np.asarray(state.joints.enabled) == 1) & (np.asarray(state.joints.broken_step) < 0)
    return held


def joint_data(row: Any, slots: Sequence[int]) -> dict[str, Any]:
    """One joint: how it looks, its bodies (-1: the world) and its anchors in their frames."""
    kind = int(row.kind)
    look = _LOOKS[kind]
    bodies = [slots[int(body)] if body >= 0 else -1 for body in (row.body_a, row.body_b)]
    data: dict[str, Any] = {"look": look, "bodies": bodies, "a": _point(row, "anchor_a"), "b": _point(row, "anchor_b")}
    if look == "rod" and row.spring:
        data["look"] = "spring"
    elif look == "rod" and row.limit and math.isfinite(row.upper):
        data |= {"look": "rope", "length": float(row.upper)}
    elif look == "rail":
        low, high = float(row.lower), float(row.upper)
        ends = [low if math.isfinite(low) else -0.5, high if math.isfinite(high) else 0.5]
        data |= {"axis": _point(row, "axis_"), "ends": ends}
    elif look in ("pulley", "goal"):
        data |= {"wheels": [_point(row, "point_a"), _point(row, "point_b")], "inside": kind == kinds.MOTOR}
    return data


def _point(row: Any, name: str) -> list[float]:
    return [float(f"{float(row[name + axis]):.6g}") for axis in "xy"]
