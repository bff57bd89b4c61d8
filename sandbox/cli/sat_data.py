"""What the JSON document of `sandbox sat` has to tell."""

from __future__ import annotations

from typing import Any

from sandbox.cli.sat_pair import SatPair
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shapes import Shape


def facts(pair: SatPair, table: SatTable) -> dict[str, Any]:
    """Everything the table says, and whose shapes they are."""
    bodies = zip(pair.names, pair.numbers, (pair.a, pair.b), strict=True)
    return {
        "step": pair.world.step_count,
        "bodies": [{"id": name, "shape": number, **_shape(shape)} for name, number, shape in bodies],
        **table.to_data(),
    }


def _shape(shape: Shape) -> dict[str, Any]:
    return {"kind": type(shape).__name__.lower(), "vertices": shape.given, "radius": shape.radius}
