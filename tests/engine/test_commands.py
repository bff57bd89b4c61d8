"""Commands: what they do, what they refuse, and that a refusal leaves the world as it was."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyForce, EndDrag, MoveDrag, SetGravity, SetPose, SetSurface, SetVelocity, Spawn, StartDrag
from sandbox.engine.commands import checks
from sandbox.engine.world import World
from sandbox.errors import CommandError, SandboxError, UnknownBodyError
from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, circle, ground, world

BAD = [math.nan, math.inf, -math.inf]
HUGE = [1e300, -1e300, 1e10]


def small() -> World:
    """Ground, a platform, a crate and a ball."""
    return world(
        ground(),
        body("platform", box(2.0, 0.2), type="kinematic", position=(4.0, 2.0)),
        body("crate", box(1.0, 1.0, (0.1, 0.0)), position=(0.0, 0.5)),
        body("ball", circle(0.3), position=(0.0, 2.0)),
    )


def refused(w: World, command, error=CommandError) -> str:
    """The world refuses a command and stays bit for bit the same; gives the message."""
    before = w.digest()
    with pytest.raises(error) as caught:
        w.apply(command)
    assert isinstance(caught.value, SandboxError)
    assert w.digest() == before
    return str(caught.value)


@pytest.mark.parametrize("bad", BAD)
@pytest.mark.parametrize(
    "make",
    [
        lambda x: SetPose("crate", (x, 0.0), 0.0),
        lambda x: SetPose("crate", (0.0, x), 0.0),
        lambda x: SetPose("crate", (0.0, 0.0), x),
        lambda x: SetVelocity("crate", (x, 0.0), 0.0),
        lambda x: SetVelocity("crate", (0.0, 0.0), x),
        lambda x: ApplyForce("crate", (0.0, x)),
        lambda x: ApplyForce("crate", (0.0, 0.0), x),
        lambda x: StartDrag("crate", (x, 0.0)),
        lambda x: StartDrag("crate", (0.0, 0.0), x),
    ],
)
def test_numbers_that_are_none_are_refused(make, bad):
    message = refused(small(), make(bad))
    assert "crate" in message
    assert "finite" in message


def test_a_drag_target_that_is_no_number_is_refused():
    w = small()
    w.apply(StartDrag("crate", (0.0, 0.5)))
    for bad in (*BAD, *HUGE):
        refused(w, MoveDrag("crate", (bad, 0.0)))


@pytest.mark.parametrize("huge", HUGE)
@pytest.mark.parametrize(
    "make",
    [
        lambda x: SetPose("crate", (x, 0.0), 0.0),
        lambda x: SetPose("crate", (0.0, 0.0), x),
        lambda x: SetVelocity("crate", (x, 0.0), 0.0),
        lambda x: SetVelocity("crate", (0.0, 0.0), x),
        lambda x: StartDrag("crate", (0.0, x)),
    ],
)
def test_numbers_past_the_limits_are_refused(make, huge):
    message = refused(small(), make(huge))
    assert "limit" in message


@pytest.mark.parametrize(
    ("command", "told"),
    [
        (SetPose("crate", [math.nan, 0.0], 0.0), "position must be a finite number"),
        (SetPose("crate", np.array([0.0, math.inf]), 0.0), "position must be a finite number"),
        (SetPose("crate", 5.0, 0.0), "position must be a pair of numbers (x, y), not 5.0"),
        (SetPose("crate", (1.0,), 0.0), "position must be a pair of numbers (x, y), not (1.0,)"),
        (SetVelocity("crate", (0.0, 0.0), None), "angular_velocity must be a number, not None"),
        (SetVelocity("crate", ("1", 0.0), 0.0), "velocity must be a pair of numbers (x, y)"),
        (ApplyForce("crate", (1.0, 0.0), point=3.0), "point must be a pair of numbers (x, y), not 3.0"),
        (ApplyForce("crate", (1.0, 0.0), torque=True), "torque must be a number, not True"),
        (SetSurface("crate", friction="ice"), "friction must be a number, not 'ice'"),
        (SetSurface("crate", shape=0.5), "shape must be a whole number, not 0.5"),
        (StartDrag("crate", (0.0, 0.0), -5.0), "max_force must not be negative"),
        (SetGravity(9.81), "SetGravity: gravity must be a pair of numbers (x, y), not 9.81"),
        (Spawn(5), "bodies, joints and regions are entries of a scene file"),
        ("Delete", "'Delete' is no command"),
        (None, "None is no command"),
    ],
)
def test_what_has_another_type_is_refused(command, told):
    assert told in refused(small(), command)


@pytest.mark.parametrize("name", [None, 5, ["crate"]])
def test_an_id_is_a_text(name):
    assert "an id is a text" in refused(small(), SetVelocity(name, (1.0, 0.0), 0.0), UnknownBodyError)


NUMBERS = st.one_of(st.floats(), st.integers(-(2**70), 2**70), st.none(), st.booleans(), st.just("1"), st.just(1e9))
PAIRS = st.one_of(NUMBERS, st.tuples(NUMBERS, NUMBERS), st.tuples(NUMBERS), st.lists(NUMBERS, max_size=3))


@given(PAIRS, NUMBERS, PAIRS)
def test_what_is_known_to_be_plain_at_one_look_is_so_at_a_closer_one(pair, number, point):
    commands = (
        SetVelocity("crate", pair, number), SetPose("crate", pair, number), ApplyForce("crate", pair, number, point),
        StartDrag("crate", pair, number), SetSurface("crate", number, shape=number), SetGravity(pair),
    )  # fmt: skip
    for command in commands:
        made = checks._made_plain(command, type(command))
        if made is not None:
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(checks, "_made_plain", lambda *_: None)
                closely = command.checked()
            assert repr(command.checked()) == repr(closely)  # which tells 1 from 1.0
            assert made or command.checked() is command


def test_a_push_wakes_what_sleeps_and_leaves_the_rest_of_what_is_awake_as_it_is():
    w = world(
        ground(),
        body("low", box(1.0, 1.0), position=(0.0, 0.5)),
        body("high", box(1.0, 1.0), position=(0.0, 1.5)),
        settings=FlatSettings(),
    )
    w.step(300)
    assert not w.body("low").awake
    w.apply(SetVelocity("high", (0.0, 0.0), 0.0))
    assert w.body("low").awake
    assert w.body("high").awake
    w.step(20)
    times = w.state.bodies.sleep_time.tolist()
    w.apply(ApplyForce("high", (0.0, 0.0)))
    assert w.state.bodies.sleep_time.tolist() == [times[0], times[1], 0.0]
    assert times[1] > 0.0


def test_what_sleeps_on_a_kinematic_body_wakes_in_the_step_once_that_moves():
    floor = body("floor", box(20.0, 1.0), type="kinematic", position=(0.0, -0.5))
    w = world(floor, body("crate", box(1.0, 1.0), position=(0.0, 0.5)), settings=FlatSettings())
    w.step(300)
    w.apply(SetVelocity("floor", (0.0, 0.0), 0.0))
    w.step()
    assert not w.body("crate").awake
    w.apply(SetVelocity("floor", (1.0, 0.0), 0.0))
    w.step()
    assert w.body("crate").awake
    w.step(60)
    assert w.body("crate").position[0] == pytest.approx(w.body("floor").position[0], abs=0.2)


def test_lists_and_numbers_of_numpy_will_do():
    one, two = small(), small()
    one.apply(SetVelocity("crate", (1.0, 2.0), 3.0))
    two.apply(SetVelocity("crate", np.array([1.0, 2.0], np.float32), np.int64(3)))
    assert one.digest() == two.digest()


@pytest.mark.parametrize(
    ("name", "near"), [("crat", "crate"), ("Ball", "ball"), ("plattform", "platform"), ("qqq", None)]
)
def test_an_unknown_body_is_named_with_the_nearest_name(name, near):
    message = refused(small(), SetPose(name, (0.0, 0.0), 0.0), UnknownBodyError)
    assert name in message
    assert (near in message) if near else ("did you mean" not in message)
    with pytest.raises(UnknownBodyError):
        small().body(name)
    with pytest.raises(KeyError):
        small().body(name)


@pytest.mark.parametrize("name", ["ground", "platform"])
def test_only_dynamic_bodies_are_pushed_and_dragged(name):
    for command in (ApplyForce(name, (1.0, 0.0)), StartDrag(name, (0.0, 0.0))):
        refused(small(), command)


def test_static_bodies_have_no_velocity():
    assert "static" in refused(small(), SetVelocity("ground", (1.0, 0.0), 0.0))


def test_forces_that_add_up_to_infinity_are_refused():
    w = small()
    w.apply(ApplyForce("crate", (1.5e308, 0.0)))
    refused(w, ApplyForce("crate", (1.5e308, 0.0)))


def test_set_pose_moves_the_origin_and_the_centre():
    w = small()
    w.body("crate").velocity = (1.0, 2.0)
    w.apply(SetPose("crate", (3.0, 4.0), math.pi / 2))
    crate = w.body("crate")
    assert crate.position == pytest.approx((3.0, 4.0))
    assert crate.angle == math.pi / 2
    assert crate.center == pytest.approx((3.0, 4.1))
    assert crate.velocity == (1.0, 2.0)
    assert (w.state.bodies[2].rotation_cos, w.state.bodies[2].rotation_sin) == pytest.approx((0.0, 1.0))


def test_properties_are_commands():
    w = small()
    crate = w.body("crate")
    crate.position = (1.0, 5.0)
    crate.angle = 0.5
    crate.velocity = (1, 2)
    crate.angular_velocity = 3
    assert crate.position == pytest.approx((1.0, 5.0))
    assert (crate.angle, crate.velocity, crate.angular_velocity) == (0.5, (1.0, 2.0), 3.0)
    before = w.digest()
    for name, value in [("position", (math.nan, 0.0)), ("angle", math.inf), ("velocity", (1e300, 0.0))]:
        with pytest.raises(CommandError):
            setattr(crate, name, value)
    assert w.digest() == before


def test_views_are_read_only():
    w = small()
    for view in (w.bodies.position, w.bodies.angle, w.bodies.velocity, w.bodies.center, w.bodies.mass):
        with pytest.raises(ValueError, match="read-only"):
            view[0] = 1.0


def test_views_follow_the_world():
    w = small()
    position = w.bodies.position
    w.step(10)
    assert tuple(position[3]) == w.body("ball").position
    assert position[3, 1] < 2.0
    saved = w.snapshot()
    w.step(10)
    w.restore(saved)
    assert tuple(position[3]) == w.body("ball").position


def test_a_drag_pulls_the_grabbed_point_to_its_target():
    w = small()
    w.apply(StartDrag("ball", (0.1, 2.0)))
    w.apply(MoveDrag("ball", (-3.0, 4.0)))
    w.step(300)
    ball = w.body("ball")
    c, s = math.cos(ball.angle), math.sin(ball.angle)
    grabbed = ball.position[0] + 0.1 * c, ball.position[1] + 0.1 * s
    assert grabbed == pytest.approx((-3.0, 4.0), abs=0.02)
    w.apply(EndDrag("ball"))
    w.step(30)
    assert ball.position[1] < 3.0


def test_a_drag_pulls_with_no_more_than_its_force():
    w = world(body("ball", circle(0.3, density=10.0)), gravity=(0.0, 0.0))
    w.apply(StartDrag("ball", (0.0, 0.0), 2.0))
    w.apply(MoveDrag("ball", (100.0, 0.0)))
    w.step(60)
    assert w.body("ball").velocity[0] == pytest.approx(2.0 / w.body("ball").mass, rel=0.02)


def test_drags_start_again_end_and_run_out():
    names = [f"b{i}" for i in range(9)]
    w = world(*(body(name, circle(0.3), position=(2.0 * i, 0.0)) for i, name in enumerate(names)))
    refused(w, MoveDrag("b0", (0.0, 0.0)))
    refused(w, EndDrag("b0"))
    for name in names[:8]:
        w.apply(StartDrag(name, (0.0, 0.0)))
    assert "8" in refused(w, StartDrag("b8", (0.0, 0.0)))
    w.apply(StartDrag("b3", (1.0, 1.0)))
    w.apply(EndDrag("b5"))
    refused(w, EndDrag("b5"))
    w.apply(StartDrag("b8", (0.0, 0.0)))
    w.step(10)
    assert np.isfinite(w.bodies.position).all()
