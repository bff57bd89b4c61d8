"""Boxes around shapes: nothing gets out of them within the step, and they are not larger than they need to be."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.broad_phase.margins import MARGIN, MARGIN_SHARE
from sandbox.engine.world import World
from tests.engine.stages import Paused
from tests.examples import examples
from tests.flat import body, box, capsule, circle, polygon, world

SHAPES = [
    circle(0.3, at=(0.4, 0.1)),
    box(1.0, 0.5),
    box(0.6, 0.6, radius=0.2),
    capsule(0.7, 0.1),
    polygon((0.0, 0.0), (2.0, 0.0), (0.3, 1.0)),
]
speeds = st.floats(-30.0, 30.0)


def a_world(shape, place, angle, velocity, spin) -> World:
    """One free body."""
    return world(
        body("a", SHAPES[shape], position=place, angle=angle, velocity=velocity, angular_velocity=spin),
        gravity=(0.0, 0.0),
    )


@given(st.integers(0, 4), st.tuples(speeds, speeds), st.floats(-4, 4), st.tuples(speeds, speeds), st.floats(-40, 40))
@examples(200)
def test_the_box_holds_the_shape_all_through_the_step(shape, place, angle, velocity, spin):
    p = Paused(a_world(shape, place, angle, velocity, spin))
    p.detect()
    row, record = p.scratch.colliders.boxes[0], p.state.bodies[0]
    core = np.column_stack([p.state.vertices.x, p.state.vertices.y])
    radius = float(p.state.shapes[0].radius)
    lowest, highest = np.full(2, np.inf), np.full(2, -np.inf)
    for t in np.linspace(0.0, p.seconds, 9):
        c, s = math.cos(angle + spin * t), math.sin(angle + spin * t)
        centre = np.array([record.center_x, record.center_y]) + t * np.array(velocity)
        points = core @ np.array([[c, s], [-s, c]]) + centre
        lowest = np.minimum(lowest, points.min(axis=0) - radius)
        highest = np.maximum(highest, points.max(axis=0) + radius)
    lower, upper = np.array([row.lower_x, row.lower_y]), np.array([row.upper_x, row.upper_y])
    assert (lower <= lowest).all()
    assert (upper >= highest).all()
    slack = 0.5 * min(MARGIN, MARGIN_SHARE * float(record.extent)) + 1e-9
    swing = min(abs(spin) * p.seconds, 2.0) * float(record.extent)
    assert (lowest - lower <= slack + 2.0 * swing).all()
    assert (upper - highest <= slack + 2.0 * swing).all()


@given(st.integers(0, 4), st.floats(-100, 100))
def test_cores_are_turned_about_the_centre_of_mass(shape, angle):
    p = Paused(a_world(shape, (3.0, 4.0), angle, (0.0, 0.0), 0.0))
    p.detect()
    c, s = math.cos(angle), math.sin(angle)
    rotation = np.array([[c, s], [-s, c]])
    for x, y in (("x", "y"), ("normal_x", "normal_y")):
        source = np.column_stack([p.state.vertices[x], p.state.vertices[y]])
        assert np.column_stack([p.scratch.colliders.cores[x], p.scratch.colliders.cores[y]]) == pytest.approx(
            source @ rotation, abs=1e-14
        )
