"""Whether a body can be simulated as described: a mass where it needs one, stillness where it is static."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

SHORTEST = 1e-3
"""The shortest time that a path may take, s."""


def faults(traits: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Message and mend for everything wrong with the fields of a flat body."""
    if traits["type"] == "static" and (traits["velocity"] != (0.0, 0.0) or traits["angular_velocity"] != 0.0):
        yield "a static body cannot have a velocity", 'a body that moves by itself is "kinematic"'
    if traits.get("path") is not None:
        if traits["type"] != "kinematic":
            yield "only a kinematic body follows a path", 'give it "type": "kinematic"'
        elif traits["velocity"] != (0.0, 0.0) or traits["angular_velocity"] != 0.0:
            yield "a body on a path has no velocity of its own", "take the velocity away, or the path"
        if traits["path"].times[-1] < SHORTEST:
            yield f"a path takes at least {SHORTEST:g} s", "to turn on the spot, or to wait, give it times"
    if traits["type"] != "dynamic" or any(_has_mass(shape) for shape in traits["shapes"]):
        return
    if traits["mass"] is None:
        yield "a dynamic body without mass", "give its shapes a density and an area, or give it a mass"
    elif traits["inertia"] is None and not traits["fixed_rotation"]:
        yield "a body whose shapes have no mass needs an inertia", 'give "inertia", or "fixed_rotation": true'


def _has_mass(shape: Any) -> bool:
    return bool(shape.density > 0.0 and not shape.sensor and (shape.kind != "segment" or shape.radius > 0.0))
