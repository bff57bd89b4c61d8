from __future__ import annotations

import numpy as np
import pytest

from sandbox.errors import ArgumentError
from sandbox.geometry.sat_table import sat_table
from sandbox.render.camera import Camera
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.registry import find_overlay
from sandbox.render.strokes import Strokes
from tests.render.overlays.looks import SIZE, crate, look_at, words, world_of

CAMERA = Camera((0.5, 0.5), 60.0, SIZE)


def pair(x: float, y: float, angle: float = 0.0) -> Look:
    return look_at(world_of(crate("a:1", 0, 0), crate("b", x, y, angle=angle), gravity=[0, 0]), CAMERA)


def bars(strokes: Strokes, color: tuple[float, float, float], width: float) -> np.ndarray:
    """Both ends (k, 2, 2) of the strokes of a colour and width."""
    own = (strokes.color == color).all(axis=1) & (strokes.width == width)
    return np.stack([strokes.start[own], strokes.end[own]], axis=1)


@pytest.mark.parametrize(("x", "y", "angle"), [(1.6, 0.1, 0), (0.8, 0.2, 0), (1.3, 1.2, 45), (0.2, 0.9, 20)])
def test_intervals_and_the_bar_between_them_are_those_of_the_table(x: float, y: float, angle: float) -> None:
    look = pair(x, y, angle)
    a, b = (look.world.body(name).shapes[0] for name in ("a:1", "b"))
    table = sat_table(a, b)
    row = table.stopped or table.mtv_row
    assert row is not None
    marks = find_overlay("sat:a:1:b", look.world.names).draw(look)
    unit = np.array(row.axis) / row.length
    spans = []
    for color, low, high in ((look.palette.blue, row.amin, row.amax), (look.palette.orange, row.bmin, row.bmax)):
        (ends,) = bars(marks.strokes, color, 6.0)
        span = np.sort(CAMERA.to_world(ends) @ unit)
        assert span == pytest.approx(np.array([low, high]) / row.length, abs=1e-9)
        assert ends[1] - ends[0] == pytest.approx((high - low) / row.length * CAMERA.scale * unit * (1, -1), abs=1e-6)
        spans.append(span)
    ink = look.palette.green if row.gap else look.palette.red
    (between,) = bars(marks.strokes, ink, 3.0)
    assert np.hypot(*(between[1] - between[0])) == pytest.approx(abs(row.separation) * CAMERA.scale, abs=1e-6)
    assert len(words([marks])) == 1


def test_the_arrow_is_the_minimum_translation_vector() -> None:
    look = pair(0.7, 0.1)
    strokes = find_overlay("sat:a:1:b", look.world.names).draw(look).strokes
    own = bars(strokes, look.palette.purple, 2.6)
    shaft = max(own, key=lambda ends: float(np.hypot(*(ends[1] - ends[0]))))
    assert shaft[1] - shaft[0] == pytest.approx((0.3 * CAMERA.scale, 0.0), abs=1e-6)
    assert shaft[0] == pytest.approx(CAMERA.to_screen((0.7, 0.1)))


def test_a_way_out_that_is_too_short_to_see_is_told() -> None:
    legend = [entry.text for entry in find_overlay("sat:a:1:b", ["a:1", "b"]).draw(pair(0.999, 0.0)).legend]
    assert "way out 1 mm" in legend[2]
    assert "too short to see" in legend[3]


def test_ids_may_have_colons_and_a_body_that_is_gone_is_not_drawn() -> None:
    look = pair(0.7, 0.1)
    overlay = find_overlay("sat:a:1:b", look.world.names)
    assert overlay.name == "sat:a:1:b"
    look.world.delete("b")
    assert len(overlay.draw(look_at(look.world)).strokes) == 0
    with pytest.raises(ArgumentError, match='did you mean "a:1"'):
        find_overlay("sat:b:a:2", ("a:1", "b"))
