"""Path data of SVG: every command, numbers however they are written, curves within the tolerance."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.svg_path import flat_path

Vec = tuple[float, float]


def points(text: str, tolerance: float = 0.01) -> list[Vec]:
    (subpath,) = flat_path(text, tolerance).subpaths
    return subpath.points


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("M1 2L3 4", [(1, 2), (3, 4)]),
        ("m1,2 3,4 5,6", [(1, 2), (4, 6), (9, 12)]),
        ("M0 0H5V6h-1v-1", [(0, 0), (5, 0), (5, 6), (4, 6), (4, 5)]),
        ("M.5.5-1-1e0", [(0.5, 0.5), (-1, -1)]),
        (" M 0 0 L 1 0 M 5 5", [(0, 0), (1, 0)]),
    ],
)
def test_lines(text: str, wanted: list[Vec]) -> None:
    assert points(text) == wanted


def test_a_subpath_after_a_closed_one_begins_where_that_did() -> None:
    first, second = flat_path("M1 1h2v2zl-1 0", 0.1).subpaths
    assert (first.closed, second.closed) == (True, False)
    assert second.points == [(1, 1), (0, 1)]


@pytest.mark.parametrize(
    ("text", "curve"),
    [
        ("M0 0C0 10 10 10 10 0", lambda t: (30 * t**2 * (1 - t) + 10 * t**3, 30 * t * (1 - t))),
        ("M0 0Q5 10 10 0", lambda t: (10 * t, 20 * t * (1 - t))),
        ("M0 0A5 5 0 0 1 10 0", lambda t: (5 - 5 * math.cos(math.pi * t), -5 * math.sin(math.pi * t))),
    ],
)
def test_curves_stay_within_the_tolerance(text: str, curve: object) -> None:
    for tolerance in (1.0, 0.1, 0.001):
        sides = points(text, tolerance)
        for k in range(101):
            assert distance(curve(k / 100), sides) <= tolerance * 1.001  # type: ignore[operator]
    assert len(points(text, 1.0)) < 12


def distance(point: Vec, line: list[Vec]) -> float:
    return min(to_side(point, a, b) for a, b in pairwise(line))


def to_side(point: Vec, a: Vec, b: Vec) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(1.0, max(0.0, t))
    return math.dist(point, (a[0] + t * dx, a[1] + t * dy))


def test_smooth_curves_go_on_as_the_one_before() -> None:
    assert points("M0 0C0 5 5 5 5 0S10-5 10 0") == points("M0 0C0 5 5 5 5 0C5-5 10-5 10 0")
    assert points("M0 0Q5 5 10 0T20 0") == points("M0 0Q5 5 10 0Q15-5 20 0")
    assert points("M0 0L5 0S10 5 10 0") == points("M0 0L5 0C5 0 10 5 10 0")


@pytest.mark.parametrize(("flags", "middle"), [("0 1", (5, -5)), ("0 0", (5, 5))])
def test_the_sweep_of_half_circles(flags: str, middle: Vec) -> None:
    assert min(math.dist(point, middle) for point in points(f"M0 0A5 5 0 {flags} 10 0")) < 0.5


def test_arcs_with_flags_written_together_and_radii_too_small() -> None:
    assert points("M0 0a5 5 0 0110 0") == points("M0 0A5 5 0 0 1 10 0")
    assert points("M0 0A1 1 0 0 1 10 0") == points("M0 0A5 5 0 0 1 10 0")
    assert points("M0 0A0 5 0 0 1 10 0") == [(0, 0), (10, 0)]


@pytest.mark.parametrize(
    ("text", "fault", "at"),
    [("M0 0L5", "a number is due here", 6), ("M0 0X", '"X" is no command of a path', 4),
     ("z5 5", "a command is due", 1), ("M0 0A5 5 0 2 1 9 9", "a number is due here", 11),
     ("M0 0L1e999 0", "a number is too large", 12)],
)  # fmt: skip
def test_a_path_is_good_up_to_its_first_mistake(text: str, fault: str, at: int) -> None:
    path = flat_path("M0 0L1 1" + text, 0.1)
    assert path.fault.startswith(fault)
    assert path.at == at + 8
    assert path.subpaths[0].points == [(0, 0), (1, 1)]


@given(st.text(alphabet="MmLlHhVvCcSsQqTtAaZz0123456789 .,-+eE", max_size=60), st.floats(1e-9, 1e3))
def test_any_text_ends(text: str, tolerance: float) -> None:
    for subpath in flat_path(text, tolerance).subpaths:
        assert len(subpath.points) > 1
