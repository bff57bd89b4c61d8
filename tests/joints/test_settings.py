"""Settings of joints that change at run time: in the words of scenes, alike for all kinds, recorded, and refused."""

from __future__ import annotations

import math

import pytest

import sandbox
from sandbox import SetJoint, SetMotor, SetVelocity
from sandbox.errors import CommandError, SandboxError, UnknownJointError
from sandbox.scene.joints import JOINTS

BODIES = [
    {"id": "a", "position": [0, 0], "angle": 30, "shapes": [{"box": [1, 1]}]},
    {"id": "b", "position": [2, 0], "angle": -20, "shapes": [{"box": [1, 0.5]}]},
    {"id": "c", "position": [4, 1], "shapes": [{"circle": 0.5}]},
]
COMMON = {"break_force": 4000.0, "break_torque": 300.0, "collide": True, "enabled": False}
SPRING = {"hertz": 2.5, "damping_ratio": 0.4}
SOFT = {**SPRING, "angular_hertz": 3.5, "angular_damping_ratio": 0.6}
LIMITS = {"lower": -0.5, "upper": 0.25}
WHEELS = {"anchors": [[0, 0], [2, 0]], "wheels": [[0, 4], [2, 4]]}
CHANGES = {
    "distance": ({"anchors": [[0, 0], [2, 0]]}, {**SPRING, "length": 1.5, "min": 1.0, "max": 3.0}),
    "revolute": ({"anchor": [1, 0]}, {**SPRING, **LIMITS, "motor_speed": 90.0, "max_torque": 7.0, "rest": 10.0}),
    "prismatic": (
        {"anchor": [1, 0], "axis": [0, 1]}, {**SPRING, **LIMITS, "motor_speed": 2.0, "max_force": 7.0, "rest": 0.5}
    ),
    "weld": ({"anchor": [1, 0]}, SOFT),
    "wheel": ({"anchor": [1, 0]}, {**SPRING, **LIMITS, "motor_speed": 90.0, "max_torque": 7.0, "rest": 0.1}),
    "gear": ({}, {"ratio": -2.0}),
    "pulley": (WHEELS, {"ratio": 3.0}),
    "motor": ({"anchor": [1, 0]}, {**SOFT, "offset": (0.5, 0.2), "angle": 25.0, "max_force": 5.0, "max_torque": 2.0}),
    "target": ({"anchor": [1, 0], "target": [3, 3]}, {**SPRING, "target": (1.0, 2.0), "max_force": 5.0}),
    "friction": ({"anchor": [1, 0], "max_force": 1.0}, {"max_force": 5.0, "max_torque": 2.0}),
}  # fmt: skip
"""For each kind, what a scene needs to say, and every setting that can change, in a scene's words and degrees."""


def world(*joints, **fields):
    """A world of three bodies without gravity."""
    return sandbox.World(sandbox.Scene(bodies=BODIES, joints=list(joints), gravity=(0, 0), **fields))


def made(kind, **settings):
    """A world with a joint "j" of that kind, and two hinges if it is a gear."""
    bodies = {"target": ["a"]}.get(kind, ["a", "b"])
    if kind != "gear":
        return world({"id": "j", "type": kind, "bodies": bodies, **CHANGES[kind][0], **settings})
    hinges = [{"id": x, "type": "revolute", "bodies": [x], "anchor": [0, 0]} for x in "ab"]
    return world(*hinges, {"id": "j", "type": "gear", "joints": ["a", "b"], **settings})


@pytest.mark.parametrize("kind", CHANGES)
def test_what_a_command_sets_is_what_a_scene_would_have_set(kind):
    changes = {**COMMON, **CHANGES[kind][1]}
    w, wanted = made(kind), made(kind, **{k: list(v) if isinstance(v, tuple) else v for k, v in changes.items()})
    w.apply(SetJoint("j", **changes, radians=False))
    for name in w.state.joints.dtype.names:
        got, expected = w.state.joints[name][-1], wanted.state.joints[name][-1]
        assert got == pytest.approx(expected, abs=1e-14), name
    for each in (w, wanted):
        each.apply(SetJoint("j", True))
        each.step(5)
    assert w.bodies.position == pytest.approx(wanted.bodies.position, abs=1e-9)


def test_every_setting_of_every_kind_can_be_changed():
    fixed = {"id", "type", "bodies", "joints", "anchor", "anchors", "axis", "wheels"}
    for kind, model in JOINTS.items():
        assert set(model.model_fields) - fixed == COMMON.keys() | CHANGES[kind][1].keys()


@pytest.mark.parametrize(("kind", "command"), [
    ("weld", SetJoint("j", break_force=math.inf, break_torque=math.inf)),
    ("motor", SetJoint("j", max_force=math.inf, max_torque=math.inf)),
    ("revolute", SetMotor("j", 1.0, math.inf)),
])  # fmt: skip
def test_no_limit_is_as_in_a_scene_without_one_and_null_in_a_recording(kind, command):
    limits = {
        "weld": ("break_force", "break_torque"),
        "motor": ("max_force", "max_torque"),
        "revolute": ("max_torque",),
    }
    speed = {"motor_speed": math.degrees(1.0)} if kind == "revolute" else {}
    w, wanted = made(kind, **dict.fromkeys(limits[kind], 5.0), **speed), made(kind, **speed)
    w.apply(command)
    assert w.digest() == wanted.digest()
    words = command.to_words()
    assert None in words.values()
    assert type(command).from_words(words) == command


@pytest.mark.parametrize("kind", CHANGES)
def test_each_alone_changes_nothing_else(kind):
    for name, value in {**COMMON, **CHANGES[kind][1]}.items():
        w, before = made(kind), made(kind).state.joints[-1]
        w.apply(SetJoint("j", **{name: value}, radians=False))
        row = w.state.joints[-1]
        changed = {column for column in row.dtype.names if row[column] != before[column]}
        assert 0 < len(changed) <= 3, (name, changed)
        w.step(3)
        assert w.frozen == []


def test_a_ratio_counts_from_the_pose_of_now():
    for kind in ("gear", "pulley"):
        w = made(kind)
        w.apply(SetVelocity("b", (0.0, -1.0), 0.5))
        w.step(30)
        w.apply(SetJoint("j", ratio=2.5))
        before = w.bodies.position.copy(), w.bodies.angle.copy()
        w.step()
        speed = abs(w.bodies.velocity).max()
        assert speed < 2.0  # a joint that finds itself far from where it should be draws at 4 m/s
        assert w.bodies.position == pytest.approx(before[0], abs=0.05)


def test_a_motor_is_led_from_pose_to_pose():
    w = made("motor", offset=[0.3, 0.0], angle=10)
    w.apply(SetJoint("j", offset=(1.0, 0.5), angle=math.radians(-40.0)))
    assert w.joint("j").angle == pytest.approx(0.0)
    w.step(600)
    assert w.joint("j").angle == pytest.approx(math.radians(-40.0), abs=1e-6)
    w.apply(SetJoint("j", angle=math.radians(15.0)))
    w.step(600)
    assert w.joint("j").angle == pytest.approx(math.radians(15.0), abs=1e-6)


def test_a_stronger_rub_stops_sooner():
    w = world({"id": "j", "type": "friction", "bodies": ["c"], "anchor": [4, 1], "max_force": 0})
    w.apply(SetVelocity("c", (3.0, 0.0), 0.0))
    w.step(30)
    assert w.body("c").velocity[0] == pytest.approx(3.0)
    w.apply(SetJoint("j", max_force=w.body("c").mass))
    w.step(60)
    assert w.body("c").velocity[0] == pytest.approx(2.0, rel=1e-6)


def test_what_may_break_is_changed_and_what_sleeps_wakes():
    w = world({"id": "j", "type": "revolute", "bodies": ["c"], "anchor": [4, 3]})
    w.step(120)
    assert not w.body("c").awake
    w.apply(SetJoint("j", break_force=1.0))
    assert w.body("c").awake
    w.apply(SetVelocity("c", (5.0, 0.0), 0.0))
    w.step(10)
    assert w.joint("j").broken


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (SetJoint("j", max_force=5.0), r"a weld joint has no max_force; it has break_force, .*angular_damping_ratio"),
        (SetJoint("j", motor_speed=5.0), "a weld joint has no motor_speed"),
        (SetJoint("j", angle=5.0), "a weld joint has no angle; it has break_force"),
        (SetJoint("j", hertz=1e6), "hertz must not be above 10000 Hz"),
        (SetJoint("j", hertz=-1.0), "hertz must not be negative"),
        (SetJoint("j", break_force=-1.0), "break_force must not be negative"),
        (SetJoint("j", break_force=math.nan), "finite"),
        (SetJoint("j", break_force=-math.inf), "finite"),
        (SetJoint("j", hertz=math.inf), "finite"),
        (SetJoint("j", hertz="stiff"), "hertz must be a number, not 'stiff'"),
        (SetJoint("j", collide=1), "collide must be True or False"),
        (SetJoint("hinge", lower=3.0, upper=-3.0), "lower must not be greater than upper"),
        (SetJoint("hinge", lower=0.9), "lower must not be greater than upper"),
        (SetJoint("jj", hertz=1.0), "no joint 'jj'"),
    ],
)
def test_what_cannot_be_done_is_told_and_changes_nothing(command, words):
    weld = {"id": "j", "type": "weld", "bodies": ["a", "b"], "anchor": [1, 0]}
    w = world(weld, {"id": "hinge", "type": "revolute", "bodies": ["c"], "anchor": [4, 1], "upper": 45})
    before = w.snapshot()
    with pytest.raises((CommandError, UnknownJointError), match=words):
        w.apply(command)
    assert w.snapshot() == before


@pytest.mark.parametrize("kind", CHANGES)
def test_it_is_recorded_and_played_again(kind, tmp_path):
    scene = made(kind).scene
    commands = [
        (3, SetJoint("j", **CHANGES[kind][1], radians=False)),
        (6, SetJoint("j", False)),
        (9, SetJoint("j", enabled=True)),
    ]
    recording = sandbox.record(scene, 20, commands)
    recording.save(tmp_path / "j.replay.json")
    again = sandbox.Recording.load(tmp_path / "j.replay.json")
    assert again.commands == recording.commands
    assert sandbox.rerun(again).passed
    assert recording.digests != sandbox.record(scene, 20).digests


def test_a_wrong_name_in_a_file_gets_the_nearest_right_one(tmp_path):
    path = tmp_path / "j.replay.json"
    sandbox.record(made("motor").scene, 5, [(1, SetJoint("j", max_torque=2.0))]).save(path)
    path.write_text(path.read_text().replace("max_torque", "max_torqe"))
    with pytest.raises(SandboxError, match='did you mean "max_torque"'):
        sandbox.Recording.load(path)


def test_the_older_commands_and_this_one_say_the_same():
    one, other = made("revolute"), made("revolute")
    one.apply(SetMotor("j", math.radians(90.0), 7.0))
    other.apply(SetJoint("j", motor_speed=math.radians(90.0), max_torque=7.0))
    assert one.digest() == other.digest()
