"""A concave body: its mass in closed form, one outline to pick and drag, and the same again from a file or snapshot."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import MoveDrag, StartDrag
from sandbox.render.frame import capture
from sandbox.render.pick import pick
from tests.examples import examples
from tests.geometry.concave_cases import simple, with_holes
from tests.geometry.test_decompose import gear

SQUARE = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
WINDOW = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def world(outline, holes=(), **fields) -> sandbox.World:
    """One dynamic body of one polygon."""
    shape = {"polygon": outline, "holes": holes, "density": 3}
    return sandbox.World(sandbox.Scene(bodies=[{"id": "it", "shapes": [shape], **fields}], gravity=(0, 0)))


def exact_moments(rings) -> tuple[float, float, float, float]:
    """(area, centroid x, y, second moment about the centroid) by Green's theorem, in fractions; holes subtract."""
    area = mx = my = second = Fraction(0)
    for k, ring in enumerate(rings):
        points = [(Fraction(x), Fraction(y)) for x, y in ring]
        a = x1 = y1 = s = Fraction(0)
        for (px, py), (qx, qy) in zip(points, [*points[1:], points[0]], strict=True):
            cross = px * qy - qx * py
            a += cross / 2
            x1 += cross * (px + qx) / 6
            y1 += cross * (py + qy) / 6
            s += cross * (px * px + px * qx + qx * qx + py * py + py * qy + qy * qy) / 12
        sign = (1 if a > 0 else -1) * (-1 if k else 1)
        area, mx, my, second = area + sign * a, mx + sign * x1, my + sign * y1, second + sign * s
    cx, cy = mx / area, my / area
    return float(area), float(cx), float(cy), float(second - area * (cx * cx + cy * cy))


@examples(60)
@given(with_holes())
def test_mass_centroid_and_inertia_are_those_of_the_whole(polygon):
    outline, holes = polygon
    area, x, y, second = exact_moments([outline, *holes])
    row = world(outline, holes).state.bodies[0]
    size = max(max(abs(u), abs(v)) for u, v in outline)
    assert row.mass == pytest.approx(3 * area, rel=1e-9)
    assert (row.local_center_x, row.local_center_y) == pytest.approx((x, y), abs=1e-9 * size)
    assert row.inertia == pytest.approx(3 * second, rel=1e-7)


def test_a_frame_in_closed_form():
    row = world(SQUARE, [WINDOW]).state.bodies[0]
    assert row.mass == pytest.approx(3 * (16 - 4), rel=1e-15)
    assert row.inertia == pytest.approx(3 * (4**4 - 2**4) / 6, rel=1e-14)
    assert (row.local_center_x, row.local_center_y) == pytest.approx((0, 0), abs=1e-15)


def test_it_is_picked_on_its_parts_and_not_in_its_hole():
    frame = capture(world(SQUARE, [WINDOW], position=(10, 5), angle=45).state)
    root = math.sqrt(0.5)
    assert pick(frame, (10 + 1.5 * root, 5 + 1.5 * root)) == 0
    assert pick(frame, (10, 5)) is None
    assert pick(frame, (10, 5 + 0.9 * root)) is None


def test_it_is_dragged_as_one_body():
    w = world(SQUARE, [WINDOW])
    w.apply(StartDrag("it", (1.5, 1.5)))
    w.apply(MoveDrag("it", (4.5, 3.5)))
    w.step(400)
    row = w.state.bodies[0]
    held = (row.rotation_cos * 1.5 - row.rotation_sin * 1.5, row.rotation_sin * 1.5 + row.rotation_cos * 1.5)
    assert (row.center_x + held[0], row.center_y + held[1]) == pytest.approx((4.5, 3.5), abs=0.01)


@examples(40)
@given(simple, st.integers(0, 20))
def test_a_saved_scene_has_the_vertices_of_its_author(outline, turn):
    turned = [*outline[turn % len(outline) :], *outline[: turn % len(outline)]][:: -1 if turn % 2 else 1]
    scene = sandbox.Scene(bodies=[{"id": "it", "shapes": [{"polygon": turned}]}])
    with TemporaryDirectory() as folder:
        scene.save(Path(folder) / "it.scene.json")
        again = sandbox.load_scene(Path(folder) / "it.scene.json")
    assert [tuple(vertex) for vertex in again.bodies[0].shapes[0].polygon] == [tuple(v) for v in turned]
    assert again == scene


def test_saved_and_loaded_and_restored(tmp_path):
    bodies = [
        {"id": "ground", "type": "static", "shapes": [{"polygon": [(-9, 1), (-9, -1), (9, -1), (9, 1), (0, 0)]}]},
        {"id": "frame", "shapes": [{"polygon": SQUARE[::-1], "holes": [WINDOW]}], "position": (1, 4), "angle": 20},
        {"id": "gear", "shapes": [{"polygon": gear(9)}], "position": (-3, 5)},
    ]
    scene = sandbox.Scene(bodies=bodies)
    scene.save(tmp_path / "it.scene.json")
    loaded = sandbox.load_scene(tmp_path / "it.scene.json")
    assert loaded == scene
    assert loaded.bodies[1].shapes[0].polygon == tuple((float(x), float(y)) for x, y in SQUARE[::-1])
    w, twin = sandbox.World(scene), sandbox.World(loaded)
    w.step(90)
    saved = w.snapshot()
    w.step(60)
    twin.restore(saved)
    assert twin.snapshot() == saved
    twin.step(60)
    assert twin.digest() == w.digest()
    assert len(w.contacts) > 0
