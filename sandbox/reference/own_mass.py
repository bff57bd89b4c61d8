"""Mass, centre and moment of inertia of a body as the scene has them, for engines that find others by themselves."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.geometry.mass import Moments, moments
from sandbox.scene.flat import FlatBody, Vec


class OwnMass(NamedTuple):
    """Mass (kg), centre of mass from the origin of the body (m), moment of inertia about it (kg m^2)."""

    mass: float
    center: Vec
    inertia: float


def own_mass(flat: FlatBody) -> OwnMass:
    """That of a dynamic body: what it gives, and the rest as its shapes have it."""
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for shape in flat.shapes:
        density = 0.0 if shape.sensor else shape.density
        total = total.plus(Moments(*(density * value for value in moments(shape.vertices, shape.radius))))
    center = flat.center or (total.first_x / total.area, total.first_y / total.area)
    middle = total.second + center[0] * (center[0] * total.area - 2.0 * total.first_x)
    middle += center[1] * (center[1] * total.area - 2.0 * total.first_y)
    mass = flat.mass if flat.mass is not None else total.area
    return OwnMass(mass, center, flat.inertia if flat.inertia is not None else middle * mass / total.area)
