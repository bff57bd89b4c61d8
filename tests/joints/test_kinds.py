"""Every kind of joint, with limits, motor and spring, against closed forms."""

from __future__ import annotations

import math

import pytest

from sandbox import SetTarget
from tests.flat import body, box, circle, ground
from tests.joints.jointed import G, joint, jointed

FREE = (0.0, 0.0)


def trace(world, name, steps, axis=0):
    """A coordinate of a body after each step."""
    found = []
    for _ in range(steps):
        world.step()
        found.append(world.body(name).position[axis])
    return found


def test_a_rod_keeps_its_length_and_pulls_inwards():
    """On a circle without gravity: speed and radius stay, the pull is m v^2 / r."""
    rod = joint("rod", "distance", None, "bob", anchor_a=(0.0, 0.0), anchor_b=(2.0, 0.0))
    world = jointed((body("bob", circle(0.1), position=(2.0, 0.0), velocity=(0.0, 3.0)),), (rod,), gravity=FREE)
    mass = float(world.state.bodies.mass[0])
    for _ in range(60):
        world.step(10)
        bob = world.body("bob")
        assert math.hypot(*bob.position) == pytest.approx(2.0, abs=1e-4)
        assert math.hypot(*bob.velocity) == pytest.approx(3.0, rel=1e-4)
        assert math.hypot(*world.joint("rod").force) == pytest.approx(mass * 9.0 / 2.0, rel=1e-3)


def test_a_rod_takes_the_length_it_is_given():
    rod = joint("rod", "distance", None, "bob", anchor_a=(0.0, 0.0), anchor_b=(0.0, -1.0), length=1.5)
    world = jointed((body("bob", circle(0.1), position=(0.0, -1.0)),), (rod,))
    world.step(300)
    assert world.body("bob").position == pytest.approx((0.0, -1.5), abs=1e-4)


@pytest.mark.parametrize("hertz", [0.5, 2.0, 5.0])
@pytest.mark.parametrize("ratio", [0.0, 0.1, 1.0])
def test_a_spring_swings_as_its_law_says(hertz, ratio):
    """x'' = -w^2 x - 2 z w x', between a wall and a body."""
    spring = joint(
        "s", "distance", None, "bob", anchor_a=(-3.0, 0.0), anchor_b=(0.5, 0.0), length=3.0, hertz=hertz,
        damping_ratio=ratio,
    )  # fmt: skip
    world = jointed((body("bob", circle(0.2), position=(0.5, 0.0)),), (spring,), gravity=FREE)
    omega = 2 * math.pi * hertz
    steps = int(2 * 60 / hertz)
    found = trace(world, "bob", steps)
    for step, x in enumerate(found, 1):
        t = step / 60
        if ratio < 1.0:
            damped = omega * math.sqrt(1 - ratio * ratio)
            swing = math.cos(damped * t) + ratio * omega / damped * math.sin(damped * t)
        else:
            swing = 1.0 + omega * t
        # The implicit midpoint rule is late by (w h)^2 / 12 of a swing.
        late = (omega / 240) ** 2 / 12 * omega * t
        assert x == pytest.approx(0.5 * math.exp(-ratio * omega * t) * swing, abs=0.5 * (0.01 + 1.5 * late))


def test_an_undamped_spring_keeps_its_swing():
    spring = joint("s", "distance", None, "bob", anchor_a=(-3.0, 0.0), anchor_b=(0.5, 0.0), length=3.0, hertz=2.0)
    world = jointed((body("bob", circle(0.2), position=(0.5, 0.0)),), (spring,), gravity=FREE)
    found = trace(world, "bob", 3600)
    assert max(found[-120:]) == pytest.approx(0.5, rel=0.01)
    assert min(found[-120:]) == pytest.approx(-0.5, rel=0.01)


def test_a_rope_is_slack_until_it_is_taut():
    rope = joint("rope", "distance", None, "bob", anchor_a=(0.0, 0.0), anchor_b=(0.0, -0.5), upper=2.0)
    world = jointed((body("bob", circle(0.1), position=(0.0, -0.5)),), (rope,))
    world.step(30)
    assert world.body("bob").position[1] == pytest.approx(-0.5 - 0.5 * G * 0.25, abs=1e-9)
    assert world.joint("rope").force == (0.0, 0.0)
    world.step(90)
    assert world.body("bob").position[1] == pytest.approx(-2.0, abs=1e-3)
    assert world.joint("rope").force[1] == pytest.approx(float(world.state.bodies.mass[0]) * G, rel=1e-3)


def test_a_strut_keeps_a_least_length():
    strut = joint("strut", "distance", None, "bob", anchor_a=(0.0, 0.0), anchor_b=(0.0, 2.0), lower=1.0)
    slide = joint("slide", "prismatic", None, "bob", (0.0, 2.0), axis=(0.0, 1.0))
    world = jointed((body("bob", circle(0.1), position=(0.0, 2.0)),), (strut, slide))
    world.step(120)
    assert world.body("bob").position == pytest.approx((0.0, 1.0), abs=1e-3)


def door(**fields):
    """A bar of 2 m, hinged to the world at its left end."""
    hinge = joint("hinge", "revolute", None, "bar", (0.0, 0.0), **fields)
    return (body("bar", box(2.0, 0.1), position=(1.0, 0.0)),), (hinge,)


def test_a_hinge_stops_at_its_limits():
    world = jointed(*door(lower=-0.6, upper=0.3))
    world.step(240)
    assert world.joint("hinge").angle == pytest.approx(-0.6, abs=1e-3)
    weight = float(world.state.bodies.mass[0]) * G
    assert world.joint("hinge").torque == pytest.approx(weight * math.cos(0.6), rel=1e-3)
    assert world.joint("hinge").force == pytest.approx((0.0, weight), abs=1e-3 * weight)
    world.body("bar").angular_velocity = 20.0
    angles = []
    for _ in range(20):
        world.step()
        angles.append(world.joint("hinge").angle)
    assert max(angles) == pytest.approx(0.3, abs=0.01)


def test_a_hinge_with_equal_limits_is_rigid():
    world = jointed(*door(lower=0.25, upper=0.25))
    world.step(120)
    assert world.joint("hinge").angle == pytest.approx(0.25, abs=1e-3)


def test_a_motor_turns_at_its_speed():
    world = jointed(*door(motor_speed=2.0))
    world.step(60)
    before = world.joint("hinge").angle
    world.step(60)
    assert world.joint("hinge").angle - before == pytest.approx(2.0, rel=1e-3)


def test_a_weak_motor_accelerates_by_its_torque():
    """No gravity: angular acceleration is torque by the inertia about the hinge."""
    world = jointed(*door(motor_speed=100.0, max_motor=0.5), gravity=FREE)
    bar = world.state.bodies[0]
    inertia = float(bar.inertia + bar.mass)
    world.step(60)
    assert world.body("bar").angular_velocity == pytest.approx(0.5 / inertia, rel=1e-3)
    assert world.joint("hinge").torque == pytest.approx(0.5, rel=1e-3)


def test_a_motor_too_weak_for_the_weight_gives_way():
    world = jointed(*door(motor_speed=0.0, max_motor=0.5 * 0.2 * G))
    world.step(30)
    assert world.joint("hinge").angle < -0.3
    world = jointed(*door(motor_speed=0.0, max_motor=1.1 * 0.2 * G))
    world.step(300)
    assert world.joint("hinge").angle == pytest.approx(0.0, abs=1e-3)
    assert world.joint("hinge").torque == pytest.approx(0.2 * G, rel=1e-3)


def test_a_hinge_spring_swings_as_its_law_says():
    """Without gravity, about an anchor that does not move: `hertz` is that of the bar as the hinge lets it turn."""
    world = jointed(*door(hertz=1.0, rest=0.5), gravity=FREE)
    angles = []
    for _ in range(240):
        world.step()
        angles.append(world.joint("hinge").angle)
    assert max(angles) == pytest.approx(1.0, abs=0.01)
    assert min(angles) == pytest.approx(0.0, abs=0.01)


def test_a_slide_falls_along_its_axis():
    """On an axis of 30 degrees a body without friction slides with g sin 30."""
    axis = (math.cos(math.pi / 6), math.sin(math.pi / 6))
    slide = joint("slide", "prismatic", None, "sled", (0.0, 0.0), axis=axis)
    world = jointed((body("sled", box(1.0, 0.4), angle=math.pi / 6),), (slide,))
    world.step(60)
    assert world.joint("slide").translation == pytest.approx(-0.5 * G * 0.5, rel=1e-4)
    assert world.body("sled").angle == pytest.approx(math.pi / 6, abs=1e-6)
    x, y = world.body("sled").position
    assert x * axis[1] - y * axis[0] == pytest.approx(0.0, abs=1e-6)
    mass = float(world.state.bodies.mass[0])
    normal = mass * G * math.cos(math.pi / 6)
    assert world.joint("slide").force == pytest.approx((-normal * axis[1], normal * axis[0]), rel=1e-4)


def lift(**fields):
    """A car on an upright slide."""
    slide = joint("slide", "prismatic", None, "car", (0.0, 0.0), axis=(0.0, 1.0), **fields)
    return (body("car", box(1.0, 1.0), fixed_rotation=False),), (slide,)


def test_a_slide_has_limits():
    world = jointed(*lift(lower=-2.0, upper=1.0))
    world.step(180)
    assert world.joint("slide").translation == pytest.approx(-2.0, abs=1e-3)
    world.body("car").velocity = (0.0, 30.0)
    assert max(trace(world, "car", 10, axis=1)) == pytest.approx(1.0, abs=0.02)


def test_a_slide_has_a_motor():
    world = jointed(*lift(motor_speed=0.5, upper=2.0))
    world.step(120)
    assert world.joint("slide").translation == pytest.approx(1.0, rel=5e-3)
    world.step(180)
    assert world.joint("slide").translation == pytest.approx(2.0, abs=1e-3)
    assert world.joint("slide").force[1] == pytest.approx(G, rel=1e-3)


def test_a_slide_motor_gives_no_more_than_its_force():
    world = jointed(*lift(motor_speed=0.0, max_motor=0.75 * G))
    world.step(60)
    assert world.body("car").velocity[1] == pytest.approx(-0.25 * G, rel=1e-4)


def test_a_slide_spring_sags_by_g_over_omega_squared():
    world = jointed(*lift(hertz=1.0, damping_ratio=0.5))
    world.step(600)
    assert world.joint("slide").translation == pytest.approx(-G / (2 * math.pi) ** 2, rel=1e-3)


def test_a_soft_weld_sags_by_g_over_omega_squared():
    weld = joint("weld", "weld", None, "sign", (0.0, 0.0), hertz=2.0, damping_ratio=1.0, angular_hertz=2.0)
    world = jointed((body("sign", box(1.0, 1.0)),), (weld,))
    world.step(600)
    assert world.body("sign").position == pytest.approx((0.0, -G / (4 * math.pi) ** 2), rel=1e-3, abs=1e-6)


def test_a_rigid_weld_holds_a_spinning_pair_together():
    pair = (
        body("a", box(1.0, 1.0), velocity=(0.0, -4.0), angular_velocity=8.0),
        body("b", box(1.0, 1.0), position=(1.0, 0.0), velocity=(0.0, 4.0), angular_velocity=8.0),
    )
    world = jointed(pair, (joint("weld", "weld", "a", "b", (0.5, 0.0)),), gravity=FREE)
    world.step(300)
    a, b = world.body("a"), world.body("b")
    assert math.dist(a.position, b.position) == pytest.approx(1.0, abs=1e-3)
    assert b.angle == pytest.approx(a.angle, abs=1e-4)
    assert (a.angular_velocity, b.angular_velocity) == pytest.approx((8.0, 8.0), rel=1e-4)


def test_a_wheel_is_sprung_along_its_axis():
    """Car and wheels apart by the sag of the suspension, g / w^2 of the sprung mass, when the car stands."""
    car = body("car", box(4.0, 1.0), position=(0.0, 1.5))
    wheels = [body(f"w{k}", circle(0.5), position=(x, 0.5), mass=1.0) for k, x in enumerate((-1.5, 1.5))]
    axles = [
        joint(f"a{k}", "wheel", "car", f"w{k}", (x, 0.5), axis=(0.0, 1.0), hertz=3.0, damping_ratio=0.7)
        for k, x in enumerate((-1.5, 1.5))
    ]
    world = jointed((ground(), car, *wheels), tuple(axles))
    world.step(600)
    # The spring feels both bodies, 1 / m = 1 / 4 + 1 / 1; each axle carries 2 kg of the car.
    sag = 2.0 * G * (0.25 + 1.0) / (6 * math.pi) ** 2
    assert world.joint("a0").translation == pytest.approx(sag, rel=5e-3)
    assert world.body("car").angle == pytest.approx(0.0, abs=1e-3)


def test_a_wheel_motor_drives_the_car():
    """Rolling without slip: speed is motor speed times radius."""
    car = body("car", box(4.0, 1.0), position=(0.0, 1.5))
    wheels = [body(f"w{k}", circle(0.5, friction=1.5), position=(x, 0.5), mass=1.0) for k, x in enumerate((-1.5, 1.5))]
    axles = [
        joint(
            f"a{k}", "wheel", "car", f"w{k}", (x, 0.5), axis=(0.0, 1.0), hertz=4.0, damping_ratio=0.7,
            motor_speed=-6.0, max_motor=10.0,
        )
        for k, x in enumerate((-1.5, 1.5))
    ]  # fmt: skip
    world = jointed((ground(friction=1.5), car, *wheels), tuple(axles))
    world.step(600)
    assert world.body("car").velocity[0] == pytest.approx(3.0, rel=0.02)


def test_a_gear_couples_two_angles():
    """ratio 2: angle a + 2 angle b stays; both motors' work goes through."""
    discs = (body("a", circle(1.0)), body("b", circle(0.5), position=(1.5, 0.0)))
    pins = (
        joint("pa", "revolute", None, "a", (0.0, 0.0), motor_speed=3.0),
        joint("pb", "revolute", None, "b", (1.5, 0.0)),
        joint("gear", "gear", None, None, joints=("pa", "pb"), ratio=0.5),
    )
    world = jointed(discs, pins)
    world.step(300)
    assert world.body("a").angular_velocity == pytest.approx(3.0, rel=1e-3)
    assert world.body("b").angular_velocity == pytest.approx(-6.0, rel=1e-3)
    assert world.joint("pa").angle + 0.5 * world.joint("pb").angle == pytest.approx(0.0, abs=1e-4)


def test_a_rack_and_pinion():
    """Angle + slide / r stays: the rack falls and turns the wheel, a = g m r^2 / (I + m r^2)."""
    parts = (body("wheel", circle(0.5, mask=0)), body("rack", box(0.2, 2.0, mask=0), position=(0.6, 0.0)))
    ties = (
        joint("pin", "revolute", None, "wheel", (0.0, 0.0)),
        joint("slide", "prismatic", None, "rack", (0.6, 0.0), axis=(0.0, 1.0)),
        joint("gear", "gear", None, None, joints=("pin", "slide"), ratio=-2.0),
    )
    world = jointed(parts, ties)
    wheel, rack = world.state.bodies
    a = G * float(rack.mass) * 0.25 / (float(wheel.inertia) + float(rack.mass) * 0.25)
    world.step(60)
    assert world.body("rack").velocity[1] == pytest.approx(-a, rel=1e-3)
    assert world.joint("slide").translation == pytest.approx(-0.5 * a, rel=1e-3)
    assert world.joint("pin").angle == pytest.approx(2.0 * world.joint("slide").translation, rel=1e-4)


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_a_pulley_is_atwoods_machine(ratio):
    """length 1 + r length 2 stays: a2 = g (r m1 - m2) / (m2 + r^2 m1) upwards... with T along both ropes."""
    weights = (
        body("a", box(1.0, 1.0), position=(-2.0, 0.0), mass=3.0),
        body("b", box(1.0, 1.0), position=(2.0, 0.0), mass=2.0),
    )
    rope = joint(
        "rope", "pulley", "a", "b", anchor_a=(-2.0, 0.5), anchor_b=(2.0, 0.5), points=((-2.0, 8.0), (2.0, 8.0)),
        ratio=ratio,
    )  # fmt: skip
    world = jointed(weights, (rope,))
    # m1 a1 = m1 g - T, m2 a2 = m2 g - r T, a1 + r a2 = 0, both downwards.
    tension = G * (1 + ratio) / (1 / 3.0 + ratio * ratio / 2.0)
    world.step(30)
    assert world.body("a").velocity[1] == pytest.approx(-0.5 * (G - tension / 3.0), rel=1e-3)
    assert world.body("b").velocity[1] == pytest.approx(-0.5 * (G - ratio * tension / 2.0), rel=1e-3)
    assert world.joint("rope").force[1] == pytest.approx(ratio * tension, rel=1e-3)


def test_a_motor_joint_drives_to_a_pose():
    drive = joint(
        "drive", "motor", None, "crate", (0.0, 0.0), points=((1.0, 2.0),), angle=0.5, hertz=2.0, damping_ratio=1.0,
        angular_hertz=2.0, angular_damping_ratio=1.0,
    )  # fmt: skip
    world = jointed((body("crate", box(1.0, 1.0)),), (drive,), gravity=FREE)
    world.step(300)
    assert world.body("crate").position == pytest.approx((1.0, 2.0), abs=1e-3)
    assert world.body("crate").angle == pytest.approx(0.5, abs=1e-3)


def test_a_motor_joint_gives_no_more_than_its_force_and_torque():
    drive = joint(
        "drive", "motor", None, "crate", (0.0, 0.0), points=((40.0, 30.0),), angle=40.0, hertz=5.0,
        damping_ratio=1.0, angular_hertz=5.0, angular_damping_ratio=1.0, max_force=2.0, max_torque=0.1,
    )  # fmt: skip
    world = jointed((body("crate", box(1.0, 1.0)),), (drive,), gravity=FREE)
    world.step(60)
    assert world.body("crate").velocity == pytest.approx((1.6, 1.2), rel=1e-2)
    assert world.body("crate").angular_velocity == pytest.approx(0.6, rel=1e-2)
    assert math.hypot(*world.joint("drive").force) == pytest.approx(2.0, rel=1e-3)


def test_a_target_pulls_to_a_point_and_can_be_moved():
    mouse = joint("mouse", "target", None, "crate", (0.5, 0.5), points=((3.0, 1.0),), hertz=4.0, damping_ratio=1.0)
    world = jointed((body("crate", box(1.0, 1.0), angular_damping=3.0),), (mouse,), gravity=FREE)
    world.step(300)
    assert world.joint("mouse").anchors[1] == pytest.approx((3.0, 1.0), abs=1e-2)
    world.apply(SetTarget("mouse", (-2.0, 4.0)))
    world.step(300)
    assert world.joint("mouse").anchors[1] == pytest.approx((-2.0, 4.0), abs=1e-2)


def test_a_weak_target_lifts_nothing():
    mouse = joint("mouse", "target", None, "crate", (0.0, 0.5), points=((0.0, 9.0),), hertz=4.0, max_force=0.9 * G)
    world = jointed((ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5))), (mouse,))
    world.step(120)
    assert world.body("crate").position[1] == pytest.approx(0.5, abs=2e-3)
    assert world.joint("mouse").force[1] == pytest.approx(0.9 * G, rel=1e-3)


@pytest.mark.parametrize("torque", [0.0, 0.02])
def test_friction_stops_after_v_squared_over_two_a(torque):
    """Seen from above: 2 N on 1 kg stop 3 m/s after 2.25 m; the torque stops the spin in its own time."""
    rub = joint("rub", "friction", None, "puck", (0.0, 0.0), max_force=2.0, max_torque=torque)
    puck = body("puck", circle(0.5), mass=1.0, velocity=(2.4, 1.8), angular_velocity=1.0)
    world = jointed((puck,), (rub,), gravity=FREE)
    inertia = float(world.state.bodies.inertia[0])
    world.step(60)
    assert world.body("puck").angular_velocity == pytest.approx(1.0 - torque / inertia, rel=1e-3)
    world.step(60)
    assert world.body("puck").velocity == pytest.approx((0.0, 0.0), abs=1e-9)
    assert math.hypot(*world.body("puck").position) == pytest.approx(2.25, rel=5e-3)
