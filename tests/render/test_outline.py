"""Concave polygons are drawn and picked as one shape: painted parts, one outline, empty holes."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.body_colors import choose_colors, frame_colors
from sandbox.render.camera import Camera, fit
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.pick import pick
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.theme import DARK
from sandbox.world.state import State
from tests.render.naive import topmost
from tests.render.stages import letters
from tests.render.test_surface_painter import check_pixels

STATE = letters()
FRAME = capture(STATE)
SIZE = (960, 420)


def world_outlines(state: State) -> list[shapely.Polygon]:
    """One polygon for each body, joined from its convex cores."""
    found = []
    for k, body in enumerate(state.bodies):
        turn = np.array([[body.rotation_cos, -body.rotation_sin], [body.rotation_sin, body.rotation_cos]])
        cores = []
        for row in state.shapes[state.shapes.body == k]:
            rows = state.vertices[row.vertex_start : row.vertex_start + row.vertex_count]
            corners = np.column_stack([rows.x, rows.y]) @ turn.T + (body.center_x, body.center_y)
            cores.append(shapely.Polygon(corners).buffer(1e-9, join_style="mitre"))
        found.append(shapely.union_all(cores))
    return found


def test_a_concave_polygon_is_one_row_of_the_mesh() -> None:
    mesh = FRAME.mesh
    assert mesh.body.tolist() == [0, 1, 2, 3]
    assert (mesh.count < 0).all()
    assert sorted(mesh.outlines) == [0, 1, 2, 3]
    assert mesh.count.tolist() == [-6, -8, -52, -11]


def test_sides_of_the_mesh_are_those_of_the_cores_together() -> None:
    origin, axis = FRAME.shape_poses()
    for k, whole in enumerate(world_outlines(STATE)):
        (c, s), sides = axis[k], FRAME.mesh.outlines[k].sides
        turned = sides @ np.array([[c, s], [-s, c]]) + origin[k]
        drawn = shapely.union_all(shapely.linestrings(turned))
        assert drawn.hausdorff_distance(whole.boundary) < 1e-7
        lone = FRAME.mesh.points[FRAME.mesh.start[k] :][: -2 * FRAME.mesh.count[k]]
        assert (lone == sides.reshape(-1, 2)).all()


@given(st.floats(-7, 6), st.floats(-2, 4))
def test_pick_knows_holes_and_dents(x: float, y: float) -> None:
    assert pick(FRAME, (x, y)) == topmost(STATE, x, y)


@given(st.floats(-7, 6), st.floats(-2, 4))
def test_the_distance_from_an_outline_is_shapelys(x: float, y: float) -> None:
    origin, axis = FRAME.shape_poses()
    for k, whole in enumerate(world_outlines(STATE)):
        dx, dy = x - origin[k, 0], y - origin[k, 1]
        c, s = axis[k]
        point = shapely.Point(x, y)
        expected = whole.boundary.distance(point) * (-1 if whole.contains(point) else 1)
        found = FRAME.mesh.outlines[k].distance(np.array([c * dx + s * dy, c * dy - s * dx]))
        assert abs(found - expected) < 1e-7


def test_pixels_are_painted_where_the_parts_are_and_holes_are_empty() -> None:
    check_pixels(STATE, fit(interesting_bounds(FRAME), SIZE))


def test_large_ones_are_cut_to_the_window() -> None:
    check_pixels(STATE, Camera((1.0, 0.5), 700.0, SIZE))


@pytest.mark.slow
def test_no_line_is_drawn_where_parts_meet() -> None:
    state = letters("kinematic")
    state.bodies.frozen_step = -1
    frame, body_colors = capture(state), choose_colors(state.names, state.bodies.type, DARK)
    camera = fit(interesting_bounds(frame), SIZE)
    picture = np.asarray(SurfacePainter().paint(build_draw_list(frame, camera, body_colors, depth=False))).astype(float)
    fill = frame_colors(frame, body_colors).fill * 255
    seen = 0
    pixels = np.array([(row, column) for row in range(0, SIZE[1], 2) for column in range(0, SIZE[0], 2)])
    x, y = np.array([camera.point((column + 0.5, row + 0.5)) for row, column in pixels.tolist()]).T
    for k, whole in enumerate(world_outlines(state)):
        rows, columns = pixels[shapely.contains_xy(whole.buffer(-3.0 / camera.scale), x, y)].T
        assert np.abs(picture[rows, columns] - fill[k]).max() <= 1.0
        seen += len(rows)
    assert seen > 1000


def test_strips_lie_along_the_sides_within_the_polygon() -> None:
    for k, whole in enumerate(FRAME.mesh.outlines.values()):
        solid = shapely.union_all([shapely.Polygon(part).buffer(1e-9, join_style="mitre") for part in whole.parts])
        strips = shapely.union_all([shapely.Polygon(strip) for strip in whole.strips(0.05)])
        band = solid.difference(solid.buffer(-0.05))
        assert strips.within(solid.buffer(1e-6)), k
        assert band.difference(strips).area < 1e-2 * band.area
        assert strips.difference(band).area < 1e-2 * band.area
