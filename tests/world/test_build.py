"""From a flat scene to records: order, masses, centres, overrides."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.scene.flat import FlatBody
from sandbox.world import records
from sandbox.world.build import build_state
from tests.flat import body, box, capsule, circle, ground, polygon, scene, segment


def only(flat_body):
    """The record of a single body."""
    return build_state(scene(flat_body)).bodies[0]


def test_order_and_indices():
    state = build_state(
        scene(
            ground(),
            body("dumbbell", circle(0.5, at=(-1.0, 0.0)), box(2.0, 0.1), circle(0.5, at=(1.0, 0.0))),
            body("empty"),
            body("pill", capsule(0.5, 0.2)),
        )
    )
    assert state.names == ("ground", "dumbbell", "empty", "pill")
    assert list(state.shapes.body) == [0, 1, 1, 1, 3]
    assert list(state.shapes.vertex_start) == [0, 4, 5, 9, 10]
    assert list(state.shapes.vertex_count) == [4, 1, 4, 1, 2]
    assert list(state.shapes.kind) == [records.BOX, records.CIRCLE, records.BOX, records.CIRCLE, records.CAPSULE]
    assert len(state.vertices) == 12
    assert (state.bodies.awake == 1).all()
    assert state.counters[0].step_count == 0


def test_a_compound_body_turns_about_its_centre_of_mass():
    hammer = only(body("hammer", box(1.0, 1.0, (2.0, 0.0), density=3.0), box(2.0, 0.5), position=(5.0, 7.0), angle=0.5))
    cx = 3.0 * 2.0 / 4.0
    assert hammer.mass == pytest.approx(4.0)
    assert (hammer.local_center_x, hammer.local_center_y) == pytest.approx((cx, 0.0))
    expected = 3.0 / 6.0 + 3.0 * (2.0 - cx) ** 2 + 1.0 * (4.0 + 0.25) / 12.0 + 1.0 * cx**2
    assert hammer.inertia == pytest.approx(expected)
    assert (hammer.position_x, hammer.position_y) == (5.0, 7.0)
    assert hammer.center_x == pytest.approx(5.0 + cx * math.cos(0.5))
    assert hammer.center_y == pytest.approx(7.0 + cx * math.sin(0.5))
    assert hammer.extent == pytest.approx(math.hypot(-1.0 - cx, 0.25))


def test_vertices_are_measured_from_the_centre_of_mass():
    state = build_state(scene(body("wedge", polygon((0.0, 0.0), (3.0, 0.0), (0.0, 3.0)), position=(9.0, 9.0))))
    assert np.column_stack([state.vertices.x, state.vertices.y]) == pytest.approx(
        np.array([[-1.0, -1.0], [2.0, -1.0], [-1.0, 2.0]])
    )
    normals = np.column_stack([state.vertices.normal_x, state.vertices.normal_y])
    assert normals == pytest.approx(np.array([[0.0, -1.0], [math.sqrt(0.5), math.sqrt(0.5)], [-1.0, 0.0]]))


@given(st.floats(0.1, 100.0))
def test_a_mass_override_scales_the_inertia(mass):
    plain, heavy = only(body("a", box(2.0, 1.0))), only(body("a", box(2.0, 1.0), mass=mass))
    assert heavy.mass == mass
    assert heavy.inertia == pytest.approx(plain.inertia * mass / plain.mass)
    assert heavy.inverse_mass == pytest.approx(1.0 / mass)
    assert heavy.inverse_inertia == pytest.approx(1.0 / heavy.inertia)


def test_inertia_and_centre_overrides():
    row = only(body("a", box(2.0, 1.0), inertia=9.0, center=(0.5, 0.0)))
    assert (row.mass, row.inertia) == (2.0, 9.0)
    assert (row.local_center_x, row.center_x, row.position_x) == (0.5, 0.5, 0.0)
    assert row.extent == pytest.approx(math.hypot(1.5, 0.5))
    shifted = only(body("a", box(2.0, 1.0), center=(0.5, 0.0)))
    assert shifted.inertia == pytest.approx(2.0 * 5.0 / 12.0 + 2.0 * 0.25)


def test_fixed_rotation():
    row = only(body("a", box(2.0, 1.0), fixed_rotation=True))
    assert (row.inertia, row.inverse_inertia) == (0.0, 0.0)
    assert row.mass == 2.0


@pytest.mark.parametrize("kind", ["static", "kinematic"])
def test_only_dynamic_bodies_have_mass(kind):
    row = only(body("a", box(2.0, 1.0), type=kind, velocity=(1.0, 2.0), angular_velocity=3.0))
    assert (row.mass, row.inertia, row.inverse_mass, row.inverse_inertia) == (0.0, 0.0, 0.0, 0.0)
    moving = (row.velocity_x, row.velocity_y, row.angular_velocity)
    assert moving == ((0.0, 0.0, 0.0) if kind == "static" else (1.0, 2.0, 3.0))


def test_prefab_bodies_share_an_outline_but_not_a_row():
    shapes = (box(1.0, 1.0), circle(0.25, at=(0.5, 0.5)))
    bodies = [FlatBody(f"{i}", "dynamic", shapes, position=(2.0 * i, 0.0)) for i in range(5)]
    state = build_state(scene(*bodies))
    assert list(state.shapes.body) == [0, 0, 1, 1, 2, 2, 3, 3, 4, 4]
    assert list(state.shapes.vertex_start) == [0, 4, 5, 9, 10, 14, 15, 19, 20, 24]
    assert len(set(state.bodies.mass)) == 1
    assert list(state.bodies.position_x) == [0.0, 2.0, 4.0, 6.0, 8.0]


def test_a_sharp_segment_on_a_dynamic_body_has_no_mass_of_its_own():
    row = only(body("a", segment((-1.0, 0.0), (1.0, 0.0))))
    assert (row.mass, row.inverse_mass) == (0.0, 0.0)


def test_an_empty_scene():
    state = build_state(scene())
    assert len(state.bodies) == 0
    assert state.names == ()


def test_every_table_is_of_words_of_eight_bytes_and_documented():
    for table in records.TABLES:
        halves = [k for k, field in enumerate(table.fields) if field.kind == "i4"]
        assert table.dtype.itemsize == 8 * len(table.fields) - 4 * len(halves)
        assert all(table.fields[k].kind == table.fields[k + 1].kind for k in halves[::2])  # two to a word
        for field in table.fields:
            assert field.kind in ("f8", "i8", "i4"), (table.name, field.name)
            assert field.unit, (table.name, field.name)
