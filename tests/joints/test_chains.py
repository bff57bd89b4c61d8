"""What hangs together in a row: bridge, ball and chain, cantilever."""

from __future__ import annotations

import math

import mpmath
import pytest

from tests.flat import body, box, circle
from tests.joints.jointed import G, gap, joint, jointed, row


def test_a_bridge_of_160_planks_does_not_stretch():
    planks, joints = row(160, pin="both")
    world = jointed(tuple(planks), tuple(joints))
    for _ in range(60):
        world.step(10)
        assert gap(world) < 0.01
    ends = (world.joint("j0").anchors[1], world.joint("j160").anchors[0])
    assert math.dist(ends[0], (0.0, 0.0)) < 0.01
    assert math.dist(ends[1], (160.0, 0.0)) < 0.01


def test_a_slack_bridge_hangs_as_a_catenary():
    """40 planks of 1 m over a gap of 36 m, let go as a V, come to rest with the sag and the pull of a hanging rope."""
    tilt = math.acos(0.9)
    points = [(0.9 * k, -math.sin(tilt) * min(k, 40 - k)) for k in range(41)]
    planks = [
        body(
            f"p{k}", box(1.0, 0.25, mask=0), angle=-tilt if k < 20 else tilt, linear_damping=1.0, angular_damping=1.0,
            position=(0.5 * (points[k][0] + points[k + 1][0]), 0.5 * (points[k][1] + points[k + 1][1])),
        )
        for k in range(40)
    ]  # fmt: skip
    pins = [
        joint(f"j{k}", "revolute", f"p{k - 1}" if k else None, f"p{k}" if k < 40 else None, at)
        for k, at in enumerate(points)
    ]
    world = jointed(tuple(planks), tuple(pins))
    world.step(2400)
    assert gap(world) < 1e-5
    weight = float(world.state.bodies.mass.sum()) * G
    (ax, ay), (bx, by) = world.joint("j0").force, world.joint("j40").force
    assert ay - by == pytest.approx(weight, rel=1e-2)  # damping acts on what gravity gives within a substep
    # A rope of length L over a span S: L = 2 a sinh(S / 2 a), its sag a (cosh(S / 2 a) - 1), its pull w a.
    a = float(mpmath.findroot(lambda x: 2 * x * mpmath.sinh(18 / x) - 40, 22))
    assert (ax, bx) == pytest.approx((-weight / 40 * a, -weight / 40 * a), rel=5e-3)
    assert -world.joint("j20").anchors[0][1] == pytest.approx(a * (math.cosh(18 / a) - 1), rel=2e-3)


@pytest.mark.parametrize("joined", [True, False])
def test_a_heavy_ball_on_36_light_links_keeps_its_distance(joined):
    """The ball weighs 11 times as much as the whole chain."""
    links, joints = row(36, density=20.0)
    ball = body("ball", circle(4.0, density=20.0), position=(40.0, 0.0))
    joints.append(joint("j36", "revolute", "p35", "ball", (36.0, 0.0)))
    if not joined:
        links = [body(link.id, *row(1, density=20.0, mask=0)[0][0].shapes, position=link.position) for link in links]
    world = jointed((*links, ball), tuple(joints))
    for _ in range(60):
        world.step(10)
        assert gap(world) < 0.01 * 36
        assert math.hypot(*world.body("ball").position) < 40.0 * 1.01


@pytest.mark.parametrize("ratio", [1.0, 100.0])
def test_a_welded_cantilever_holds_what_hangs_on_it(ratio):
    """`ratio` is the mass at its tip by that of a plank."""
    planks, joints = row(8, "weld", density=20.0)
    tip = body("tip", circle(0.2), position=(8.0, 0.0), mass=5.0 * ratio)
    world = jointed((*planks, tip), (*joints, joint("tip", "weld", "p7", "tip", (8.0, 0.0))))
    world.step(600)
    assert gap(world) < 1e-4
    x, y = world.body("tip").position
    assert math.hypot(x - 8.0, y) < 0.01
    # Statics: the wall carries the whole weight and its moment.
    assert world.joint("j0").force == pytest.approx((0.0, (40.0 + 5.0 * ratio) * G), rel=1e-4, abs=1e-2)
    assert world.joint("j0").torque == pytest.approx((40.0 * 4.0 + 5.0 * ratio * 8.0) * G, rel=1e-3)


def test_a_chain_of_160_links_hangs_straight_and_loaded():
    """The topmost pin carries it all; no pin stretches."""
    links, joints = row(160)
    standing = [
        body(link.id, box(0.25, 1.0), position=(0.0, -0.5 - k)) for k, link in enumerate(links)
    ]  # fmt: skip
    pins = [joint(j.id, "revolute", j.body_a, j.body_b, (0.0, -float(k))) for k, j in enumerate(joints)]
    world = jointed(tuple(standing), tuple(pins))
    world.step(300)
    assert gap(world) < 1e-4
    weight = float(world.state.bodies.mass.sum()) * G
    assert world.joint("j0").force == pytest.approx((0.0, weight), rel=1e-4, abs=1e-4 * weight)
    assert world.joint("j80").force[1] == pytest.approx(0.5 * weight, rel=1e-4)
