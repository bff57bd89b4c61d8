"""Pairs of shapes for the tests of this room."""

from __future__ import annotations

from hypothesis import strategies as st

from sandbox.reference.pair import Core, Pair, Point
from tests.geometry.convex_cases import Case, cases, random_cases, tied_cases


def circle(radius: float) -> Core:
    return Core(((0.0, 0.0),), radius)


def box(width: float, height: float, radius: float = 0.0) -> Core:
    x, y = 0.5 * width, 0.5 * height
    return Core(((-x, -y), (x, -y), (x, y), (-x, y)), radius)


def line(start: Point, end: Point, radius: float = 0.0) -> Core:
    return Core((start, end), radius)


def at(a: Core, b: Core, way: Point) -> Pair:
    """a at the origin, b moved by `way`."""
    return Pair(a, b, (0.0, 0.0), way)


def between(a, b) -> Pair:
    """Two public shapes as a pair, each core about the middle of its box."""
    (core_a, center_a), (core_b, center_b) = _core(a), _core(b)
    return Pair(core_a, core_b, center_a, center_b)


def _core(shape) -> tuple[Core, Point]:
    xs, ys = zip(*shape.vertices, strict=True)
    x, y = 0.5 * (min(xs) + max(xs)), 0.5 * (min(ys) + max(ys))
    return Core(tuple((px - x, py - y) for px, py in shape.vertices), shape.radius), (x, y)


def pair_of(case: Case) -> Pair:
    return at(Core(case.a, case.radius_a), Core(case.b, case.radius_b), case.way)


any_pairs: st.SearchStrategy[Pair] = cases.map(pair_of)
random_pairs: st.SearchStrategy[Pair] = random_cases.map(pair_of)
tied_pairs: st.SearchStrategy[Pair] = tied_cases.map(pair_of)
