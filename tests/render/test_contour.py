from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.contour import TOLERANCE_PIXELS, clip, contour, inset, shape_contour

SQUARE = np.array([[-10.0, -10.0], [10.0, -10.0], [10.0, 10.0], [-10.0, 10.0]])


def regular(n: int, size: float) -> np.ndarray:
    angle = 2 * np.pi * np.arange(n) / n
    return size * np.column_stack([np.cos(angle), np.sin(angle)])


def area(polygon: np.ndarray) -> float:
    x, y = polygon.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


def edge_distance(core: np.ndarray, point: np.ndarray) -> float:
    a, b = core, np.roll(core, -1, axis=0)
    along, to = b - a, point - a
    length = np.maximum((along**2).sum(axis=1), 1e-30)
    t = np.clip((to * along).sum(axis=1) / length, 0, 1)
    return float(np.hypot(*(to - along * t[:, None]).T).min())


@given(st.integers(1, 12), st.floats(5, 200), st.floats(0.5, 100))
def test_contour_points_lie_at_the_radius(n: int, size: float, radius: float) -> None:
    core = regular(n, size)
    for point in contour(core, radius):
        assert edge_distance(core, point) == pytest.approx(radius, abs=1e-6)


@given(st.integers(1, 12), st.floats(5, 200), st.floats(0.5, 100))
def test_contour_has_the_area_of_the_rounded_shape(n: int, size: float, radius: float) -> None:
    core = regular(n, size)
    around = float(np.hypot(*(np.roll(core, -1, axis=0) - core).T).sum())
    exact = (area(core) if n > 2 else 0.0) + around * radius + np.pi * radius**2
    lost = (around + 2 * np.pi * radius) * TOLERANCE_PIXELS
    assert exact - lost <= area(contour(core, radius)) <= exact + 1e-6


@given(st.integers(3, 20), st.floats(20, 200), st.floats(0.1, 5))
def test_inset_moves_every_edge_inwards_by_the_distance(n: int, size: float, by: float) -> None:
    inner = inset(regular(n, size), by)
    apothem = size * np.cos(np.pi / n)
    expected = apothem - by
    middles = (inner + np.roll(inner, -1, axis=0)) / 2
    assert np.hypot(*middles.T) == pytest.approx(np.full(n, expected), rel=1e-9)


def test_shrinking_takes_the_rounding_first() -> None:
    assert area(shape_contour(SQUARE, 3.0, 3.0)) == pytest.approx(400.0, rel=1e-2)
    assert area(shape_contour(SQUARE, 3.0, 4.0)) == pytest.approx(18.0**2)


@given(
    st.tuples(st.floats(-30, 30), st.floats(-30, 30)),
    st.floats(-25, 25),
    st.floats(-25, 25),
    st.tuples(st.floats(-40, 40), st.floats(-40, 40)),
)
def test_clipped_polygon_is_the_intersection(
    middle: tuple[float, float], x: float, y: float, size: tuple[float, float]
) -> None:
    polygon = regular(7, 20.0) + middle
    high = (x + abs(size[0]), y + abs(size[1]))
    part = clip(polygon, (x, y), high)
    assert (part >= np.array([x, y]) - 1e-9).all()
    assert (part <= np.array(high) + 1e-9).all()
    cells = 60
    grid_x = x + (np.arange(cells) + 0.5) * (high[0] - x) / cells
    grid_y = y + (np.arange(cells) + 0.5) * (high[1] - y) / cells
    points = np.stack(np.meshgrid(grid_x, grid_y), axis=-1).reshape(-1, 2)
    edge = np.roll(polygon, -1, axis=0) - polygon
    to = points[:, None] - polygon[None]
    inside = (edge[None, :, 0] * to[:, :, 1] - edge[None, :, 1] * to[:, :, 0] >= 0).all(axis=1)
    exact = inside.mean() * (high[0] - x) * (high[1] - y)
    rim = 2 * (high[0] - x + high[1] - y) * max(high[0] - x, high[1] - y) / cells
    assert (area(part) if len(part) else 0.0) == pytest.approx(exact, abs=rim + 1e-9)
