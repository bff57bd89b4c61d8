"""Nets that are too dense to be factorised: they gain no energy, come to rest, and do what factorised ones do."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox import Scene
from sandbox.engine.joints import net_lanes, part_layout
from sandbox.engine.world import World
from tests.flat import body, box
from tests.joints.jointed import G, energy, gap, joint, jointed
from tests.joints.nets import KINDS, kinetic_energy, net, soft_parts, throw

HANGING = ("top", "middle", "corner")
LIMITED = 0.2
"""How far the sliders of a net may slide, in m."""


@pytest.fixture
def never_factorised(monkeypatch):
    """Makes all joints soft, those of a single rod too."""
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)


@pytest.mark.usefixtures("never_factorised")
@pytest.mark.parametrize(
    ("hung", "substeps"),
    [
        ("corner", 4),
        ("top", 1),
        *(pytest.param(hung, n, marks=pytest.mark.slow) for hung in HANGING for n in (1, 4, 8)),
    ],
)
@pytest.mark.parametrize("kind", KINDS)
def test_a_hanging_net_gains_no_energy(kind, hung, substeps):
    world = net(12, 12, kind, hung, substeps)
    assert soft_parts(world) == 1
    start = energy(world)
    weight = float(world.state.bodies.mass.sum()) * G
    for _ in range(12):
        world.step(10)
        assert energy(world) < start + 1e-3 * weight
    assert len(world.frozen) == 0


@pytest.mark.slow
@pytest.mark.parametrize(("across", "down"), [(40, 40), (100, 100), (300, 6)])
@pytest.mark.parametrize("kind", ["hinge", "weld", "slider", "rod"])
def test_a_large_net_gains_no_energy(kind, across, down):
    world = net(across, down, kind, "top")
    start = energy(world)
    weight = float(world.state.bodies.mass.sum()) * G
    for _ in range(6):
        world.step(10)
        assert energy(world) < start + 1e-3 * weight
    if kind != "slider":
        assert gap(world) < (1.05 if kind == "rod" else 0.2)


@pytest.mark.usefixtures("never_factorised")
@pytest.mark.parametrize(
    ("kind", "braced"),
    [
        *((kind, False) for kind in ("hinge", "weld", "slider", "spring")),
        *(pytest.param(kind, braced, marks=pytest.mark.slow) for kind in KINDS for braced in (False, True)),
    ],
)
def test_a_net_thrown_about_comes_to_less_energy(kind, braced):
    random = np.random.default_rng(len(kind))
    for speed, apart in ((30.0, 0.0), (1000.0, 0.3)):
        world = net(12, 12, kind, "nothing", braced=braced)
        world.state.settings.gravity_y = 0.0
        assert soft_parts(world) == 1
        throw(world, random, speed, apart)
        start = kinetic_energy(world)
        for _ in range(6):
            world.step(5)
            assert kinetic_energy(world) < {"spring": 0.9, "friction": 1.0}.get(kind, 0.5) * start
        assert len(world.frozen) == 0


@pytest.mark.parametrize("kind", ["hinge", "weld", "slider", "stopped hinge"])
def test_a_net_drawn_apart_comes_together(kind):
    world = net(12, 12, kind, "nothing")
    world.state.settings.gravity_y = 0.0
    throw(world, np.random.default_rng(3), 0.0, 0.3)
    assert gap(world) > 0.5
    world.step(180)
    assert gap(world) < LIMITED if kind == "slider" else gap(world) < 1e-3


@pytest.mark.parametrize("kind", ["hinge", "weld", "rod", "stopped hinge"])
def test_a_net_at_rest_hangs_as_a_factorised_one_does(monkeypatch, kind):
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", 10**6)
    rigid = net(5, 5, kind)
    assert soft_parts(rigid) == 0
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)
    soft = net(5, 5, kind)
    assert soft_parts(soft) == 1
    for world in (rigid, soft):
        world.step(120)
    apart = np.abs(np.array(rigid.bodies.position) - np.array(soft.bodies.position))
    assert apart.max() < 5e-3


@pytest.mark.parametrize("kind", ["hinge", "rod"])
def test_a_net_swings_as_a_factorised_one_does(monkeypatch, kind):
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", 10**6)
    rigid = net(6, 6, kind, "middle")
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)
    soft = net(6, 6, kind, "middle")
    assert [soft_parts(world) for world in (rigid, soft)] == [0, 1]
    for _ in range(6):
        for world in (rigid, soft):
            world.step(10)
        apart = np.abs(np.array(rigid.bodies.position) - np.array(soft.bodies.position))
        assert apart.max() < 0.05


@pytest.mark.usefixtures("never_factorised")
@pytest.mark.parametrize("kind", ["hinge", "rod", "spring", "weld"])
def test_free_nets_keep_their_momentum(kind):
    world = net(14, 14, kind, "nothing")
    world.state.settings.gravity_y = 0.0
    throw(world, np.random.default_rng(5), 5.0, 0.0)
    b = world.state.bodies

    def momentum() -> tuple[float, float, float]:
        turning = b.inertia * b.angular_velocity + b.mass * (b.center_x * b.velocity_y - b.center_y * b.velocity_x)
        return float((b.mass * b.velocity_x).sum()), float((b.mass * b.velocity_y).sum()), float(turning.sum())

    start = momentum()
    size = float((b.mass * np.abs(b.velocity_x)).sum())
    world.step(60)
    assert np.allclose(momentum(), start, rtol=0.0, atol=1e-10 * size)


@pytest.mark.parametrize("spring", [{}, {"hertz": 4.0, "damping_ratio": 0.2}])
def test_a_rod_in_a_lane_does_what_one_that_is_swept_alone_does(monkeypatch, spring):
    def swinging():
        boxes = tuple(body(f"b{k}", box(1.0, 0.5), position=(2.0 * k, 0.0), angular_velocity=3.0) for k in range(3))
        rods = (
            joint("r0", "distance", None, "b0", anchor_a=(-1.0, 1.0), anchor_b=(-0.4, 0.2), **spring),
            joint("r1", "distance", "b1", "b2", anchor_a=(2.4, 0.2), anchor_b=(3.6, -0.2), **spring),
        )
        return jointed(boxes, rods)

    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -(10**6))
    laid = swinging()
    monkeypatch.setattr(net_lanes, "MAX_COLORS", 0)
    swept = swinging()
    assert [len(world.scratch.joints.side_by_side.joints) for world in (laid, swept)] == [2, 0]
    for _ in range(12):
        for world in (laid, swept):
            world.step(5)
        for one, other in ((laid.state.bodies, swept.state.bodies), (laid.state.joints, swept.state.joints)):
            for name in one.dtype.names:
                if name not in ("force_x", "force_y"):  # a swept one tells its size along where it lies last
                    assert np.allclose(one[name], other[name], rtol=1e-9, atol=1e-9), name


@pytest.mark.usefixtures("never_factorised")
@pytest.mark.parametrize("kind", ["rod", "spring", "weld", "hinge", "slider"])
def test_what_hangs_on_the_world_moves_as_what_hangs_on_something_static(kind):
    worlds = [net(8, 8, kind, "corner"), net(8, 8, kind, "corner", post=True)]
    assert [soft_parts(world) for world in worlds] == [1, 1]
    for _ in range(10):
        for world in worlds:
            world.step(6)
        free, held = (np.array(world.bodies.position)[:64] for world in worlds)
        assert np.allclose(free, held, rtol=0.0, atol=1e-9)
    assert np.abs(free - np.array(net(8, 8, kind, "corner").bodies.position)).max() > 0.1


@pytest.mark.parametrize("kind", ["rod", "weld", "hinge"])
def test_joints_in_lanes_tell_the_weight_that_hangs_on_them(monkeypatch, kind):
    """Three boxes below each other, of which a weld holds the last by its side: the joint above bears all of them."""
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -(10**6))
    boxes = tuple(body(f"b{k}", box(0.8, 0.8), position=(0.0, -1.0 * k)) for k in range(3))
    side = body("side", box(0.8, 0.8), position=(1.0, -2.0))
    links = []
    for k in range(3):
        above = f"b{k - 1}" if k else None
        if kind == "rod":
            ends = {"anchor_a": (0.0, 0.6 - k), "anchor_b": (0.0, 0.4 - k)}
            links.append(joint(f"j{k}", "distance", above, f"b{k}", **ends))
        else:
            links.append(joint(f"j{k}", at=(0.0, 0.5 - k), a=above, b=f"b{k}", **KINDS[kind]))
    if kind == "weld":
        links.append(joint("arm", at=(0.5, -2.0), a="b2", b="side", **KINDS[kind]))
        boxes = (*boxes, side)
    world = jointed(boxes, tuple(links))
    assert len(world.scratch.joints.side_by_side.joints) == len(links)
    world.step(1200)
    mass = float(world.state.bodies.mass[0])
    joints = world.state.joints
    assert float(joints.force_y[0]) == pytest.approx(len(boxes) * mass * G, rel=1e-3)
    if kind == "weld":
        assert float(joints.force_y[3]) == pytest.approx(mass * G, rel=1e-3)
        assert float(joints.torque[3]) == pytest.approx(0.5 * mass * G, rel=0.02)  # it swings down a little


@pytest.mark.parametrize("side", [12, 24])
def test_rods_of_a_cloth_yield_as_springs_of_a_quarter_of_the_rate_of_substeps(side):
    """The second rod of each column bears all bodies below it by the reduced mass of two of them."""
    world = net(side, side, "rod", "top")
    assert soft_parts(world) == 1
    world.step(240)
    assert gap(world) - 1.0 == pytest.approx(2.0 * (side - 1) * G / (2.0 * np.pi * 60.0) ** 2, rel=0.01)


def loaded_net(kind: str, side: int, load: float) -> World:
    """A net of discs of 1 kg, 1 m apart, that hangs by a corner; the disc farthest from it has the mass `load` (kg)."""
    places = [(x, y) for x in range(side) for y in range(side)]
    disc = {"shapes": [{"circle": 0.4, "mask": 0}]}
    bodies = [{"id": f"{x}-{y}", "position": [x, -y], "mass": 1, **disc} for x, y in places]
    bodies[-1]["mass"] = load
    joints = [
        {"id": f"{x}-{y}:{a}-{b}", "bodies": [f"{x}-{y}", f"{a}-{b}"], "anchor": [0.5 * (x + a), -0.5 * (y + b)]}
        for x, y in places
        for a, b in ((x + 1, y), (x, y + 1))
        if (a, b) in places
    ]
    joints = [{**each, "type": kind} for each in joints]
    joints.append({"id": "hook", "type": "revolute", "bodies": ["0-0"], "anchor": [0, 0.4]})
    return World(Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))


@pytest.mark.usefixtures("never_factorised")
@pytest.mark.parametrize(("kind", "side", "box2d"), [("weld", 5, 0.33), ("revolute", 8, 0.28)])
def test_a_thousand_times_the_mass_of_its_bodies_hangs_on_a_net(kind, side, box2d):
    """While it swings, joints part no more than by half as much again as those of Box2D."""
    world = loaded_net(kind, side, 1000.0)
    assert soft_parts(world) == 1
    for _ in range(60):
        world.step(5)
        assert gap(world) < 1.5 * box2d


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["hinge", "weld"])
def test_a_net_hangs_by_a_corner_at_a_single_substep(kind):
    world = net(16, 16, kind, "corner", 1)
    for _ in range(60):
        world.step(10)
        assert gap(world) < 1.2
