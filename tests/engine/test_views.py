"""Views of bodies and joints are kept, and are still those of whoever has that id now."""

from __future__ import annotations

import copy

import pytest

import sandbox
from sandbox import UnknownBodyError, UnknownJointError

BALLS = [{"id": name, "shapes": [{"circle": 0.5}], "position": [2 * k, 0]} for k, name in enumerate("abc")]
ROD = {"id": "rod", "type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [2, 0]]}


def world() -> sandbox.World:
    return sandbox.World(sandbox.Scene(bodies=BALLS, joints=[ROD]))


def test_the_same_view_is_given_again():
    w = world()
    assert w.body("a") is w.body("a")
    assert w.joint("rod") is w.joint("rod")
    joints = w.joints
    assert w.joints is joints
    w.step()
    assert w.joints is joints
    w.spawn(joints={**ROD, "id": "tie", "bodies": ["b", "c"]})
    assert [joint.id for joint in w.joints] == ["rod", "tie"]
    w.joint("rod").delete()
    assert [joint.id for joint in w.joints] == ["tie"]


def test_a_view_is_not_that_of_another_one_of_the_same_id():
    w = world()
    ball, rod = w.body("a"), w.joint("rod")
    w.delete("a")
    with pytest.raises(UnknownBodyError):
        w.body("a")
    with pytest.raises(UnknownJointError):
        w.joint("rod")
    w.spawn({**BALLS[0], "position": [7, 0]})
    assert w.body("a").position == (7.0, 0.0)
    for gone, error in ((ball, UnknownBodyError), (rod, UnknownJointError)):
        with pytest.raises(error):
            _ = gone.angle


def test_a_view_is_not_that_of_who_was_there_before_a_restore():
    w = world()
    before = w.snapshot()
    w.spawn({**BALLS[0], "id": "first", "position": [7, 0]}, {**ROD, "id": "one", "bodies": ["a", "first"]})
    assert (w.body("first").id, w.joint("one").id) == ("first", "one")
    w.restore(before)
    w.spawn({**BALLS[0], "id": "second", "position": [9, 0]}, {**ROD, "id": "two", "bodies": ["a", "second"]})
    assert (w.body("second").id, w.joint("two").id) == ("second", "two")
    assert [joint.id for joint in w.joints] == ["rod", "two"]


def test_a_copy_has_views_of_its_own():
    w = world()
    ball = w.body("a")
    other = copy.copy(w)
    other.body("a").position = (0.0, 5.0)
    assert (ball.position, other.body("a").position) == ((0.0, 0.0), (0.0, 5.0))
