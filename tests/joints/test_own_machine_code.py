"""The joint solver is machine code of its own: parts of a step are the same with joints and without."""

from __future__ import annotations

import copy
from itertools import pairwise

import numpy as np
import pytest

from sandbox import BreakJoint
from sandbox._jit import _kind, jit_enabled, kernel_argument
from sandbox.engine.joints.nets import do_nets
from sandbox.engine.joints.part_tables import no_joints
from sandbox.engine.joints.solve import do_joints
from sandbox.engine.records.calls import JOINT_IMPACTS, JOINTS, NETS
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.engine.world import World
from tests.flat import body, circle, ground, scene
from tests.joints.jointed import joint, jointed
from tests.joints.nets import net

OF_ALL = (collide, begin, solve, finish, strike_batch)
OF_JOINTS = (do_joints, do_nets, strike_through_joints)


def bouncing(*names: str) -> World:
    """Balls that fall on the ground and bounce, joined to the next one at the middle between them."""
    balls = [
        body(name, circle(0.3, restitution=0.8), position=(float(k), 1.0), velocity=(0.0, -2.0 * k))
        for k, name in enumerate(names)
    ]
    pairs = enumerate(pairwise(names))
    return jointed((ground(), *balls), tuple(joint(a + b, "revolute", a, b, (k + 0.5, 1.0)) for k, (a, b) in pairs))


def test_tables_without_rows_are_of_the_kinds_that_joints_have() -> None:
    ours = kernel_argument(bouncing("a", "b").scratch.joints)
    assert _kind(kernel_argument(no_joints())) == _kind(ours)


@pytest.mark.skipif(not jit_enabled(), reason="there is no machine code without the compiler")
def test_one_version_of_each_part_serves_all_worlds_and_joints_load_what_is_theirs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for part in (*OF_ALL, *OF_JOINTS):
        monkeypatch.setattr(part, "_versions", {})
    bouncing("a").step(60)
    assert [len(part._versions) for part in (*OF_ALL, *OF_JOINTS)] == [1, 1, 1, 1, 1, 0, 0, 0]  # type: ignore[attr-defined]
    bouncing("a", "b").step(60)
    assert [len(part._versions) for part in (*OF_ALL, *OF_JOINTS)] == [1, 1, 1, 1, 1, 1, 0, 1]  # type: ignore[attr-defined]
    net(12, 12, "hinge").step(2)
    assert [len(part._versions) for part in (*OF_ALL, *OF_JOINTS)] == [1] * 8  # type: ignore[attr-defined]


def test_joints_that_break_in_the_midst_of_a_run_are_called_no_more() -> None:
    """A copy, which never had any, goes on to the same bits."""
    world = bouncing("a", "b", "c")
    world.step(40)
    called = world._stepper.calls._called
    assert (called[:, 0, [JOINTS, JOINT_IMPACTS], 0] != 0).all()
    for name in ("ab", "bc"):
        world.apply(BreakJoint(name))
    world.step()
    other = copy.deepcopy(world)
    world.step(100)
    other.step(100)
    assert (called[:, 0, [JOINTS, NETS, JOINT_IMPACTS]] == 0).all()
    assert world.digest() == other.digest()


def test_joints_and_nets_that_come_in_the_midst_of_a_run_are_solved() -> None:
    """So is a copy, which has them from its beginning."""
    world = World(scene(ground(), body("a", circle(0.3, restitution=0.8), position=(0.0, 1.0))))
    world.step(40)
    places = [[4 + k % 9, 2 + k // 9] for k in range(81)]
    balls = [
        {"id": f"b{k}", "shapes": [{"circle": 0.2, "restitution": 0.8}], "position": at} for k, at in enumerate(places)
    ]
    pairs = [(k, k + 1) for k in range(81) if k % 9 < 8] + [(k, k + 9) for k in range(72)]
    ties = [
        {"id": f"{a}-{b}", "type": "distance", "bodies": [f"b{a}", f"b{b}"], "anchors": [places[a], places[b]]}
        for a, b in pairs
    ]
    world.spawn(balls[:2], ties[:1])
    world.step(5)
    world.spawn(balls[2:], ties[1:])
    other = copy.deepcopy(world)
    world.step(40)
    other.step(40)
    assert world.digest() == other.digest()


def test_nothing_is_written_to_tables_without_rows() -> None:
    bouncing("a").step(60)
    for table in (*no_joints()[:7], *no_joints().side_by_side):
        assert len(table) == 0
    direct = no_joints().direct
    assert not np.any(direct.level)
    assert not np.any(direct.found)
