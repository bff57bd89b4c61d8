"""Which columns of a region's record hold which fields of a scene file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sandbox.world.build_fields import KINDS

_FLOW = ("flow_x", "flow_y")
COLUMNS: dict[str, dict[str, tuple[str, ...]]] = {
    "water": {
        "water": ("density",), "surface": (), "drag": ("drag",), "angular_drag": ("angular_drag",), "flow": _FLOW,
    },
    "gravity": {"gravity": ("gravity_x", "gravity_y")},
    "gravity_scale": {"gravity_scale": ("scale",)},
    "attraction": {
        "attraction": ("strength",), "at": ("center_x", "center_y"), "falloff": ("falloff",), "core": ("core",),
        "range": ("range",),
    },
    "wind": {"wind": _FLOW, "density": ("density",), "drag": ("drag",)},
}  # fmt: skip
"""The fields that a region of each kind has, and where its record keeps them: a surface is its last edge."""


def columns_of(row: Any) -> Mapping[str, tuple[str, ...]]:
    """The fields of a region, the first of which tells its kind, and where its record keeps them."""
    return COLUMNS[next(name for name, number in KINDS.items() if number == row.kind)]
