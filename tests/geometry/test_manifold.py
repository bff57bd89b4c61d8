"""The contact manifold: verdict, depth, axis, points and feature ids, against exact arithmetic."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, example, given

from tests.examples import examples
from tests.geometry.convex_cases import Case, box, cases, random_cases, tied_cases
from tests.naive import convex

TINY = 1e-9
SLOP = 1e-3
"""Rounded cores that meet face to face may be off by this (m): two points of a face beat one exact corner."""


def truth(case: Case) -> float:
    """Exact separation of the rounded shapes."""
    cores = convex.separation(convex.exact(case.a), convex.exact(case.b, *case.way))
    return cores - case.radius_a - case.radius_b


def cores_apart(case: Case) -> float:
    """Exact signed separation of the cores alone."""
    return convex.separation(convex.exact(case.a), convex.exact(case.b, *case.way))


def points_of(m) -> list[tuple[float, float, float, int]]:
    """(x, y, gap, feature) of each point."""
    both = [(m.x1, m.y1, m.separation1, m.feature1), (m.x2, m.y2, m.separation2, m.feature2)]
    return [(float(x), float(y), float(gap), int(feature)) for x, y, gap, feature in both[: int(m.point_count)]]


@given(cases)
@examples(400)
@example(Case(((-0.5, 0.0), (0.5, 0.0)), ((-0.5, 0.0), (0.5, 0.0)), (1.515, 0.0), 0.25, 0.25))
@example(Case(((0.0, 0.0),), ((-0.5, 0.0), (0.5, 0.0)), (1.6, 0.0), 0.5, 0.5))
def test_shapes_touch_exactly_when_they_overlap(case):
    depth = truth(case)
    assume(abs(depth) > TINY)
    _, count = case.collide(0.0)
    if depth < 0.0:
        assert count > 0
    if depth > SLOP or (depth > 0.0 and (case.radius_a + case.radius_b) == 0.0):
        assert count == 0


@given(cases)
@examples(400)
@example(Case(((-0.5, 0.0), (0.5, 0.0)), ((-0.5, 0.0), (0.5, 0.0)), (1.2, 0.0), 0.25, 0.25))
def test_the_depth_is_the_least_over_all_axes(case):
    depth = truth(case)
    assume(depth < -TINY)
    m, _ = case.collide(0.0)
    rounded = cores_apart(case) > 0.0
    assert m.separation == pytest.approx(depth, abs=SLOP if rounded else TINY)
    assert m.separation <= depth + TINY


@given(random_cases)
def test_looking_ahead_never_overrates_the_gap(case):
    gap = truth(case)
    assume(0.0 < gap < 0.99)
    m, count = case.collide(1.0)
    if count:
        assert m.separation <= gap + TINY
        if m.axis_owner == 2:
            assert m.separation == pytest.approx(gap, abs=TINY)
    if case.radius_a + case.radius_b > 0.0 and len(case.a) + len(case.b) < 5:
        assert count, "round things have no corner to look past"


@given(cases)
@examples(300)
def test_the_translation_parts_the_shapes_and_no_farther(case):
    assume(truth(case) < -TINY)
    m, _ = case.collide(0.0)
    assert math.hypot(m.normal_x, m.normal_y) == pytest.approx(1.0, abs=1e-12)
    way = case.way[0] - m.separation * m.normal_x, case.way[1] - m.separation * m.normal_y
    left = truth(Case(case.a, case.b, way, case.radius_a, case.radius_b))
    assert left == pytest.approx(0.0, abs=SLOP if cores_apart(case) > 0.0 else TINY)


@given(cases)
@examples(400)
def test_every_point_lies_half_way_between_the_surfaces(case):
    m, count = case.collide(0.5)
    a, b = convex.exact(case.a), convex.exact(case.b, *case.way)
    n = (m.normal_x, m.normal_y)
    for x, y, gap, _ in points_of(m)[:count]:
        # Along the normal, half the gap and the radius away, lie the two cores.
        on_a = (x - n[0] * (0.5 * gap + case.radius_a), y - n[1] * (0.5 * gap + case.radius_a))
        on_b = (x + n[0] * (0.5 * gap + case.radius_b), y + n[1] * (0.5 * gap + case.radius_b))
        off_a = convex.root(convex.square_to_boundary(convex.exact([on_a])[0], a))
        off_b = convex.root(convex.square_to_boundary(convex.exact([on_b])[0], b))
        reference, incident = (off_a, off_b) if m.axis_owner != 1 else (off_b, off_a)
        assert incident < TINY
        if m.axis_owner == 2 or count == 2:
            assert reference < TINY


@given(cases)
@examples(300)
def test_features_name_vertices_at_the_points(case):
    m, count = case.collide(0.5)
    points = points_of(m)[:count]
    ids = [p[3] for p in points]
    assert len(set(ids)) == len(ids)
    for feature in ids:
        i, j = divmod(feature, 64)
        assert 0 <= i < len(case.a)
        assert 0 <= j < len(case.b)
        owner, vertex, total = (j, i, len(case.b)) if m.axis_owner == 1 else (i, j, len(case.a))
        assert vertex >= 0
        if m.axis_owner < 2:
            assert owner in (m.axis_edge, (m.axis_edge + 1) % total)


@given(cases)
@examples(300)
def test_two_points_have_the_depth_of_the_manifold_between_them(case):
    m, count = case.collide(0.5)
    for _, _, gap, _ in points_of(m)[:count]:
        assert gap >= m.separation - TINY
        assert gap <= 0.5 + TINY


@given(cases)
@examples(400)
def test_swapping_the_shapes_mirrors_the_manifold(case):
    m, count = case.collide(0.5)
    n, other = case.swapped().collide(0.5)
    assert bool(count) == bool(other)
    if not count:
        return
    assert n.separation == pytest.approx(m.separation, abs=TINY)
    if m.axis_owner == 2 or n.axis_owner == 2 or best_two_axes_differ(case):
        if abs(cores_apart(case)) < 1e-9 and len(case.a) <= 2 and len(case.b) <= 2:
            return  # Points and lines on each other have no best axis: one is taken.
        assert (n.normal_x, n.normal_y) == pytest.approx((-m.normal_x, -m.normal_y), abs=1e-6)
        assert other == count
        mine = sorted((p[3], p[0], p[1], p[2]) for p in points_of(m))
        theirs = sorted(
            (64 * (p[3] % 64) + p[3] // 64, p[0] + case.way[0], p[1] + case.way[1], p[2]) for p in points_of(n)
        )
        assert [p[0] for p in mine] == [p[0] for p in theirs]
        for p, q in zip(mine, theirs, strict=True):
            assert p[1:] == pytest.approx(q[1:], abs=1e-6)


def best_two_axes_differ(case: Case) -> bool:
    """Whether one axis is clearly the best: with a tie, either order may take its own."""
    a, b = convex.exact(case.a), convex.exact(case.b, *case.way)
    lengths = sorted((axis.length() for axis in convex.face_axes(a, b) + convex.face_axes(b, a)), reverse=True)
    return len(lengths) < 2 or lengths[0] - lengths[1] > 1e-6


@given(tied_cases)
@examples(200)
def test_far_from_the_centre_nothing_changes(case):
    """Cores are measured from their bodies' centres: shifting both by whole metres is exact."""
    shifted = Case(
        tuple((x + 1024.0, y - 512.0) for x, y in case.a),
        tuple((x + 2048.0, y + 256.0) for x, y in case.b),
        (case.way[0] - 1024.0, case.way[1] - 768.0),
        case.radius_a,
        case.radius_b,
    )
    m, count = case.collide(0.25)
    n, other = shifted.collide(0.25)
    assert other == count
    if count:
        assert n.separation == pytest.approx(m.separation, abs=1e-12)
        assert (n.normal_x, n.normal_y) == pytest.approx((m.normal_x, m.normal_y), abs=1e-9)
        assert [p[3] for p in points_of(n)] == [p[3] for p in points_of(m)]


@pytest.mark.parametrize("radius", [0.0, 0.1])
@pytest.mark.parametrize("shift", [0.0, 0.3, -0.3, 1e-12, 1e-7])
def test_a_box_flat_on_a_box_has_two_points(radius, shift):
    core = box(1.0 - 2 * radius, 1.0 - 2 * radius)
    m, count = Case(core, core, (shift, 0.999), radius, radius).collide(0.01)
    assert count == 2
    assert (m.normal_x, m.normal_y) == pytest.approx((0.0, 1.0), abs=1e-9)
    assert m.separation1 == pytest.approx(-0.001)
    assert m.separation2 == pytest.approx(-0.001)
    low, high = sorted(p[0] for p in points_of(m))
    assert low == pytest.approx(max(shift, 0.0) - 0.5 + radius, abs=1e-9)
    assert high == pytest.approx(min(shift, 0.0) + 0.5 - radius, abs=1e-9)


def test_feature_ids_survive_rocking():
    """A box that rocks on another keeps its two ids, whichever of the two has the reference face."""
    seen = set()
    for angle in (-1e-3, -1e-5, 0.0, 1e-5, 1e-3):
        c, s = math.cos(angle), math.sin(angle)
        rocked = tuple((c * x - s * y, s * x + c * y) for x, y in box(1.0, 1.0))
        m, count = Case(box(3.0, 1.0), rocked, (0.1, 0.999)).collide(0.01)
        assert count == 2
        seen.add(frozenset((m.feature1, m.feature2)))
    assert len(seen) == 1


def test_concentric_discs_part_along_y():
    m, count = Case(((0.0, 0.0),), ((0.0, 0.0),), (0.0, 0.0), 0.5, 0.5).collide(0.0)
    assert count == 1
    assert (m.normal_x, m.normal_y, m.separation) == (0.0, 1.0, -1.0)


def test_a_face_bias_keeps_the_face_of_a():
    nearly = Case(box(1.0, 1.0), box(1.0, 1.0), (0.0, 0.99995))
    tilted = Case(nearly.a, tuple((x - 1e-5 * y, y + 1e-5 * x) for x, y in nearly.b), nearly.way)
    assert tilted.collide(0.01, face_bias=1e-3)[0].axis_owner == 0
