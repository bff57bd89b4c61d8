"""Parts in whose system bodies stay as unknowns: room for all that eliminating them fills, and the same motion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox.engine.joints import augmented, part_layout
from sandbox.engine.joints.augmented import ROWS_OF_BODY, augment
from sandbox.engine.joints.direct.records import OF_BODY
from sandbox.engine.joints.elimination import minimum_degree
from sandbox.engine.world import World
from tests.examples import examples
from tests.joints.linkages import Linkage, linkages, twin
from tests.joints.test_elimination import parts
from tests.joints.test_twin import BOUND, FREE


def system(sides, weights, bodies):
    """The augmented matrix of joints with random Jacobians, and of which joint or body each row is, joints first."""
    random = np.random.default_rng(len(sides))
    count = int(sides.max(initial=-1)) + 1
    owner = np.repeat(np.arange(len(sides)), weights)
    jacobian = np.zeros((len(owner), count, ROWS_OF_BODY))
    for r, j in enumerate(owner.tolist()):
        for body in sides[j][sides[j] >= 0].tolist():
            jacobian[r, body] += random.normal(size=ROWS_OF_BODY)
    others = np.setdiff1d(np.arange(count), bodies)
    inner, outer = (jacobian[:, which].reshape(len(owner), -1) for which in (others, bodies))
    matrix = np.block([[inner @ inner.T, outer], [outer.T, -np.eye(outer.shape[1])]])
    return matrix, np.append(owner, np.repeat(len(sides) + np.arange(len(bodies)), ROWS_OF_BODY))


@examples(300)
@given(part=parts(), least=st.sampled_from([2, 4, 16]))
def test_no_joint_comes_before_all_of_its_bodies_and_there_is_room_for_what_is_filled(part, least):
    """Eliminated entry by entry, as a dense matrix: a pivot is 0 only where a row says what others have said."""
    sides, weights = part
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(augmented, "MANY_ROWS", least)
        both = augment(sides, weights, 10**6)
    assume(both is not None)
    found, bodies = both
    assert sorted(found.order.tolist()) == list(range(len(sides) + len(bodies)))
    place = np.argsort(found.order)
    for j, each in enumerate(sides):
        outer = np.isin(each, bodies)
        if (each >= 0).any() and not ((each >= 0) & ~outer).any():
            assert place[j] > place[len(sides) + np.searchsorted(bodies, each[outer])].min()
    matrix, owner = system(sides, weights, bodies)
    order = np.argsort(place[owner], kind="stable")
    matrix, at_place = matrix[np.ix_(order, order)], place[owner][order]
    room = np.eye(len(found.order), dtype=bool)
    for k, end in enumerate(found.ends):
        room[k, found.below[0 if k == 0 else found.ends[k - 1] : end]] = True
    for k in range(len(matrix)):
        filled = np.flatnonzero(np.abs(matrix[k, k + 1 :]) > 1e-9) + k + 1
        assert room[at_place[k], at_place[filled]].all()
        if abs(matrix[k, k]) > 1e-9:
            matrix[k + 1 :, k + 1 :] -= np.outer(matrix[k + 1 :, k], matrix[k, k + 1 :]) / matrix[k, k]


def stays(world: World) -> bool:
    """Whether a body stays in the system of some part."""
    work = world.scratch.joints
    return work is not None and bool((work.direct.equations.augmented == OF_BODY).any())


def let_bodies_stay(patch):
    """Bodies of more than three rows stay in the system wherever that can be factorised."""

    def elimination(sides, weights):
        whole = minimum_degree(sides, weights, 10**6), np.zeros(0, np.int64)
        return augment(sides, weights, 10**6) or whole

    patch.setattr(augmented, "MANY_ROWS", 3)
    patch.setattr(part_layout, "_elimination", elimination)


def states(linkage: Linkage, stay: bool = False) -> np.ndarray:
    """Poses and velocities of the bodies after each of three steps."""
    with pytest.MonkeyPatch.context() as patch:
        if stay:
            let_bodies_stay(patch)
        world = linkage.world()
    assume(not stay or stays(world))
    found = []
    for _ in range(3):
        world.step()
        bodies = twin(world)
        found.append([*bodies.pose, *bodies.velocity])
    return np.array(found)


@examples(100)
@given(linkage=linkages(FREE, 5))
def test_joints_without_bounds_move_as_where_all_bodies_are_eliminated(linkage):
    assert states(linkage, stay=True) == pytest.approx(states(linkage), abs=1e-9)


@examples(100)
@given(linkage=linkages(FREE + BOUND, 5))
def test_joints_with_bounds_move_as_where_all_bodies_are_eliminated(linkage):
    """Rounding may decide whether a row just reaches its bound: then they differ as where speeds differ by as little.
    What a motor between stops does depends on which row is looked at first, with as without."""
    found, usual = states(linkage, stay=True), states(linkage)
    difference = np.abs(found - usual).max()
    if difference > 1e-8:
        random = np.random.default_rng(1)
        other = (tuple(tuple(x + 1e-12 * random.normal() for x in each) for each in linkage.speeds) for _ in range(12))
        spread = max(np.abs(states(replace(linkage, speeds=speeds)) - usual).max() for speeds in other)
        assert difference < 10.0 * spread
