"""From a flat scene to the records of a world."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sandbox._jit import interpreted
from sandbox.geometry.mass import Moments, edge_normals, half_width, moments
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape, Vec
from sandbox.tables import Integers, Records, Table
from sandbox.world import records
from sandbox.world.build_fields import build_regions, build_thrusters
from sandbox.world.build_joints import build_joints
from sandbox.world.flush import join_tiles, with_room_for_tiles
from sandbox.world.roster import Roster
from sandbox.world.state import State

_cos_sin = interpreted(cos_sin)
_TYPES = {"static": records.STATIC, "kinematic": records.KINEMATIC, "dynamic": records.DYNAMIC}
_KINDS = {
    "circle": records.CIRCLE, "box": records.BOX, "capsule": records.CAPSULE,
    "segment": records.SEGMENT, "polygon": records.POLYGON,
}  # fmt: skip
_DRAGS = 8


@dataclass(frozen=True)
class Build:
    """What one tuple of shapes comes to, shared by all bodies of a prefab: rows ready to be copied."""

    shape_rows: Records
    vertex_rows: Records
    side_rows: Records
    seam_rows: Records
    mass: float
    inertia: float
    center: Vec
    extent: float


def build_state(scene: FlatScene) -> State:
    """A new state at step 0, all bodies awake. Bodies, shapes and vertices keep the order of the scene."""
    bodies, shapes, vertices, sides, seams = body_tables(scene.bodies)
    seams = with_room_for_tiles(bodies, shapes, seams)
    join_tiles(bodies, shapes, vertices, seams)
    drags = records.DRAG.zeros(_DRAGS)
    drags.body = -1
    regions, edges = build_regions(scene.regions, scene.settings.step_rate)
    roster = Roster.of(scene)
    return State(
        bodies=bodies,
        shapes=shapes,
        vertices=vertices,
        outlines=sides,
        seams=seams,
        contacts=records.CONTACT.zeros(max(16, 4 * len(shapes))),
        joints=build_joints(scene.joints, bodies, roster.bodies.names),
        drags=drags,
        regions=regions,
        edges=edges,
        thrusters=build_thrusters(scene.bodies, bodies, scene.settings.step_rate),
        settings=_settings(scene),
        counters=records.COUNTERS.zeros(1),
        roster=roster,
    )


def body_tables(scene_bodies: Sequence[FlatBody]) -> tuple[Records, Records, Records, Records, Records]:
    """Tables of bodies, shapes, vertices, outlines and seams; what one row says of others counts from 0."""
    builds = _builds(scene_bodies)
    per_body = [builds[_key(body)] for body in scene_bodies]
    bodies = records.BODY.zeros(len(scene_bodies))
    for row, body, build in zip(bodies, scene_bodies, per_body, strict=True):
        _fill_body(row, body, build)
    return bodies, *_place(per_body)


def _key(body: FlatBody) -> tuple[int, Vec | None]:
    return id(body.shapes), body.center


def _builds(bodies: Sequence[FlatBody]) -> dict[tuple[int, Vec | None], Build]:
    found: dict[tuple[int, Vec | None], Build] = {}
    for body in bodies:
        if _key(body) not in found:
            found[_key(body)] = build_shapes(body.shapes, body.center)
    return found


def build_shapes(shapes: tuple[FlatShape, ...], center: Vec | None) -> Build:
    """Rows and masses of a body with those shapes; `center` overrides its centre of mass."""
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for shape in shapes:
        if shape.sensor:
            continue
        part = moments(shape.vertices, shape.radius)
        total = total.plus(Moments(*(shape.density * value for value in part)))
    mass, first_x, first_y, second = total
    middle = center or ((first_x / mass, first_y / mass) if mass > 0.0 else (0.0, 0.0))
    shift = middle[0] * (middle[0] * mass - 2.0 * first_x) + middle[1] * (middle[1] * mass - 2.0 * first_y)
    shape_rows = records.SHAPE.zeros(len(shapes))
    vertex_rows = records.VERTEX.zeros(sum(len(shape.vertices) for shape in shapes))
    side_rows, seam_rows = _sides(shape_rows, shapes, middle), _seams(shape_rows, shapes)
    start = 0
    extent = 0.0
    solid = not all(shape.sensor for shape in shapes)
    for row, shape in zip(shape_rows, shapes, strict=True):
        _fill_shape(row, shape, start)
        for k, (vertex, normal) in enumerate(zip(shape.vertices, edge_normals(shape.vertices), strict=True)):
            x, y = vertex[0] - middle[0], vertex[1] - middle[1]
            vertex_rows[start + k] = (x, y, *normal)
            if not (shape.sensor and solid):
                extent = max(extent, math.sqrt(x * x + y * y) + shape.radius)
        start += len(shape.vertices)
    return Build(shape_rows, vertex_rows, side_rows, seam_rows, mass, second + shift, middle, extent)


def _fill_shape(row: Records, shape: FlatShape, start: int) -> None:
    row.kind = _KINDS[shape.kind]
    row.vertex_start, row.vertex_count, row.radius = start, len(shape.vertices), shape.radius
    row.thin = half_width(shape.vertices) + shape.radius
    row.friction, row.restitution = shape.friction, shape.restitution
    row.rolling_resistance, row.surface_speed = shape.rolling_resistance, shape.surface_speed
    row.density = shape.density
    row.category, row.mask, row.group = shape.category, shape.mask, shape.group
    row.sensor, row.part = int(shape.sensor), shape.part
    row.one_way_x, row.one_way_y = shape.one_way
    row.traits |= records.ONE_WAY if any(shape.one_way) else 0


def _sides(shape_rows: Records, shapes: tuple[FlatShape, ...], middle: Vec) -> Records:
    """Rows of the outline table for concave polygons; notes in the shape rows where each begins."""
    sides: list[tuple[float, float, float, float]] = []
    for row, shape in zip(shape_rows, shapes, strict=True):
        row.outline_start = len(sides)
        for ring in shape.outline if shape.part == 1 else ():
            moved = [(x - middle[0], y - middle[1]) for x, y in ring]
            sides += [(*a, *b) for a, b in zip(moved, [*moved[1:], moved[0]], strict=True)]
        row.outline_count = len(sides) - row.outline_start
    rows = records.OUTLINE.zeros(len(sides))
    rows[:] = sides
    return rows


def _seams(shape_rows: Records, shapes: tuple[FlatShape, ...]) -> Records:
    """Rows of the seam table for parts of concave polygons and chains; notes in the shape rows where each begins."""
    seams: list[tuple[float, ...]] = []
    for row, shape in zip(shape_rows, shapes, strict=True):
        row.seam_start = len(seams)
        if shape.part > 0:
            normals = _corner_normals(shape.outline)
            seams += [(*normals[v], *shown) for v, shown in zip(shape.vertices, shape.shown, strict=True)]
        seams += shape.seam
        row.traits = records.SEAMED if shape.part > 0 or shape.seam else 0
    rows = records.SEAM.zeros(len(seams))
    rows[:] = seams
    return rows


@lru_cache(maxsize=1)
def _corner_normals(outline: tuple[tuple[Vec, ...], ...]) -> dict[Vec, tuple[float, ...]]:
    """The normals of both sides that meet in a corner of a polygon: x, y of the one before, x, y of the one after."""
    found: dict[Vec, tuple[float, ...]] = {}
    for ring in outline:
        normals = edge_normals(ring)
        found.update({vertex: (*normals[k - 1], *normals[k]) for k, vertex in enumerate(ring)})
    return found


def _fill_body(row: Records, body: FlatBody, build: Build) -> None:
    cosine, sine = _cos_sin(body.angle)
    cx, cy = build.center
    row.position_x, row.position_y, row.angle = *body.position, body.angle
    row.velocity_x, row.velocity_y = body.velocity
    row.angular_velocity = body.angular_velocity
    row.local_center_x, row.local_center_y = cx, cy
    row.center_x = body.position[0] + (cosine * cx - sine * cy)
    row.center_y = body.position[1] + (sine * cx + cosine * cy)
    row.rotation_cos, row.rotation_sin = cosine, sine
    row.linear_damping, row.angular_damping = body.linear_damping, body.angular_damping
    row.gravity_scale, row.extent, row.sleep_speed = body.gravity_scale, build.extent, body.sleep_speed
    row.bullet = int(body.bullet)
    row.type, row.awake, row.frozen_step = _TYPES[body.type], 1, -1
    if body.type == "static":
        row.velocity_x = row.velocity_y = row.angular_velocity = 0.0
    if body.type == "dynamic":
        fill_mass(row, body, build)


def fill_mass(row: Records, body: FlatBody, build: Build) -> None:
    """Mass and inertia: overrides first; a mass override alone scales the inertia with it."""
    row.mass = body.mass if body.mass is not None else build.mass
    scale = row.mass / build.mass if build.mass > 0.0 else 0.0
    row.inertia = body.inertia if body.inertia is not None else build.inertia * scale
    row.inverse_mass = 1.0 / row.mass if row.mass > 0.0 else 0.0
    if body.fixed_rotation or row.inertia <= 0.0:
        row.inertia = 0.0
    row.inverse_inertia = 1.0 / row.inertia if row.inertia > 0.0 else 0.0


def _place(builds: list[Build]) -> tuple[Records, Records, Records, Records]:
    """Shape, vertex, outline and seam tables of the whole world, with indices shifted into place."""
    shapes = _joined(records.SHAPE, [build.shape_rows for build in builds])
    counts = np.array([len(build.shape_rows) for build in builds], dtype=np.int64)
    shapes.body = np.repeat(np.arange(len(builds)), counts)
    shapes.vertex_start += np.repeat(_starts([build.vertex_rows for build in builds]), counts)
    shapes.outline_start += np.repeat(_starts([build.side_rows for build in builds]), counts)
    shapes.seam_start += np.repeat(_starts([build.seam_rows for build in builds]), counts)
    vertices = _joined(records.VERTEX, [build.vertex_rows for build in builds])
    sides = _joined(records.OUTLINE, [build.side_rows for build in builds])
    return shapes, vertices, sides, _joined(records.SEAM, [build.seam_rows for build in builds])


def _joined(table: Table, rows: list[Records]) -> Records:
    """One array of all rows."""
    joined = table.zeros(sum(map(len, rows)))
    if rows:
        np.concatenate(rows, out=joined)
    return joined


def _starts(rows: list[Records]) -> Integers:
    """Where the rows of each begin when all are joined."""
    counts = np.array([len(each) for each in rows], dtype=np.int64)
    return np.cumsum(counts) - counts


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
    row.warm_starting, row.accumulate = int(settings.warm_starting), int(settings.accumulate)
    row.soft, row.relax, row.speculative = int(settings.soft), int(settings.relax), int(settings.speculative)
    return table
