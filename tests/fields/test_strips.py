"""Who may be in many regions: a body feels those that it lies in, and no region that it may lie in is passed over."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import SetRegion
from sandbox._jit import entry_point, kernel_argument
from sandbox.engine.fields.area import OUTSIDE, place
from sandbox.engine.fields.records import BITS, Fields
from sandbox.engine.fields.strips import lay_strips, look_up, lowest_bit
from sandbox.scene.flat import FlatRegion
from sandbox.tables import Integers
from tests.examples import examples
from tests.fields.pools import inside
from tests.flat import body, box, circle, world

STEP = 1.0 / 60.0


@entry_point
def passed_over(fields: Fields, step: int, extent: float, checked: Integers) -> int:
    """How many regions that a body may lie in are not found; `checked` counts those that are."""
    lay_strips(fields, step)
    lacking = 0
    for i in range(fields.pushes.shape[0]):
        push = fields.pushes[i]
        look_up(fields, push, extent)
        for k in range(fields.regions.shape[0]):
            found = fields.found[k // BITS] >> (k % BITS) & 1
            checked[0] += found
            if found == 0 and place(fields.regions[k], fields.edges, push.x, push.y, extent) != OUTSIDE:
                lacking += 1
    return lacking


@entry_point
def lowest(bits: int) -> int:
    """For a test."""
    return lowest_bit(bits)


numbers = st.floats(-50.0, 50.0)
angles = st.floats(0.0, 2.0 * math.pi)


def outline(x: float, y: float, angle: float, size: float, corners: int, surface: float | None) -> FlatRegion:
    """A regular polygon, which a surface may cut."""
    turns = [angle + 2.0 * math.pi * k / corners for k in range(corners)]
    edges = [(math.cos(a), math.sin(a), math.cos(a) * x + math.sin(a) * y + size) for a in turns]
    return FlatRegion("wind", (*edges, *([] if surface is None else [(0.0, 1.0, surface)])))


regions = st.one_of(
    st.builds(
        outline, numbers, numbers, angles, st.floats(0.1, 9.0), st.integers(3, 8), st.none() | st.floats(-50.0, 50.0)
    ),
    st.builds(
        lambda x, y, w, h: FlatRegion("wind", inside(x, y, x + w, y + h)),
        numbers, numbers, st.floats(0.1, 9.0), st.floats(0.1, 9.0),
    ),
    st.builds(lambda x, y, r: FlatRegion("gravity", disc=(x, y, r)), numbers, numbers, st.floats(0.1, 9.0)),
    st.builds(lambda angle, offset: FlatRegion("wind", ((math.cos(angle), math.sin(angle), offset),)), angles, numbers),
    st.just(FlatRegion("gravity")),
    st.builds(
        lambda x, y, reach: FlatRegion("attraction", center=(x, y), strength=1.0, range=reach),
        numbers, numbers, st.floats(1.0, 9.0),
    ),
)  # fmt: skip


@given(st.lists(regions, min_size=1, max_size=140), st.lists(st.tuples(numbers, numbers), min_size=1), st.floats(0, 5))
@examples(60)
def test_no_region_is_passed_over(several: list[FlatRegion], places: list[tuple[float, float]], extent: float) -> None:
    state = world(*(body(f"b{k}", circle(0.1)) for k in range(len(places))), regions=tuple(several)).state
    fields = Fields.for_state(state, len(places))
    for push, (x, y) in zip(fields.pushes, places, strict=True):
        push.x, push.y = x, y
    attracting = np.flatnonzero(state.regions.kind == 3)  # beyond their range they lie everywhere, and do nothing
    state.regions.disc_x[attracting] = state.regions.center_x[attracting]
    state.regions.disc_y[attracting] = state.regions.center_y[attracting]
    state.regions.disc_radius[attracting] = state.regions.range[attracting]
    assert passed_over(kernel_argument(fields), 0, extent, np.zeros(1, np.int64)) == 0


@pytest.mark.parametrize("turned", [False, True])
def test_side_by_side_or_over_each_other_a_body_is_held_against_few(turned: bool) -> None:
    def at(x: float, y: float) -> tuple[float, float]:
        return (y, x) if turned else (x, y)

    several = tuple(FlatRegion("wind", inside(*at(4.0 * k, 0.0), *at(4.0 * k + 3.0, 5.0))) for k in range(500))
    state = world(*(body(f"b{k}", circle(0.1)) for k in range(500)), regions=several).state
    fields, found = Fields.for_state(state, 500), np.zeros(1, np.int64)
    for k, push in enumerate(fields.pushes):
        push.x, push.y = at(4.0 * k + 1.0, 2.0)
    assert passed_over(kernel_argument(fields), 0, 0.5, found) == 0
    assert 500 <= found[0] <= 4 * 500


@pytest.mark.parametrize("bit", range(62))
def test_lowest_bit(bit: int) -> None:
    assert lowest(1 << bit) == lowest((1 << bit) | (1 << 61)) == bit


def test_each_of_many_zones_has_its_own_gravity_and_wind() -> None:
    """150 zones, some 30 m wide across three others: what is in each falls as it says, and as by itself."""
    zones = [
        FlatRegion("gravity", inside(10.0 * k, -50.0, 10.0 * k + 10.0, 50.0), gravity=(0.0, -0.1 * k))
        for k in range(150)
    ]
    wide = [
        FlatRegion("wind", inside(30.0 * k, -50.0, 30.0 * k + 30.0, 50.0), flow=(3.0, 0.0), density=0.1, drag=1.0)
        for k in range(20)
    ]
    bodies = [
        body(f"b{k}", circle(0.3), box(0.4, 0.2, (1.0, 0.0)), position=(10.0 * k + 4.0, 0.0), angle=0.1 * k)
        for k in range(150)
    ]
    made = world(*bodies, regions=(*zones, *wide))
    made.step(3)
    for k in (0, 1, 7, 59, 60, 149):
        alone = world(bodies[k], regions=(zones[k], *(wide[k // 3 : k // 3 + 1])))
        alone.step(3)
        assert made.body(f"b{k}").position == alone.body(f"b{k}").position
        assert made.body(f"b{k}").angular_velocity == alone.body(f"b{k}").angular_velocity
        if k >= 60:
            assert made.body(f"b{k}").velocity == pytest.approx((0.0, -0.1 * k * 3 * STEP), rel=1e-9, abs=1e-12)


def test_a_region_that_is_moved_is_found_where_it_is() -> None:
    several = tuple(
        FlatRegion("gravity", inside(4.0 * k, 0.0, 4.0 * k + 3.0, 5.0), gravity=(1.0, 0.0), id=f"r{k}")
        for k in range(9)
    )
    made = world(body("it", circle(0.2), position=(13.5, 2.0)), regions=several, gravity=(0.0, 0.0))
    for bounds, speed in (
        ((12.0, 0.0, 15.0, 5.0), 1.0),
        ((100.0, 0.0, 101.0, 5.0), 1.0),
        ((13.0, 0.0, 14.0, 5.0), 2.0),
    ):
        made.apply(SetRegion("r3", inside=bounds))
        made.step()
        assert made.body("it").velocity[0] == pytest.approx(speed * STEP)
