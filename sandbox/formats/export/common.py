"""What exporters have in common: masses, frames of bodies, and what no other engine has."""

from __future__ import annotations

import math

from sandbox.formats.box2d.world import MassData
from sandbox.formats.numbers import Vec, turned
from sandbox.formats.remarks import Remarks
from sandbox.geometry.mass import Moments, moments
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene
from sandbox.scene.scene import Scene
from sandbox.scene.settings import Settings

STRONG = 1e12
"""Force or torque of a motor that is as strong as it needs to be: files hold no infinity."""

_OURS = {"steps", "restitution_threshold"}
"""Settings that are told otherwise, or mean nothing but to `sandbox check`."""


def mass_of(body: FlatBody) -> MassData:
    """Mass (kg), centre (m) and inertia about the centre (kg m^2) of a body that can be pushed."""
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for shape in body.shapes:
        density = 0.0 if shape.sensor else shape.density
        total = total.plus(Moments(*(density * value for value in moments(shape.vertices, shape.radius))))
    area = total.area
    center = body.center or ((total.first_x / area, total.first_y / area) if area > 0.0 else (0.0, 0.0))
    mass = body.mass if body.mass is not None else area
    if body.inertia is not None:
        return MassData(mass, center, body.inertia)
    x, y = center
    about = total.second + x * (x * area - 2.0 * total.first_x) + y * (y * area - 2.0 * total.first_y)
    return MassData(mass, center, about * mass / area if area > 0.0 else 0.0)


def in_body(body: FlatBody | None, point: Vec) -> Vec:
    """A point of the world in the frame of a body; None is the world."""
    if body is None:
        return point
    return turned((point[0] - body.position[0], point[1] - body.position[1]), -body.angle)


def angle_between(a: FlatBody | None, b: FlatBody | None) -> float:
    """The angle of the second body against the first one at the start, rad."""
    return (b.angle if b else 0.0) - (a.angle if a else 0.0)


def limited(joint: FlatJoint) -> bool:
    """Whether a joint has a limit at either end."""
    return math.isfinite(joint.lower) or math.isfinite(joint.upper)


def finite(value: float) -> float:
    """A strength, or a great one for one without bound."""
    return value if math.isfinite(value) else STRONG


def note_settings(scene: Scene, remarks: Remarks, kept: set[str]) -> None:
    """Remarks on settings that are not the usual ones, but for those `kept` and the length of a check."""
    given, usual = dict(scene.settings), dict(Settings())
    changed = [name for name in given.keys() - kept - _OURS if given[name] != usual[name]]
    if changed:
        remarks.note(f"({', '.join(sorted(changed))})", "settings are left out")


def note_foreign(scene: FlatScene, remarks: Remarks) -> None:
    """Remarks on what no other engine has."""
    left_out = {
        "regions are left out": bool(scene.regions),
        "rules, controls and counters are left out": bool(scene.rules or scene.controls or scene.counters),
    }
    for text, is_there in left_out.items():
        if is_there:
            remarks.note("", text)
    for body in scene.bodies:
        if body.thrusters:
            remarks.note(body.id, "thrusters are left out")
        if body.path is not None:
            remarks.note(body.id, "paths are left out: the body stands still")
        if any(shape.rolling_resistance for shape in body.shapes):
            remarks.note(body.id, "rolling resistance is left out")
        if any(shape.surface_speed for shape in body.shapes):
            remarks.note(body.id, "speeds of surfaces are left out")
        if any(any(shape.one_way) for shape in body.shapes):
            remarks.note(body.id, "one-way shapes and one-sided chains are solid from both sides")
    for joint in scene.joints:
        if math.isfinite(joint.break_force) or math.isfinite(joint.break_torque):
            remarks.note(joint.id, "a joint does not break")
