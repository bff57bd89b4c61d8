"""Paths in the syntax of SVG: against their formulas, against mistakes, and as shapes."""

from __future__ import annotations

import json
import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.scene import PolygonShape, loads_scene
from sandbox.scene.colors import named_colors
from sandbox.scene.svg_path import PathError, outlines
from tests.examples import examples
from tests.scene.scene_helpers import one

NUMBERS = st.integers(-40, 40).map(lambda k: k / 4)


def points(text):
    ((found, _),) = outlines(text)
    return found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("M0 0L2 0L2 1Z", [(0, 0), (2, 0), (2, 1)]),
        ("m1,1 2,0 0,1 z", [(1, 1), (3, 1), (3, 2)]),
        ("M0 0 H2 V1 h-1 v.5", [(0, 0), (2, 0), (2, 1), (1, 1), (1, 1.5)]),
        ("M 0 0 1 0 1 1 0 0 Z", [(0, 0), (1, 0), (1, 1)]),
        ("M-1-1l.5.5-1e0+2", [(-1, -1), (-0.5, -0.5), (-1.5, 1.5)]),
        ("M0 0L0 0L1 1", [(0, 0), (1, 1)]),
        ("M0 0A0 1 0 0 1 2 2", [(0, 0), (2, 2)]),
        ("M0 0C1 1 2 2 3 3", [(0, 0), (3, 3)]),
    ],
)
def test_lines(text, expected):
    assert points(text) == expected


def test_each_stroke_is_one():
    found = outlines("M0 0L1 0Z m5 5 l1 0 M9 9")
    assert found == [([(0, 0), (1, 0)], True), ([(5, 5), (6, 5)], False)]


def test_a_circle_of_two_arcs():
    found = points("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")
    assert len(found) == 64
    assert max(abs(math.hypot(*point) - 1) for point in found) < 1e-15
    assert found[16] == pytest.approx((0, 1), abs=1e-15)
    assert points("M 1 0 a 1 1 0 012 0")[1:-1] == points("M 1 0 A 1 1 0 0 1 3 0")[1:-1]


def ellipse(end, radii, turn, large, sweep):
    """Center, radii, first angle and swept angle of an arc from the origin, by appendix B.2.4 of SVG 2."""
    (x, y), (rx, ry) = end, radii
    cos, sin = math.cos(turn), math.sin(turn)
    u, v = (-cos * x - sin * y) / 2, (sin * x - cos * y) / 2
    grown = (u / rx) ** 2 + (v / ry) ** 2
    if grown > 1:
        rx, ry = rx * math.sqrt(grown), ry * math.sqrt(grown)
    under = (rx * ry) ** 2 - (rx * v) ** 2 - (ry * u) ** 2
    size = math.sqrt(max(0.0, under / ((rx * v) ** 2 + (ry * u) ** 2))) * (1 if large != sweep else -1)
    cu, cv = size * rx * v / ry, -size * ry * u / rx
    first = math.atan2((v - cv) / ry, (u - cu) / rx)
    swept = (math.atan2((-v - cv) / ry, (-u - cu) / rx) - first) % (2 * math.pi)
    center = cos * cu - sin * cv + x / 2, sin * cu + cos * cv + y / 2
    return center, (rx, ry), first, swept if sweep else swept - 2 * math.pi


@given(
    st.tuples(NUMBERS, NUMBERS).filter(any), st.tuples(st.floats(0.1, 9), st.floats(0.1, 9)), st.integers(-180, 180),
    st.booleans(), st.booleans(),
)  # fmt: skip
@examples(80)
def test_arcs_are_those_of_the_standard(end, radii, turn, large, sweep):
    found = points(f"M 0 0 A {radii[0]!r} {radii[1]!r} {turn} {large:d} {sweep:d} {end[0]} {end[1]}")
    (cx, cy), (rx, ry), first, swept = ellipse(end, radii, math.radians(turn), large, sweep)
    cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    assert found[0] == (0, 0)
    assert found[-1] == end
    done, before = 0.0, first
    for x, y in found:
        u, v = (cos * (x - cx) + sin * (y - cy)) / rx, (cos * (y - cy) - sin * (x - cx)) / ry
        assert math.hypot(u, v) == pytest.approx(1, abs=1e-6)
        angle = math.atan2(v, u)
        done += (angle - before + math.pi) % (2 * math.pi) - math.pi
        before = angle
    assert done == pytest.approx(swept, abs=1e-5)


@given(st.lists(st.tuples(NUMBERS, NUMBERS), min_size=3, max_size=4, unique=True))
@examples(60)
def test_curves_leave_their_lines_by_a_five_hundredth(controls):
    letter = "Q" if len(controls) == 3 else "C"
    words = [f"{x} {y}" for x, y in controls]
    found = points(f"M {words[0]} {letter} {' '.join(words[1:])}")
    xs, ys = zip(*controls, strict=True)
    extent = max(max(xs) - min(xs), max(ys) - min(ys))
    for k in range(201):
        assert _distance(_bezier(controls, k / 200), found) <= extent / 500 + 1e-12


def _bezier(controls, t):
    level = controls
    while len(level) > 1:
        level = [(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])) for a, b in pairwise(level)]
    return level[0]


def _distance(point, line):
    return min(_to_segment(point, a, b) for a, b in pairwise([*line, line[-1]]))


def _to_segment(p, a, b):
    u = (b[0] - a[0], b[1] - a[1])
    length = u[0] ** 2 + u[1] ** 2
    t = max(0.0, min(1.0, ((p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1]) / length)) if length else 0.0
    return math.dist(p, (a[0] + t * u[0], a[1] + t * u[1]))


def test_smooth_curves_go_on():
    long = points("M0 0 C 0 1 1 1 1 0 C 1 -1 2 -1 2 0")
    assert points("M0 0 C 0 1 1 1 1 0 S 2 -1 2 0") == long
    assert points("m0 0 c 0 1 1 1 1 0 s 1 -1 1 0") == long
    assert points("M0 0 Q 1 1 2 0 T 4 0") == points("M0 0 Q 1 1 2 0 Q 3 -1 4 0")


@given(st.text("MmLlHhVvCcSsQqTtAaZz0123456789.-+eE, \n", max_size=60))
@examples(200)
def test_whatever_is_drawn(text):
    try:
        found, span = outlines("M0 0" + text), (0, 1)
    except PathError as error:
        found, span = [], error.span
    assert 0 <= span[0] < span[1]
    assert all(math.isfinite(x) and math.isfinite(y) for stroke, _ in found for x, y in stroke)


def shape(words: str) -> str:
    return '{"bodies": [{"id": "it", "type": "static", "shapes": [{' + words + "}]}]}"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ('"polygon": "@L 0 0 L 1 0"', "a stroke begins with M"),
        ('"polygon": "M 0 0 L 1 @X"', "a number is due here"),
        ('"polygon": "M 0 0 @B 1 1"', '"B" is no command of a path'),
        ('"polygon": @"\\u0001"', '"?" is no command of a path'),
        ('"polygon": "M 0 0 A 1 1 0 @2 0 1 1"', "0 or 1 is due here"),
        ('"polygon": "@M 0 0 L 1 1 Z L 2 2"', "the path has 2 strokes, and this is one outline"),
        ('"polygon": "M 0 0 L @1e99 1"', "the number is too large"),
        ('"polygon": "@M 0 0 L 1 0 L 1 1 Z M 5 5 L 6 6"', "the path has 2 strokes, and this is one outline"),
                ('"polygon": @"M 0 0 L 1 1 L 0 1 L 1 0 Z"', "the polygon intersects itself"),
        ('"chain": "M 0 0 L 1 0 L 1 1 @Z"', 'a chain is closed by "closed": true, not by Z'),
        ('"chain": "@M 0 0"', "the path draws nothing"),
        ('"polygon": "M 0 0 L 9 0 L 9 9 Z", "holes": ["M 3 1 L 4 1 L 4@ "]', "a number is due here"),
    ],
)  # fmt: skip
def test_mistakes_are_told_where_they_are(words, said):
    before, after = shape(words).split("@")
    assert one(before + after) == f"1:{len(before) + 1}: {said}"


def test_paths_that_are_too_long_are_refused():
    for path in ("M0 0" + "L1 1L2 2" * 600, "M0 0" + "h1" * 60_000):
        with pytest.raises(SceneError, match=r"(more than 1000 points|at most 100,000 characters)"):
            loads_scene(shape(f'"chain": "{path}"'))


def test_shapes_from_python_take_paths():
    found = PolygonShape(polygon="M 0 0 H 2 V 1 Z")
    assert found.polygon == ((0, 0), (2, 0), (2, 1))
    assert found.to_data() == {"polygon": [[0, 0], [2, 0], [2, 1]]}


def test_colours_have_names():
    names = named_colors()
    assert len(names) == 148
    assert names["tomato"] == "#ff6347"
    words = {"bodies": [{"id": "a", "color": "tomato", "shapes": [{"circle": 1}]}]}
    scene = loads_scene(json.dumps(words))
    assert scene.flatten().bodies[0].color == "#ff6347"
    assert scene.to_data()["bodies"][0]["color"] == "tomato"
