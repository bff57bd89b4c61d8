"""A contact that follows its bodies, against the one that is found where they have got to."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox._jit import kernel_argument
from sandbox.engine.contact_solver.gather import PairPose
from sandbox.engine.midpoint.contacts_ahead import move_contact
from sandbox.engine.midpoint.move_contact import STAYS, VERTICES
from sandbox.tables import Records, plain
from sandbox.world.records import CONTACT
from tests.examples import examples
from tests.geometry.convex_cases import Case, cases, turned
from tests.kernels import called_from_python

PLACES = ("normal_x", "normal_y", "separation1", "anchor_ax1", "anchor_ay1", "anchor_bx1", "anchor_by1")
SECOND = ("separation2", "anchor_ax2", "anchor_ay2", "anchor_bx2", "anchor_by2")


def move_first(rows: Records, way: PairPose, owner: int) -> None:
    """Move the first row."""
    move_contact(rows[0], way, owner)


move = called_from_python(move_first)
small = st.floats(-0.02, 0.02)


def contact_of(case: Case, m) -> Records:
    """A contact as the narrow phase makes it."""
    rows = CONTACT.zeros(1)
    c = rows[0]
    c.axis_owner, c.point_count = m.axis_owner, m.point_count
    c.normal_x, c.normal_y = m.normal_x, m.normal_y
    c.radius_a, c.radius_b = case.radius_a, case.radius_b
    for k in range(1, int(m.point_count) + 1):
        c[f"separation{k}"] = m[f"separation{k}"]
        for axis, way in zip("xy", case.way, strict=True):
            c[f"anchor_a{axis}{k}"] = m[f"{axis}{k}"]
            c[f"anchor_b{axis}{k}"] = m[f"{axis}{k}"] - way
    return rows


def pose(x: float, y: float, a: float, b: float) -> PairPose:
    return PairPose(x, y, math.cos(a), math.sin(a), math.cos(b), math.sin(b))


def numbers(rows: Records, names: tuple[str, ...]) -> list[float]:
    return [float(plain(rows)[name][0]) for name in names]


@given(cases, small, small, small, small)
@examples(400)
def test_it_is_the_contact_that_is_found_there(case, x, y, a, b):
    """As long as the same two features touch: to rounding where shapes just touch, else to what half the gap between
    the point and either surface does as it turns."""
    m, count = case.collide(0.05)
    assume(count == 1 and abs(m.separation) < 0.05)
    apart = m.separation + case.radius_a + case.radius_b if m.axis_owner == VERTICES else 1.0
    assume(apart > 0.1)
    rows = contact_of(case, m)
    move(kernel_argument(rows), pose(x, y, a, b), int(m.axis_owner))
    there = replace(case, a=turned(case.a, a), b=turned(case.b, b), way=(case.way[0] + x, case.way[1] + y))
    found, count = there.collide(0.2)
    assume(count == 1 and (found.axis_owner, found.axis_edge) == (m.axis_owner, m.axis_edge))
    assume(found.feature1 == m.feature1)
    expected = numbers(contact_of(there, found), PLACES)
    # Half a gap at either side of the point turns with the bodies, and shortens what joins two vertices.
    slack = 0.1 * abs(m.separation) * (1.0 + case.radius_a + case.radius_b) / apart**2 + 1e-9
    assert numbers(rows, PLACES)[:2] == pytest.approx(expected[:2], abs=slack)
    assert numbers(rows, PLACES)[2] == pytest.approx(expected[2], abs=0.1 * slack + 1e-9)
    midway = 0.5 * abs(found.separation - m.separation)
    assert numbers(rows, PLACES)[3:] == pytest.approx(expected[3:], abs=midway + slack)


@given(cases, small, small, small, small, st.booleans())
@examples(200)
def test_the_opposite_way_leads_back(case, x, y, a, b, lasts):
    """What overlaps deeply is not put ahead: where two vertices come together, they have no axis that could turn."""
    m, count = case.collide(0.05)
    assume(count > 0 and abs(m.separation) < 0.05)
    assume(m.axis_owner != VERTICES or m.separation + case.radius_a + case.radius_b > 0.2)
    rows = contact_of(case, m)
    names = PLACES + (SECOND if count == 2 else ())
    before = numbers(rows, names)
    owner = int(m.axis_owner) if lasts else STAYS
    move(kernel_argument(rows), pose(x, y, a, b), owner)
    gap = abs(m.separation) + abs(float(rows[0].separation1))
    move(kernel_argument(rows), pose(-x, -y, -a, -b), owner)
    # To rounding where shapes just touch; a gap turns with one of the bodies on either way.
    turns = 0.0 if m.axis_owner != VERTICES or not lasts else 0.5 * gap
    assert numbers(rows, names) == pytest.approx(before, abs=turns + 1e-12)


@given(cases, small, small, small, small)
@examples(200)
def test_one_that_does_not_last_keeps_its_axis(case, x, y, a, b):
    """Its gap changes by what its two points move along it, its anchors turn with either body, but for the rounding."""
    m, count = case.collide(0.05)
    assume(count == 1)
    rows = contact_of(case, m)
    c = rows[0].copy()
    move(kernel_argument(rows), pose(x, y, a, b), STAYS)
    now = rows[0]
    n = np.array([c.normal_x, c.normal_y])
    assert (now.normal_x, now.normal_y) == (c.normal_x, c.normal_y)
    core_a = np.array([c.anchor_ax1, c.anchor_ay1]) - case.radius_a * n
    core_b = np.array([c.anchor_bx1, c.anchor_by1]) + case.radius_b * n
    after_a, after_b = np.array(turned((tuple(core_a),), a)[0]), np.array(turned((tuple(core_b),), b)[0])
    gap = c.separation1 + n @ (np.array([x, y]) + (after_b - core_b) - (after_a - core_a))
    assert now.separation1 == pytest.approx(gap, abs=1e-12)
    assert (now.anchor_ax1, now.anchor_ay1) == pytest.approx(tuple(after_a + case.radius_a * n), abs=1e-12)
    assert (now.anchor_bx1, now.anchor_by1) == pytest.approx(tuple(after_b - case.radius_b * n), abs=1e-12)


SQUARE = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
DIAMOND = turned(SQUARE, math.pi / 4)


@pytest.mark.parametrize(
    "case",
    [
        Case(SQUARE, ((0.0, 0.0),), (0.2, 0.8), 0.0, 0.3),
        Case(((0.0, 0.0),), SQUARE, (0.1, 0.7), 0.2, 0.0),
        Case(SQUARE, DIAMOND, (0.1, 0.5 + math.sqrt(0.5))),
        Case(DIAMOND, SQUARE, (0.1, 0.55 + math.sqrt(0.5)), 0.0, 0.05),
        Case(((0.0, 0.0),), ((0.1, 0.0),), (0.3, 0.3), 0.3, 0.2),
    ],
    ids=["disc on a face", "face on a disc", "corner on a face", "rounded face on a corner", "discs"],
)
def test_what_just_touches_rolls_without_error(case):
    """Both turn and move so that they go on touching: the point wanders over both of them."""
    m, count = case.collide(0.2)
    assert count == 1
    case = replace(
        case, way=tuple(w - m.separation * n for w, n in zip(case.way, (m.normal_x, m.normal_y), strict=True))
    )
    m, _ = case.collide(0.01)
    a, b = 0.03, -0.02
    there = replace(case, a=turned(case.a, a), b=turned(case.b, b), way=(case.way[0] + 0.02, case.way[1] + 0.01))
    gap = there.collide(0.2)[0].separation
    n = there.collide(0.2)[0]
    x, y = 0.02 - gap * n.normal_x, 0.01 - gap * n.normal_y
    there = replace(there, way=(case.way[0] + x, case.way[1] + y))
    rows = contact_of(case, m)
    move(kernel_argument(rows), pose(x, y, a, b), int(m.axis_owner))
    found, _ = there.collide(0.01)
    assert numbers(rows, PLACES) == pytest.approx(numbers(contact_of(there, found), PLACES), abs=1e-12)
