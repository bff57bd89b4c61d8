"""What rigid joints bore when the world was put down: under that they do not give way."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sandbox
from tests.flat import body, box, circle
from tests.joints.jointed import G, gap, joint, jointed, row

PRELOADS = ("preload_0", "preload_1", "preload_2")


def hanging(count, kind="revolute", **fields):
    """Links of 1 m that hang straight down from the origin."""
    links = [body(f"p{k}", box(0.25, 1.0), position=(0.0, -k - 0.5), **fields) for k in range(count)]
    joints = [joint(f"j{k}", kind, f"p{k - 1}" if k else None, f"p{k}", (0.0, float(-k))) for k in range(count)]
    return jointed(tuple(links), tuple(joints))


def preloads(world):
    """Row for row."""
    return np.array([world.state.joints[name] for name in PRELOADS])


@pytest.mark.parametrize("kind", ["revolute", "weld"])
def test_the_preload_is_the_weight_that_hangs_on_a_joint_and_nothing_sinks(kind):
    world = hanging(10, kind)
    world.step(120)
    weights = [0.25 * G * (10 - k) for k in range(10)]
    assert np.hypot(*preloads(world)[:2]) == pytest.approx(weights, rel=1e-6)
    assert gap(world) < 1e-11


def test_a_load_that_comes_later_is_given_way_to_as_before_and_kept_apart_from_the_preload():
    """Twice the weight, from a second on."""
    late = hanging(10)
    late.step(60)
    before = preloads(late)
    late.gravity = (0.0, -2.0 * G)
    late.step(600)
    assert np.array_equal(preloads(late), before)
    assert 1e-9 < gap(late) < 1e-5


def test_what_moves_or_is_apart_when_it_is_put_down_has_none():
    """The impulses of its first substep are no loads."""
    links, joints = row(4)
    pulled = jointed(
        tuple(links), (*joints[:3], joint("j3", "revolute", "p2", "p3", anchor_a=(3.0, 0.0), anchor_b=(3.1, 0.0)))
    )
    turning = hanging(4, angular_velocity=3.0)
    for world in (pulled, turning):
        world.step()
        assert not preloads(world).any()


def test_what_a_motor_of_any_strength_tears_from_its_aim_has_none():
    """A wheel that is turned at once, and a rod that hardly lets it: taken for loads, what their joints strive for in
    the first substep grew a hundredfold each time that it was found again, to speeds that are no numbers."""
    w = sandbox.World(
        sandbox.Scene(
            gravity=(0.0, 0.0),
            settings={"substeps": 8},
            bodies=[
                {"id": name, "shapes": [{"box": [0.8, 0.4], "density": d, "mask": 0}]}
                for name, d in (("a", 1), ("b", 10))
            ],
            joints=[
                {"id": "rod", "type": "distance", "bodies": ["b", "a"], "anchors": [[1, 0], [0, 0.1]]},
                {"id": "wheel", "type": "wheel", "bodies": ["a", "b"], "anchor": [0.5, 0], "motor_speed": 90},
                {"id": "rub", "type": "friction", "bodies": ["b", "a"], "anchor": [1.5, 0], "max_force": 5},
            ],
        )
    )
    w.step(60)
    assert w.frozen == []
    assert not preloads(w).any()
    assert np.abs(w.bodies.velocity).max() < 2.0
    assert w.bodies.mass @ w.bodies.velocity == pytest.approx((0.0, 0.0), abs=1e-9)


def test_each_part_has_its_own():
    """Four to a batch: one that moves takes none from those beside it."""
    links, joints = [], []
    for k in range(6):
        links.append(body(f"p{k}", box(0.5, 1.0), position=(3.0 * k, -0.5), velocity=(5.0 if k == 2 else 0.0, 0.0)))
        joints.append(joint(f"j{k}", "revolute", None, f"p{k}", (3.0 * k, 0.0)))
    world = jointed(tuple(links), tuple(joints))
    world.step()
    borne = np.hypot(*preloads(world)[:2])
    assert borne[2] == 0.0
    assert np.delete(borne, 2) == pytest.approx([0.5 * G] * 5, rel=1e-9)


def test_a_snapshot_keeps_it():
    world = hanging(5)
    world.step(3)
    kept = world.snapshot()
    world.step(50)
    after = world.digest
    world.restore(kept)
    world.step(50)
    assert world.digest == after


def test_a_rope_that_is_drawn_straight_gets_no_infinite_preload():
    """Its load is infinite: it would keep that tension for ever, and swing without end."""
    links, joints = row(20, pin="both")
    rider = body("rider", circle(0.5, density=3.0), position=(10.5, -1.0))
    world = jointed((*links, rider), (*joints, joint("j", "revolute", "p10", "rider", (10.5, 0.0))))
    world.step()
    total = G * (20 * 0.25 + 3.0 * math.pi * 0.25)
    assert np.abs(preloads(world)).max() < total
