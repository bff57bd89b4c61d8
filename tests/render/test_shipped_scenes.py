"""Every scene that comes with the package can be drawn, and each of its shapes is where its corners say."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import scene_camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.surface_painter import SurfacePainter
from sandbox.world.records import SEGMENT
from tests.shipped import FILES, shipped

SIZE = (240, 135)


@pytest.mark.parametrize("name", sorted(FILES))
def test_it_is_drawn(name: str) -> None:
    scene = shipped(name)
    world = World(scene)
    frame = capture(world.state)
    camera = scene_camera(scene.view, interesting_bounds(frame), SIZE)
    picture = SurfacePainter().paint(build_draw_list(frame, camera, body_colors_of(world.state)))
    assert len(picture.getcolors(SIZE[0] * SIZE[1]) or ()) > 2


@pytest.mark.parametrize("name", ["pinball", "rolling-hills", "roller-coaster", "rube-goldberg"])
def test_each_link_of_a_chain_is_drawn_where_it_is(name: str) -> None:
    state = World(shipped(name)).state
    frame = capture(state)
    links, rows = np.flatnonzero(state.shapes.kind == SEGMENT), np.flatnonzero(frame.mesh.kind == SEGMENT)
    assert len(rows) == len(links) > 10
    origin, axis = frame.shape_poses()
    for link, row in zip(state.shapes[links], rows.tolist(), strict=True):
        body, ends = state.bodies[link.body], state.vertices[link.vertex_start : link.vertex_start + 2]
        center, turn = [body.center_x, body.center_y], (body.rotation_cos, body.rotation_sin)
        corners = np.array(center) + rotated(ends.x, ends.y, *turn)
        drawn = origin[row] + rotated(*frame.mesh.core(row).T, *axis[row])
        assert np.abs(np.sort(drawn, axis=0) - np.sort(corners, axis=0)).max() < 1e-12


def rotated(x: np.ndarray, y: np.ndarray, cos: float, sin: float) -> np.ndarray:
    """Points turned: (n, 2)."""
    return np.column_stack([cos * x - sin * y, sin * x + cos * y])
