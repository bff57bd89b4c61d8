"""What a user writes: every part of a scene and every command comes from `sandbox`, one name means one thing, objects
refuse what they do not have, and whatever is of a wrong type gets an error of the package."""

from __future__ import annotations

import ast
import importlib
import math
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox._names import HOMES
from sandbox.engine.commands.registry import COMMAND_CLASSES
from sandbox.scene.expect import CONDITIONS
from sandbox.scene.generators import GENERATORS
from sandbox.scene.joints import JOINTS
from sandbox.scene.regions import REGIONS
from sandbox.scene.shapes import SHAPES

PARTS = [*SHAPES.values(), *JOINTS.values(), *REGIONS.values(), *CONDITIONS.values(), *GENERATORS.values()]


def world() -> sandbox.World:
    """A crate that is held by a motor, on the ground, and water with a name."""
    return sandbox.World(
        sandbox.Scene(
            bodies=[
                sandbox.Body(id="ground", type="static", shapes=[sandbox.BoxShape(box=(20, 1))], position=(0, -0.5)),
                sandbox.Body(id="crate", shapes=[sandbox.BoxShape(box=(1, 1))], position=(0, 2), angle=90.0),
            ],
            joints=[sandbox.Revolute(id="pin", type="revolute", bodies=("crate",), anchor=(0, 2), upper=90.0)],
        )
    )


class TestNames:
    @pytest.mark.parametrize("model", PARTS, ids=lambda model: model.__name__)
    def test_every_part_of_a_scene_is_public(self, model: type[Any]) -> None:
        assert getattr(sandbox, model.__name__) is model

    @pytest.mark.parametrize("name", COMMAND_CLASSES)
    def test_every_command_is_public(self, name: str) -> None:
        assert getattr(sandbox, name) is COMMAND_CLASSES[name]
        assert sandbox.__all__.count(name) == 1

    def test_every_error_is_public(self) -> None:
        kinds = vars(importlib.import_module("sandbox.errors")).values()
        errors = [kind for kind in kinds if isinstance(kind, type) and issubclass(kind, Exception)]
        assert len(errors) > 10
        assert [kind for kind in errors if getattr(sandbox, kind.__name__) is not kind] == []

    def test_what_the_type_checker_is_told_is_what_there_is(self) -> None:
        tree = ast.parse(Path(sandbox.__file__).read_text(encoding="utf-8"))
        told = {
            alias.name: (node.module, alias.asname)
            for block in tree.body
            if isinstance(block, ast.If)
            for node in block.body
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        assert told == {name: (home, name) for name, home in HOMES.items()}

    def test_one_name_means_one_thing(self) -> None:
        scene = importlib.import_module("sandbox.scene")
        both = [name for name in scene.__all__ if name in HOMES]
        assert len(both) > 40
        assert [name for name in both if getattr(sandbox, name) is not getattr(scene, name)] == []
        named = Counter(kind.__name__ for kind in {getattr(sandbox, name) for name in HOMES if name[0].isupper()})
        assert [name for name, count in named.items() if count > 1] == []


class TestRadians:
    def test_all_of_python_turns_in_radians(self) -> None:
        w = world()
        assert w.body("crate").angle == pytest.approx(math.pi / 2)  # the scene said 90, as a file does
        assert w.joint("pin").limits == (None, pytest.approx(math.pi / 2))
        w.apply(sandbox.SetJoint("pin", upper=1.0, lower=-0.25, motor_speed=0.5))
        assert w.joint("pin").limits == (-0.25, 1.0)
        assert w.joint("pin").motor_speed == 0.5
        w.apply(sandbox.SetLimits("pin", -0.5, 2.0))
        assert w.joint("pin").limits == (-0.5, 2.0)
        w.body("crate").angle = 0.3
        assert w.body("crate").angle == 0.3
        tilted = sandbox.Box(2.0, 1.0, angle=0.3).vertices[1]
        assert tilted == pytest.approx((math.cos(0.3) + 0.5 * math.sin(0.3), math.sin(0.3) - 0.5 * math.cos(0.3)))

    def test_a_files_degrees_can_be_given_to_set_joint(self) -> None:
        one, other = world(), world()
        one.apply(sandbox.SetJoint("pin", upper=30.0, radians=False))
        other.apply(sandbox.SetJoint("pin", upper=math.radians(30.0)))
        assert one.digest() == other.digest()

    @pytest.mark.parametrize("command", [
        sandbox.SetJoint("pin", upper=1.0), sandbox.SetJoint("pin", upper=30.0, radians=False),
        sandbox.SetJoint("pin", max_torque=5.0), sandbox.SetJoint("pin", max_torque=5.0, radians=False),
    ])  # fmt: skip
    def test_recordings_keep_degrees_and_what_was_said(self, command: sandbox.SetJoint, tmp_path: Path) -> None:
        path = tmp_path / "pin.replay.json"
        sandbox.record(world().scene, 5, [(1, command)]).save(path)
        again = sandbox.Recording.load(path)
        assert again.commands == ((1, command),)
        assert sandbox.rerun(again).passed

    def test_the_words_of_old_recordings_are_degrees(self) -> None:
        words = {"joint": "pin", "upper": 30.0}
        command = sandbox.SetJoint.from_words(words)
        assert command == sandbox.SetJoint("pin", upper=30.0, radians=False)
        assert command.to_words() == words
        assert sandbox.SetJoint("pin", upper=0.5).to_words() == {"joint": "pin", "upper": 0.5, "radians": True}

    def test_every_setting_that_is_an_angle_is_known_as_one(self) -> None:
        from sandbox.engine.commands.set_joint import ANGLES

        for kind, model in JOINTS.items():
            told = {name for name, field in model.model_fields.items() if "degrees" in (field.description or "")}
            told |= {name for name, field in model.model_fields.items() if "egrees" in str(field.annotation)}
            assert told == set(ANGLES.get(kind, ())), kind


class TestAttributes:
    @pytest.mark.parametrize(
        ("make", "name", "near"),
        [
            (world, "gravty", "gravity"),
            (lambda: world().body("crate"), "foo", ""),
            (lambda: world().body("crate"), "velocty", "velocity"),
            (lambda: world().bodies, "angel", ""),
            (lambda: world().joint("pin"), "motorspeed", "motor_speed"),
            (lambda: world().query, "foo", ""),
            (lambda: sandbox.Player(world().scene), "foo", ""),
            (lambda: sandbox.Recorder(world()), "foo", ""),
            (lambda: world().scene, "foo", ""),
            (lambda: sandbox.BoxShape(box=(1, 1)), "bx", ""),
        ],
    )
    def test_what_there_is_not_is_refused(self, make: Any, name: str, near: str) -> None:
        thing = make()
        with pytest.raises(sandbox.UnknownAttributeError, match=f"no attribute '{name}'.*{near}") as caught:
            setattr(thing, name, 3)
        assert isinstance(caught.value, (sandbox.SandboxError, AttributeError))
        assert not hasattr(thing, name)

    @pytest.mark.parametrize(
        ("make", "name"),
        [
            (world, "time"),
            (world, "state"),
            (lambda: world().body("crate"), "mass"),
            (lambda: world().body("crate"), "id"),
            (lambda: world().bodies, "position"),
            (lambda: sandbox.Player(world().scene), "length"),
            (lambda: world().scene, "gravity"),
            (lambda: sandbox.Thruster(force=(1.0, 0.0)), "force"),
        ],
    )
    def test_what_only_reads_is_refused(self, make: Any, name: str) -> None:
        with pytest.raises(sandbox.ReadOnlyAttributeError, match="read-only"):
            setattr(make(), name, 3)

    def test_a_subclass_may_have_attributes_of_its_own(self) -> None:
        class Watched(sandbox.World):
            def __init__(self, scene: sandbox.Scene) -> None:
                super().__init__(scene)
                self.seen = 0

        assert Watched(world().scene).seen == 0


class TestShortWays:
    def test_gravity_is_a_command(self) -> None:
        one, other = world(), world()
        one.gravity = (0.0, -1.62)
        other.apply(sandbox.SetGravity((0.0, -1.62)))
        assert one.digest() == other.digest()
        assert one.gravity == (0.0, -1.62)
        with pytest.raises(sandbox.CommandError, match="gravity must be a pair"):
            one.gravity = 3  # type: ignore[assignment]

    def test_bodies_and_joints_come_and_go(self) -> None:
        w = world()
        w.spawn(sandbox.Body(id="ball", shapes=[sandbox.CircleShape(circle=0.5)], position=(3, 3)))
        w.spawn(joints=[{"id": "rope", "type": "distance", "bodies": ["ball"], "anchors": [[3, 6], [3, 3]]}])
        assert [joint.id for joint in w.joints] == ["pin", "rope"]
        assert w.joints[1].bodies == (None, "ball") or w.joints[1].bodies == ("ball", None)
        w.joint("pin").delete()
        w.delete(["ball"])
        assert w.names == ("ground", "crate")
        assert w.joints == ()
        w.body("crate").delete()
        assert w.names == ("ground",)

    def test_models_and_dicts_spawn_the_same(self) -> None:
        entry = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [3.0, 3.0]}
        one = sandbox.Spawn(entry)
        assert sandbox.Spawn(sandbox.Body(**{**entry, "position": (3.0, 3.0)})) == one  # type: ignore[arg-type]

    def test_joints_and_surfaces_are_set_by_commands(self) -> None:
        w = world()
        w.joint("pin").limits = (-0.5, None)
        assert w.joint("pin").limits == (-0.5, None)
        w.joint("pin").set(max_torque=7.0, motor_speed=1.0)
        assert w.joint("pin").motor_speed == 1.0
        w.body("crate").set_surface(friction=0.125)
        assert w.state.shapes.friction[1] == 0.125
        with pytest.raises(sandbox.CommandError, match="no setting 'max_torqe'"):
            w.joint("pin").set(max_torqe=7.0)

    def test_the_shapes_of_a_body_can_be_asked_about(self) -> None:
        (box,) = world().body("crate").shapes
        assert sandbox.contains(box, (0.0, 2.0))
        assert not sandbox.contains(box, (0.0, 3.0))


HUGE = 10**400


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: sandbox.World("x.json"), sandbox.ArgumentError, "takes a Scene, not 'x.json'; load_scene"),
        (lambda: sandbox.World(None), sandbox.ArgumentError, "takes a Scene, not None"),
        (lambda: sandbox.load_scene(3), sandbox.ArgumentError, "load_scene: takes the path of a file, not 3"),
        (lambda: sandbox.loads_scene(3), sandbox.ArgumentError, "takes a text, not 3"),
        (lambda: sandbox.Player("x"), sandbox.ArgumentError, "takes a Run, a Recording or a Scene, not 'x'"),
        (lambda: sandbox.Player(None), sandbox.ArgumentError, "not None"),
        (lambda: sandbox.Recorder("x"), sandbox.ArgumentError, "takes a World, not 'x'"),
        (lambda: sandbox.record(3), sandbox.ArgumentError, "record: takes a Scene or the path of one, not 3"),
        (lambda: sandbox.record(world().scene, 1.5), sandbox.ArgumentError, "whole number of steps from 0, not 1.5"),
        (lambda: sandbox.rerun("x"), sandbox.ArgumentError, "rerun: takes a Recording, not 'x'"),
        (lambda: sandbox.Recording.load(3), sandbox.ArgumentError, "the path of a file, not 3"),
        (lambda: sandbox.find_divergence(3, 4), sandbox.ArgumentError, "find_divergence: takes a Run"),
        (lambda: world().step(1.5), sandbox.ArgumentError, "whole number of steps from 0, not 1.5"),
        (lambda: world().step(-1), sandbox.ArgumentError, "from 0, not -1"),
        (lambda: world().step("3"), sandbox.ArgumentError, "from 0, not '3'"),
        (lambda: world().step(True), sandbox.ArgumentError, "from 0, not True"),
        (lambda: sandbox.Player(world().scene).step(-1), sandbox.ArgumentError, "from 0, not -1"),
        (lambda: sandbox.Player(world().scene).seek(1.5), sandbox.ArgumentError, "from 0, not 1.5"),
        (lambda: world().restore(3), sandbox.SnapshotError, "a snapshot is bytes"),
        (lambda: world().restore("abc"), sandbox.SnapshotError, "a snapshot is bytes"),
        (lambda: world().apply(3), sandbox.CommandError, "3 is no command"),
        (lambda: world().apply(None), sandbox.CommandError, "None is no command"),
        (lambda: world().apply(sandbox.SetPose), sandbox.CommandError, "is no command"),
        (lambda: world().body(3), sandbox.UnknownBodyError, "an id is a text, not 3"),
        (lambda: world().joint(None), sandbox.UnknownJointError, "an id is a text, not None"),
        (lambda: world().spawn(3), sandbox.CommandError, "Spawn: bodies, joints and regions are entries"),
        (lambda: world().delete(3), sandbox.CommandError, "Delete: what to delete is one id"),
        (lambda: crate().apply_impulse(5), sandbox.CommandError, r"impulse must be a pair of numbers \(x, y\), not 5"),
        (lambda: crate().apply_impulse((HUGE, 0)), sandbox.CommandError, "impulse must be a number below 1.8e308"),
        (lambda: crate().apply_impulse("ab"), sandbox.CommandError, "impulse must be a pair of numbers"),
        (lambda: crate().apply_impulse((1.0, 2.0), HUGE), sandbox.CommandError, "angular_impulse must be a number"),
        (lambda: crate().apply_force((1.0,)), sandbox.CommandError, "force must be a pair of numbers"),
        (lambda: crate().apply_force((1.0, 2.0), "x"), sandbox.CommandError, "torque must be a number, not 'x'"),
        (lambda: setattr(crate(), "position", "12"), sandbox.CommandError, "position must be a pair"),
        (lambda: setattr(crate(), "angle", None), sandbox.CommandError, "angle must be a number, not None"),
        (lambda: setattr(crate(), "velocity", 3), sandbox.CommandError, "velocity must be a pair"),
        (lambda: setattr(world().joint("pin"), "limits", 3), sandbox.CommandError, "takes a pair"),
        (lambda: setattr(world().joint("pin"), "enabled", 3), sandbox.CommandError, "enabled must be True or False"),
        (lambda: world().query.ray("a", (1, 0)), sandbox.QueryError, "the origin"),
        (lambda: sandbox.collide(1, 2), sandbox.ShapeError, "collide: takes a Circle"),
        (lambda: sandbox.Circle((0, 0), "x"), sandbox.ShapeError, "the radius must be a number"),
        (lambda: sandbox.Scene(bodies=3), sandbox.SceneError, "bodies"),
        (lambda: sandbox.Scene(gravity=(0, HUGE)), sandbox.SceneError, "gravity"),
    ],
)
def test_wrong_types_get_errors_of_the_package(call: Any, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words) as caught:
        call()
    assert isinstance(caught.value, sandbox.SandboxError)
    assert len(str(caught.value)) < 400


def crate() -> sandbox.BodyView:
    """The crate of a world."""
    return world().body("crate")


def test_numbers_of_numpy_are_numbers() -> None:
    one, other = world(), world()
    one.apply(sandbox.SetVelocity("crate", np.array([1.0, 0.1], np.float32), np.float32(0.5)))
    other.apply(sandbox.SetVelocity("crate", (1.0, float(np.float32(0.1))), 0.5))
    assert one.digest() == other.digest()
