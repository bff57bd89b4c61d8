"""Poses against the step's own tables, and boxes and projections against their definitions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given

from sandbox.reference.arbitration import poses_of
from sandbox.reference.exact_referee import overlap_along
from sandbox.reference.pair import Pair
from sandbox.reference.poses import Poses
from tests import flat
from tests.reference.pairs import any_pairs, at, box, circle


def test_cores_have_the_bits_of_the_step() -> None:
    tilted = flat.body("a", flat.box(1, 2), flat.capsule(0.5, 0.2), position=(0, 5), angle=0.7, angular_velocity=3.0)
    world = flat.world(flat.ground(), tilted, flat.body("b", flat.circle(0.5, (0.25, 0)), position=(0.3, 8)))
    for _ in range(40):
        poses = Poses.of(world.state.bodies, world.state.shapes, world.state.vertices)
        world.step()
        assert poses.cores.tobytes() == world.scratch.colliders.cores.tobytes()


def test_poses_do_not_follow_the_world() -> None:
    world = flat.world(flat.body("a", flat.circle(0.5)))
    poses = Poses.of(world.state.bodies, world.state.shapes, world.state.vertices)
    world.step(10)
    assert poses.centers.tolist() == [[0.0, 0.0]]


def test_boxes_hold_core_and_radius_and_nothing_more() -> None:
    poses = poses_of(at(circle(0.5), box(2, 1, 0.25), (3.0, 4.0)))
    assert poses.boxes.tolist() == [[-0.5, -0.5, 0.5, 0.5], [1.75, 3.25, 4.25, 4.75]]


@given(any_pairs)
def test_overlap_along_is_the_exact_projection(pair: Pair) -> None:
    poses, both = poses_of(pair), np.array([[0, 1]])
    for k in range(8):
        normal = (math.cos(0.8 * k), math.sin(0.8 * k))
        got = poses.overlap_along(both, np.array([normal]))[0]
        assert got == pytest.approx(overlap_along(pair, normal), abs=1e-13)


def test_a_pair_comes_out_as_it_went_in() -> None:
    pair = at(circle(0.5), box(2, 1, 0.25), (3.0, 4.0))
    assert poses_of(pair).pair(0, 1) == pair
    assert pair.kinds == "circle-polygon"
