"""From a flat scene to the records of a world."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sandbox._jit import interpreted
from sandbox.geometry.mass import Moments, edge_normals, moments
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape, Vec
from sandbox.tables import Records
from sandbox.world import records
from sandbox.world.state import State

_cos_sin = interpreted(cos_sin)
_TYPES = {"static": records.STATIC, "kinematic": records.KINEMATIC, "dynamic": records.DYNAMIC}
_KINDS = {
    "circle": records.CIRCLE, "box": records.BOX, "capsule": records.CAPSULE,
    "segment": records.SEGMENT, "polygon": records.POLYGON,
}  # fmt: skip
_DRAGS = 8


@dataclass(frozen=True)
class _Outline:
    """What one tuple of shapes comes to, shared by all bodies of a prefab: rows ready to be copied."""

    shape_rows: Records
    vertex_rows: Records
    mass: float
    inertia: float
    center: Vec
    extent: float


def build_state(scene: FlatScene) -> State:
    """A new state at step 0, all bodies awake. Bodies, shapes and vertices keep the order of the scene."""
    outlines = _outlines(scene)
    per_body = [outlines[_key(body)] for body in scene.bodies]
    bodies = records.BODY.zeros(len(scene.bodies))
    for row, body, outline in zip(bodies, scene.bodies, per_body, strict=True):
        _fill_body(row, body, outline)
    shapes, vertices = _place(per_body)
    drags = records.DRAG.zeros(_DRAGS)
    drags.body = -1
    return State(
        bodies=bodies,
        shapes=shapes,
        vertices=vertices,
        contacts=records.CONTACT.zeros(max(16, 4 * len(shapes))),
        drags=drags,
        settings=_settings(scene),
        counters=records.COUNTERS.zeros(1),
        names=tuple(body.id for body in scene.bodies),
    )


def _key(body: FlatBody) -> tuple[int, Vec | None]:
    return id(body.shapes), body.center


def _outlines(scene: FlatScene) -> dict[tuple[int, Vec | None], _Outline]:
    found: dict[tuple[int, Vec | None], _Outline] = {}
    for body in scene.bodies:
        if _key(body) not in found:
            found[_key(body)] = _outline(body.shapes, body.center)
    return found


def _outline(shapes: tuple[FlatShape, ...], center: Vec | None) -> _Outline:
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for shape in shapes:
        part = moments(shape.vertices, shape.radius)
        total = total.plus(Moments(*(shape.density * value for value in part)))
    mass, first_x, first_y, second = total
    middle = center or ((first_x / mass, first_y / mass) if mass > 0.0 else (0.0, 0.0))
    shift = middle[0] * (middle[0] * mass - 2.0 * first_x) + middle[1] * (middle[1] * mass - 2.0 * first_y)
    shape_rows = records.SHAPE.zeros(len(shapes))
    vertex_rows = records.VERTEX.zeros(sum(len(shape.vertices) for shape in shapes))
    start = 0
    extent = 0.0
    for row, shape in zip(shape_rows, shapes, strict=True):
        _fill_shape(row, shape, start)
        for k, (vertex, normal) in enumerate(zip(shape.vertices, edge_normals(shape.vertices), strict=True)):
            x, y = vertex[0] - middle[0], vertex[1] - middle[1]
            vertex_rows[start + k] = (x, y, *normal)
            extent = max(extent, math.sqrt(x * x + y * y) + shape.radius)
        start += len(shape.vertices)
    return _Outline(shape_rows, vertex_rows, mass, second + shift, middle, extent)


def _fill_shape(row: Records, shape: FlatShape, start: int) -> None:
    row.kind = _KINDS[shape.kind]
    row.vertex_start, row.vertex_count, row.radius = start, len(shape.vertices), shape.radius
    row.friction, row.restitution = shape.friction, shape.restitution
    row.rolling_resistance, row.surface_speed = shape.rolling_resistance, shape.surface_speed
    row.category, row.mask, row.group = shape.category, shape.mask, shape.group


def _fill_body(row: Records, body: FlatBody, outline: _Outline) -> None:
    cosine, sine = _cos_sin(body.angle)
    cx, cy = outline.center
    row.position_x, row.position_y, row.angle = *body.position, body.angle
    row.velocity_x, row.velocity_y = body.velocity
    row.angular_velocity = body.angular_velocity
    row.local_center_x, row.local_center_y = cx, cy
    row.center_x = body.position[0] + (cosine * cx - sine * cy)
    row.center_y = body.position[1] + (sine * cx + cosine * cy)
    row.rotation_cos, row.rotation_sin = cosine, sine
    row.linear_damping, row.angular_damping = body.linear_damping, body.angular_damping
    row.gravity_scale, row.extent = body.gravity_scale, outline.extent
    row.type, row.awake, row.frozen_step = _TYPES[body.type], 1, -1
    if body.type == "static":
        row.velocity_x = row.velocity_y = row.angular_velocity = 0.0
    if body.type == "dynamic":
        _fill_mass(row, body, outline)


def _fill_mass(row: Records, body: FlatBody, outline: _Outline) -> None:
    """Mass and inertia: overrides first; a mass override alone scales the inertia with it."""
    row.mass = body.mass if body.mass is not None else outline.mass
    scale = row.mass / outline.mass if outline.mass > 0.0 else 0.0
    row.inertia = body.inertia if body.inertia is not None else outline.inertia * scale
    row.inverse_mass = 1.0 / row.mass if row.mass > 0.0 else 0.0
    if body.fixed_rotation or row.inertia <= 0.0:
        row.inertia = 0.0
    row.inverse_inertia = 1.0 / row.inertia if row.inertia > 0.0 else 0.0


def _place(outlines: list[_Outline]) -> tuple[Records, Records]:
    """Shape and vertex tables of the whole world, with body and vertex indices shifted into place."""
    shape_counts = np.array([len(outline.shape_rows) for outline in outlines], dtype=np.int64)
    vertex_counts = np.array([len(outline.vertex_rows) for outline in outlines], dtype=np.int64)
    shapes = records.SHAPE.zeros(int(shape_counts.sum()))
    vertices = records.VERTEX.zeros(int(vertex_counts.sum()))
    if outlines:
        np.concatenate([outline.shape_rows for outline in outlines], out=shapes)
        np.concatenate([outline.vertex_rows for outline in outlines], out=vertices)
        shapes.body = np.repeat(np.arange(len(outlines)), shape_counts)
        shapes.vertex_start += np.repeat(np.cumsum(vertex_counts) - vertex_counts, shape_counts)
    return shapes, vertices


def _settings(scene: FlatScene) -> Records:
    table = records.SETTINGS.zeros(1)
    row = table[0]
    settings = scene.settings
    row.step_seconds, row.substeps = 1.0 / settings.step_rate, settings.substeps
    row.gravity_x, row.gravity_y = scene.gravity
    row.contact_hertz = settings.contact_hertz
    row.contact_damping_ratio = settings.contact_damping_ratio
    row.push_out_speed = settings.push_out_speed
    row.restitution_threshold = settings.restitution_threshold
    row.sleeping = int(settings.sleeping)
    return table
