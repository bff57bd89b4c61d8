from __future__ import annotations

import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.camera import Camera
from sandbox.render.grid import MINOR_PIXELS, grid_lines, spacing


@given(st.floats(1e-6, 1e6))
def test_spacing_is_round_and_just_wide_enough(scale: float) -> None:
    step = spacing(scale)
    mantissa = step / 10 ** math.floor(math.log10(step) + 1e-9)
    assert min(abs(mantissa - k) for k in (1, 2, 5)) < 1e-9
    assert step * scale * (1 + 1e-9) >= MINOR_PIXELS
    assert step * scale <= 2.5 * MINOR_PIXELS * (1 + 1e-9)


@given(st.floats(-1e5, 1e5), st.floats(-1e5, 1e5), st.floats(1e-2, 1e4))
def test_lines_are_few_inside_the_window_and_evenly_spaced(x: float, y: float, scale: float) -> None:
    camera = Camera((x, y), scale, (1280, 800))
    lines = grid_lines(camera)
    columns = sorted(line.pixel for line in lines if line.vertical)
    assert 0 < len(lines) < 80
    assert columns[0] >= -1.0
    assert columns[-1] <= 1281.0
    gaps = [b - a for a, b in itertools.pairwise(columns)]
    assert gaps == pytest.approx([spacing(scale) * scale] * len(gaps), rel=1e-3)


def test_the_axes_stand_out() -> None:
    lines = grid_lines(Camera((0.0, 0.0), 50.0, (1000, 800)))
    axes = [(line.vertical, line.pixel) for line in lines if line.rank == 2]
    assert axes == [(True, 500.0), (False, 400.0)]


@pytest.mark.parametrize(("scale", "minor", "major"), [(40.0, 1.0, 5.0), (20.0, 2.0, 10.0), (8.0, 5.0, 10.0)])
def test_major_lines_are_round_too(scale: float, minor: float, major: float) -> None:
    assert spacing(scale) == minor
    lines = grid_lines(Camera((0.0, 0.0), scale, (1280, 800)))
    columns = sorted(line.pixel for line in lines if line.vertical and line.rank > 0)
    assert [b - a for a, b in itertools.pairwise(columns)] == pytest.approx([major * scale] * (len(columns) - 1))
