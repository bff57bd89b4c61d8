"""Joints from the first step to the break: collisions, breaking, switching, sleep, commands."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import sandbox
from sandbox import ApplyForce, BreakJoint, SetJoint, SetLimits, SetMotor, SetPose, SetSpring
from sandbox._jit import interpreted
from sandbox.engine.joints.direct.reports import finish_report
from sandbox.errors import CommandError, UnknownJointError
from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, circle, ground
from tests.joints.jointed import G, joint, jointed, row

SLEEPY = FlatSettings()


@pytest.mark.parametrize("collide", [False, True])
def test_joined_bodies_collide_only_if_their_joint_says_so(collide):
    pair = (body("a", box(1.0, 1.0), velocity=(1.0, 0.0)), body("b", box(1.0, 1.0), position=(3.0, 0.0)))
    rope = joint("rope", "distance", "a", "b", anchor_a=(0.0, 0.0), anchor_b=(3.0, 0.0), upper=5.0, collide=collide)
    world = jointed(pair, (rope,), gravity=(0.0, 0.0))
    world.step(240)
    assert (world.body("a").position[0] > world.body("b").position[0]) != collide


def hung(**fields):
    """A 1 kg crate hung from the world by a pin."""
    return jointed(
        (body("crate", box(1.0, 1.0), position=(0.0, -1.0)),),
        (joint("pin", "revolute", None, "crate", (0.0, 0.0), **fields),),
    )


def test_it_breaks_above_its_force_and_not_below():
    world = hung(break_force=1.01 * G)
    world.step(60)
    assert not world.joint("pin").broken
    world = hung(break_force=0.99 * G)
    world.step(60)
    assert world.joint("pin").broken_step == 0
    assert world.body("crate").position[1] < -4.0
    assert world.joint("pin").force[1] == pytest.approx(G, rel=1e-3)


@pytest.mark.parametrize(("limit", "breaks"), [(0.99, True), (1.01, False)])
def test_it_breaks_above_its_torque(limit, breaks):
    arm = body("arm", box(2.0, 0.5), position=(1.0, 0.0))
    weld = joint("weld", "weld", None, "arm", (0.0, 0.0), break_torque=limit * G)
    world = jointed((arm,), (weld,))
    world.step(120)
    assert world.joint("weld").broken is breaks


def test_a_bridge_that_is_cut_falls_in_two():
    planks, joints = row(10, pin="both")
    world = jointed(tuple(planks), tuple(joints))
    world.step(30)
    world.apply(BreakJoint("j5"))
    lowest = {"p4": 0.0, "p5": 0.0}
    for _ in range(120):
        world.step()
        lowest = {name: min(low, world.body(name).position[1]) for name, low in lowest.items()}
    assert max(lowest.values()) < -4.0
    assert math.dist(world.joint("j0").anchors[0], world.joint("j0").anchors[1]) < 1e-3
    assert world.joint("j5").broken_step == 30


def test_it_can_be_switched_off_and_on():
    world = hung(enabled=False)
    world.step(30)
    assert world.body("crate").position[1] == pytest.approx(-1.0 - 0.5 * G * 0.25, rel=1e-9)
    world.apply(SetJoint("pin", True))
    world.step(240)
    (ax, ay), (bx, by) = world.joint("pin").anchors
    assert math.hypot(bx - ax, by - ay) < 1e-3


def test_motors_limits_and_springs_change_at_run_time():
    hinge = joint("hinge", "revolute", None, "bar", (0.0, 0.0))
    world = jointed((body("bar", box(2.0, 0.2), position=(1.0, 0.0)),), (hinge,), gravity=(0.0, 0.0))
    world.apply(SetMotor("hinge", 1.0))
    world.step(60)
    assert world.joint("hinge").angle == pytest.approx(1.0, rel=1e-2)
    world.apply(SetLimits("hinge", -0.5, 1.25))
    world.step(60)
    assert world.joint("hinge").angle == pytest.approx(1.25, abs=1e-3)
    world.apply(SetMotor("hinge", None))
    world.apply(SetSpring("hinge", 1.0, 1.0, 0.25))
    world.step(300)
    assert world.joint("hinge").angle == pytest.approx(0.25, abs=1e-3)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_limit_that_bears_a_load_can_be_taken_away(side):
    """What was pressed against it moves on as if there had never been one: v = F / m dt."""
    slide = joint("slide", "prismatic", None, "box", (0.0, 0.0), axis=(1.0, 0.0), lower=-0.1, upper=0.1)
    world = jointed((body("box", box(1.0, 1.0)),), (slide,), gravity=(0.0, 0.0))
    for step in range(60):
        if step == 59:
            world.apply(SetLimits("slide", -0.1, None) if side > 0.0 else SetLimits("slide", None, 0.1))
        world.apply(ApplyForce("box", (5.0 * side, 0.0)))
        world.step()
    assert world.body("box").velocity == pytest.approx((5.0 * side / 60.0, 0.0), abs=1e-9)
    assert world.joint("slide").force == pytest.approx((0.0, 0.0), abs=1e-9)


@pytest.mark.parametrize("command", [SetMotor("turn", 50.0, 1.0), SetMotor("turn", None)])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_motor_beside_one_limit_becomes_weaker(command, side):
    """It gives what it can, whatever it gave before: the limit that is not there holds nothing."""
    stop = {"lower": -3.0} if side > 0.0 else {"upper": 3.0}
    turn = joint("turn", "revolute", None, "box", (0.0, 0.0), motor_speed=-50.0 * side, max_motor=5.0, **stop)
    world = jointed((body("box", box(1.0, 1.0)),), (turn,), gravity=(0.0, 0.0))
    world.step(3)
    before = world.body("box").angular_velocity
    world.apply(replace(command, speed=command.speed and -50.0 * side))
    world.step()
    wanted = -side if command.speed else 0.0
    assert world.joint("turn").torque == pytest.approx(wanted, abs=1e-9)
    gained = world.body("box").angular_velocity - before
    assert gained == pytest.approx(wanted / world.body("box").inertia / 60.0, abs=1e-9)


@pytest.mark.parametrize("numbers", [(math.nan, 0.0, 0.0), (0.0, math.inf, 1.0), (1.0, 2.0, math.nan)])
def test_a_joint_whose_bodies_bad_numbers_froze_gives_nothing_and_can_be_gone_back_to(numbers):
    """What is no number, in a snapshot, is a damage that refuses it."""
    hinge = joint("hinge", "revolute", None, "bar", (0.0, 0.0), break_force=1e9)
    world = jointed((body("bar", box(2.0, 0.2), position=(1.0, 0.0)),), (hinge,))
    world.step(3)
    row = world.state.joints[0]
    row.impulse_0 = math.nan
    assert interpreted(finish_report)(row, *numbers, 3) == 0
    assert world.joint("hinge").force == (0.0, 0.0)
    assert world.joint("hinge").torque == 0.0
    world.restore(world.snapshot())


def test_what_hangs_still_falls_asleep_and_wakes_as_one():
    planks, joints = row(4, pin="both")
    world = jointed((*planks, body("rock", circle(0.3), position=(2.0, 40.0))), tuple(joints), settings=SLEEPY)
    world.step(100)
    assert [world.body(f"p{k}").awake for k in range(4)] == [False] * 4
    assert world.joint("j0").force[1] == pytest.approx(0.5 * G, rel=0.05)  # a taut bridge still quivers
    world.step(140)
    assert all(world.body(f"p{k}").awake for k in range(4))


def test_breaking_a_joint_wakes_what_it_held():
    world = jointed(
        (body("crate", box(1.0, 1.0), position=(0.0, -1.0)),),
        (joint("pin", "revolute", None, "crate", (0.0, 0.0)),),
        settings=SLEEPY,
    )
    world.step(120)
    assert not world.body("crate").awake
    world.apply(BreakJoint("pin"))
    world.step(60)
    assert world.body("crate").position[1] < -4.0


def test_a_moved_base_wakes_what_hangs_from_it():
    base = body("base", box(1.0, 1.0), type="static", position=(0.0, 3.0))
    crate = body("crate", box(1.0, 1.0), position=(0.0, 1.0))
    world = jointed((base, crate), (joint("pin", "revolute", "base", "crate", (0.0, 2.5)),), settings=SLEEPY)
    world.step(120)
    assert not world.body("crate").awake
    world.apply(SetPose("base", (0.2, 3.0), 0.0))
    world.step(120)
    assert world.body("crate").awake or world.body("crate").position[0] > 0.0
    (ax, ay), (bx, by) = world.joint("pin").anchors
    assert math.hypot(bx - ax, by - ay) < 1e-3


def test_a_kinematic_crank_drives_what_is_joined_to_it():
    crank = body("crank", circle(0.5), type="kinematic", angular_velocity=2.0)
    arm = body("arm", box(1.0, 0.2), position=(0.5, 0.0))
    world = jointed((crank, arm), (joint("weld", "weld", "crank", "arm", (0.5, 0.0)),), settings=SLEEPY)
    world.step(180)
    assert world.body("arm").angle == pytest.approx(6.0, abs=1e-2)
    assert world.body("arm").awake


def test_a_welded_stack_stands_on_the_ground():
    crates = [body(f"c{k}", box(1.0, 1.0), position=(0.0, k + 0.5)) for k in range(6)]
    welds = [joint(f"w{k}", "weld", f"c{k}", f"c{k + 1}", (0.0, k + 1.0)) for k in range(5)]
    world = jointed((ground(), *crates), tuple(welds))
    world.step(600)
    assert world.body("c5").position == pytest.approx((0.0, 5.5), abs=5e-3)
    assert world.joint("w0").force[1] == pytest.approx(5 * G, rel=1e-2)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (SetMotor("rod", 1.0), "no motor"),
        (SetMotor("hinge", math.nan), "finite"),
        (SetMotor("hinge", 1e9), "past the limit"),
        (SetLimits("hinge", 1.0, 0.0), "lower must not be greater"),
        (SetSpring("hinge", -1.0), "must not be negative"),
        (SetSpring("hinge", 2.0, 0.5, 1e12), "rest of 1e\\+12 is past the limit"),
        (SetLimits("hinge", None, 1e100), "upper of 1e\\+100 is past the limit"),
        (SetSpring("rod", 2.0, 0.5, -1.0), "rest is a length here, and must not be negative"),
        (SetLimits("rod", -5.0, -3.0), "upper is a length here"),
    ],
)
def test_a_command_that_cannot_be_done_changes_nothing(command, words):
    ties = (
        joint("hinge", "revolute", None, "a", (0.0, 0.0)),
        joint("rod", "distance", "a", "b", anchor_a=(0.0, 0.0), anchor_b=(2.0, 0.0)),
    )
    world = jointed((body("a", circle(0.5)), body("b", circle(0.5), position=(2.0, 0.0))), ties)
    before = world.snapshot()
    with pytest.raises(CommandError, match=words):
        world.apply(command)
    assert world.snapshot() == before


def test_an_unknown_joint_gets_the_nearest_name():
    with pytest.raises(UnknownJointError, match="did you mean 'pin'"):
        hung().joint("pim")


@pytest.mark.parametrize("kind", ["revolute", "weld", "distance", "limit"])
def test_bodies_do_not_fall_asleep_while_a_joint_draws_them_together(kind):
    """A joint that is switched on far off draws at 4 m/s, which is no speed of theirs."""
    at = {"anchors": [[-1, 0], [0, 0]]} if kind == "distance" else {"anchor": [0, 0]}
    if kind == "limit":
        at["axis"] = [1, 0]
    joint = {"id": "j", "type": "prismatic" if kind == "limit" else kind, "bodies": ["a"], "enabled": False, **at}
    bodies = [
        {"id": "a", "shapes": [{"box": [1, 1]}], "position": [0, 0]},
        {"id": "last", "shapes": [{"box": [1, 1]}], "position": [0, 90]},
    ]
    world = sandbox.World(sandbox.Scene(gravity=(0, 0), bodies=bodies, joints=[joint]))
    world.apply(SetPose("a", (12.0, 0.0), 0.0))
    world.apply(SetJoint("j", True))
    if kind == "limit":
        world.apply(SetLimits("j", -0.5, 0.5))
    for _ in range(150):
        world.step()
        assert world.body("a").awake
    assert not world.body("last").awake
    world.step(200)
    assert world.body("a").position == pytest.approx((0.5 if kind == "limit" else 0.0, 0.0), abs=1e-3)
    assert world.awake_count == 0
