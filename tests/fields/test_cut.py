"""The area of a shape within a region, its centroid and second moment, against shapely's fine polygons."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from sandbox._jit import entry_point, kernel_argument
from sandbox.engine.fields.area import cut
from sandbox.engine.fields.boundary import trace
from sandbox.engine.fields.moments import enclosed
from sandbox.engine.fields.records import MAX_PIECES, PIECE
from sandbox.scene.flat import FlatRegion, FlatShape
from sandbox.tables import Records
from sandbox.world.build_fields import build_regions
from tests.examples import examples
from tests.fields.pools import inside
from tests.flat import body, box, capsule, circle, polygon, segment, world

SHAPES = [
    circle(0.8, (0.3, -0.2)),
    box(1.6, 0.9),
    box(1.2, 1.0, radius=0.3),
    capsule(0.7, 0.4),
    polygon((-0.9, -0.5), (1.0, -0.6), (0.2, 0.9)),
    polygon((-0.9, -0.5), (1.0, -0.6), (0.2, 0.9), radius=0.25),
    polygon(*((math.cos(k / 32 * math.pi), math.sin(k / 32 * math.pi)) for k in range(64)), radius=0.1),
]
# Shapely loses a corner where an edge lies 1e-311 beside another, so the numbers are of a size that it can tell apart.
numbers = st.floats(-1.5, 1.5).map(lambda number: round(number, 12))


@entry_point
def measured(
    shapes: Records, vertices: Records, regions: Records, edges: Records, cosine: float, sine: float, x: float,
    y: float, pieces: Records, spare: Records,
) -> tuple[float, float, float, float]:  # fmt: skip
    count = trace(shapes[0], vertices, cosine, sine, pieces)
    found, count = cut(regions[0], edges, x, y, pieces, spare, count)
    return enclosed(found, count)


def ours(shape: FlatShape, region: FlatRegion, angle: float, x: float, y: float) -> tuple[float, ...]:
    state = world(body("it", shape, center=(0.0, 0.0), mass=1.0, inertia=1.0)).state
    regions, edges = build_regions((region,), 60.0)
    tables = (state.shapes, state.vertices, regions, edges)
    memory = (PIECE.zeros(MAX_PIECES), PIECE.zeros(MAX_PIECES))
    arguments = [kernel_argument(table) for table in tables]
    return measured(*arguments, math.cos(angle), math.sin(angle), x, y, *(kernel_argument(each) for each in memory))


def theirs(shape: FlatShape, region: FlatRegion, angle: float, x: float, y: float) -> tuple[float, ...]:
    core = np.array(shape.vertices)
    core = core @ np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    make = (shapely.Point, shapely.LineString)[len(core) - 1] if len(core) < 3 else shapely.Polygon
    seen = make(core).buffer(shape.radius, quad_segs=2000) if shape.radius else make(core)
    area = shapely.box(-100, -100, 100, 100)
    for nx, ny, offset in region.edges:
        middle = np.array([nx, ny]) * (offset - (nx * x + ny * y))
        along, back = np.array([-ny, nx]) * 300, np.array([nx, ny]) * 300
        area &= shapely.Polygon([middle - along, middle + along, middle + along - back, middle - along - back])
    if region.disc:
        area &= shapely.Point(region.disc[0] - x, region.disc[1] - y).buffer(region.disc[2], quad_segs=2000)
    return moments(seen & area)


def moments(shape: shapely.Geometry) -> tuple[float, ...]:
    if shape.is_empty or shape.area == 0.0:
        return 0.0, 0.0, 0.0, 0.0
    p = np.array(shapely.geometry.polygon.orient(shape).exterior.coords)
    a, b = p[:-1], p[1:]
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    second = cross * ((a * a).sum(1) + (a * b).sum(1) + (b * b).sum(1)) / 12
    first = (cross[:, None] * (a + b)).sum(0) / 6
    return cross.sum() / 2, *first, second.sum()


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: f"{shape.kind}-{len(shape.vertices)}-{shape.radius}")
@examples(60)
@given(st.data())
def test_any_shape_within_any_region(shape, data):
    kind = data.draw(st.sampled_from(["surface", "box", "disc", "disc and surface"]))
    edges: tuple[tuple[float, float, float], ...] = ()
    if kind == "box":
        left, bottom = data.draw(numbers), data.draw(numbers)
        edges = inside(left, bottom, left + data.draw(st.floats(0.01, 2.0)), bottom + data.draw(st.floats(0.01, 2.0)))
    elif kind != "disc":
        turn = data.draw(st.floats(-math.pi, math.pi))
        edges = ((math.cos(turn), math.sin(turn), data.draw(numbers)),)
    disc = (data.draw(numbers), data.draw(numbers), data.draw(st.floats(0.05, 2.5))) if "disc" in kind else None
    region = FlatRegion("water", edges, disc)
    place = data.draw(st.floats(-4.0, 4.0)), data.draw(numbers) * 0.3, data.draw(numbers) * 0.3
    assert ours(shape, region, *place) == pytest.approx(theirs(shape, region, *place), abs=3e-6)


def test_a_disc_within_a_shape_is_all_of_it():
    area, x, y, second = ours(box(4.0, 4.0), FlatRegion("water", (), (0.5, -0.3, 0.7)), 0.3, 0.0, 0.0)
    assert area == pytest.approx(math.pi * 0.49, rel=1e-14)
    assert (x / area, y / area) == pytest.approx((0.5, -0.3), rel=1e-14)
    assert second == pytest.approx(area * (0.49 / 2 + 0.25 + 0.09), rel=1e-14)


def test_a_line_encloses_nothing():
    assert ours(segment((-1.0, 0.0), (1.0, 0.2)), FlatRegion("water", ((0.0, 1.0, 0.0),)), 0.0, 0.0, 0.0)[0] == 0.0


def test_half_a_disc_is_exact():
    area, x, y, _ = ours(circle(1.0), FlatRegion("water", ((0.0, 1.0, 0.0),)), 0.7, 0.0, 0.0)
    assert area == pytest.approx(math.pi / 2, rel=1e-15)
    assert (x, y) == pytest.approx((0.0, -2.0 / 3.0), abs=1e-15)
