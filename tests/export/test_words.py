"""What stays of the author's words, and what is written anew."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import pytest

from sandbox import (
    ApplyForce,
    ArgumentError,
    BreakJoint,
    Delete,
    DeleteJoint,
    Scene,
    SetGravity,
    SetJoint,
    SetPose,
    SetRegion,
    SetSettings,
    SetSurface,
    SetThruster,
    SetVelocity,
    Spawn,
    StartDrag,
    World,
    scene_of,
)
from sandbox.world.export.present import Present
from tests.cli.conftest import cli
from tests.export.worlds import difference, entries, saved

__all__ = ["cli"]

PARTS: dict[str, Any] = {
    "title": "Parts", "about": "One of each.", "gravity": [0, 0], "categories": ["loud"],
    "materials": {"ice": {"friction": 0.1, "density": 0.9}, "unused": {}},
    "prefabs": {
        "brick": {"shapes": [{"box": [1, 0.5]}], "material": "ice", "angle": 90},
        "link": {"shapes": [{"capsule": [[-0.4, 0], [0.4, 0]], "radius": 0.1}]},
        "pair": {"shapes": [{"circle": 0.5, "friction": 0.3}, {"box": [1, 1], "at": [2, 0]}], "velocity": [1, 0]},
    },
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -5], "color": "#123456"},
        {"id": "twins", "prefab": "pair", "position": [0, 3], "velocity": [0, 0]},
        {"id": "pusher", "shapes": [{"circle": 1}], "position": [9, 9],
         "thrusters": [{"force": [1, 0], "start": 1, "end": 2}, {"force": [0, 2], "at": [0, 1]}]},
    ],
    "generate": [
        {"id": "wall", "grid": "brick", "columns": 2, "rows": 2, "at": [10, 0]},
        {"id": "rope", "chain": "link", "count": 3, "at": [-10, 5], "pin": "start", "break_force": 900},
    ],
    "joints": [{"id": "pin", "type": "revolute", "bodies": ["ground", "twins"], "anchor": [0, 3], "upper": 45.5}],
    "regions": [
        {"id": "pool", "water": 1.5, "inside": [-20, -20, -15, -10], "surface": -12, "drag": 2},
        {"id": "gust", "wind": [3, 0], "start": 0.5, "end": 1.5, "inside": [50, 50, 60, 60]},
    ],
    "settings": {"steps": 90, "substeps": 3},
    "view": {"center": [1, 2]},
    "expect": [{"at": 1, "near": [0, 3], "of": "twins"}],
}  # fmt: skip


@pytest.fixture
def world() -> World:
    """A world in which nothing moves by itself."""
    return World(Scene(**PARTS))


def now(world: World) -> Scene:
    return scene_of(world).scene


def without(words: dict[str, Any], name: str) -> dict[str, Any]:
    return {key: value for key, value in words.items() if key != name}


def changed_fields(world: World) -> set[str]:
    """The fields of the scene that are not the author's own objects any longer."""
    found = now(world)
    return {name for name in type(found).model_fields if getattr(found, name) != getattr(world.scene, name)}


def test_a_moved_body_keeps_its_entry_but_for_its_place(world: World) -> None:
    world.apply(SetPose("twins", (1.5, 3.25), pi / 4))
    found = now(world)
    assert entries(found)["twins"] == {
        "id": "twins", "prefab": "pair", "position": [1.5, 3.25], "angle": 45, "velocity": [0, 0],
    }  # fmt: skip
    assert found.bodies[0] is world.scene.bodies[0]
    assert changed_fields(world) == {"bodies", "joints", "expect"}


def test_a_velocity_that_the_prefab_has_is_not_repeated(world: World) -> None:
    world.apply(SetVelocity("twins", (1.0, 0.0), 0.0))
    assert entries(now(world))["twins"] == {"id": "twins", "prefab": "pair", "position": [0, 3]}


def test_a_generator_stays_until_one_of_its_bodies_moves(world: World) -> None:
    assert [each.id for each in now(world).generate] == ["wall", "rope"]
    world.apply(SetPose("wall-1-2", (30.0, 0.0), 0.0))
    found = now(world)
    assert [each.id for each in found.generate] == ["rope"]
    wall = {name: entry for name, entry in entries(found).items() if name.startswith("wall")}
    assert wall["wall-2-1"] == {"id": "wall-2-1", "prefab": "brick", "position": [10, 1]}
    assert wall["wall-1-2"] == {"id": "wall-1-2", "prefab": "brick", "position": [30, 0], "angle": 0}
    assert len(wall) == 4
    assert (found.materials, found.prefabs) == (world.scene.materials, world.scene.prefabs)


def test_a_chain_is_written_out_once_a_hinge_is_another(world: World) -> None:
    world.apply(SetJoint("rope-joint-1", motor_speed=pi))
    found = now(world)
    assert [each.id for each in found.generate] == ["wall"]
    joints = {joint.id: joint.to_data() for joint in found.joints}
    assert joints["rope-joint-0"] == {
        "id": "rope-joint-0", "type": "revolute", "bodies": ["rope-1"], "anchor": [-10, 5], "break_force": 900,
    }  # fmt: skip
    assert joints["rope-joint-1"]["motor_speed"] == 180
    assert entries(found)["rope-1"]["position"] == [-9.5, 5]


def test_who_is_deleted_is_gone_and_who_was_spawned_is_there(world: World, tmp_path: Path) -> None:
    world.apply(Delete("rope-2"))
    world.apply(DeleteJoint("pin"))
    world.apply(Spawn({"id": "late", "prefab": "brick", "position": [5, 5], "angle": 10}))
    world.apply(Spawn((), {"id": "tie", "type": "weld", "bodies": ["late", "ground"], "anchor": [5, 5]}))
    found, other = saved(world, tmp_path)
    assert {joint.id for joint in found.scene.joints} == {"tie", "rope-joint-0"}
    assert entries(found.scene)["late"] == {"id": "late", "prefab": "brick", "position": [5, 5], "angle": 10}
    assert sorted(other.names) == sorted(world.names)
    assert found.remarks == ("expectations are left out: they speak of the scene as it began",)


def test_expectations_stay_while_the_author_only_adds(world: World) -> None:
    world.apply(Spawn({"id": "late", "prefab": "brick", "position": [5, 5]}))
    assert now(world).expect == world.scene.expect
    world.apply(SetVelocity("twins", (0.0, 1.0), 0.0))
    assert now(world).expect == ()


def test_surfaces_are_written_on_the_shapes(world: World, tmp_path: Path) -> None:
    world.apply(SetSurface("twins", restitution=2.0, density=3.0, bumper=True, shape=1))
    world.apply(SetSurface("wall-1-1", friction=0.75))
    found, other = saved(world, tmp_path)
    assert entries(found.scene)["twins"]["shapes"] == [
        {"circle": 0.5, "friction": 0.3},
        {"box": [1, 1], "at": [2, 0], "density": 3, "restitution": 2, "bumper": True},
    ]
    assert entries(found.scene)["wall-1-1"]["shapes"] == [{"box": [1, 0.5], "friction": 0.75}]
    assert difference(world, other) < 1e-12
    shapes = other.state.shapes[other.state.shapes.body == other.directory.body("wall-1-1")]
    assert (shapes.friction[0], shapes.density[0]) == (0.75, 0.9)


def test_parts_of_one_shape_cannot_differ() -> None:
    corner = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]
    world = World(Scene(bodies=[{"id": "corner", "shapes": [{"polygon": corner}]}]))
    assert len(world.state.shapes) > 1
    world.apply(SetSurface("corner", friction=0.9, shape=0))
    found = scene_of(world)
    assert found.scene.bodies[0].shapes[0].friction == 0.9
    assert found.remarks == ("parts of one shape cannot differ: all of it has the new friction: corner",)
    world.apply(SetSurface("corner", friction=0.9))
    assert scene_of(world).remarks == ()


def test_settings_and_gravity(world: World) -> None:
    world.apply(SetSettings(substeps=8, soft=False, contact_hertz=20.0))
    world.apply(SetGravity((0.0, -1.62)))
    found = now(world)
    assert found.settings.to_data() == {"steps": 90, "substeps": 8, "soft": False, "contact_hertz": 20}
    assert found.gravity == (0.0, -1.62)
    assert changed_fields(world) == {"settings", "gravity"}


def test_schedules_count_from_now(world: World) -> None:
    world.step(75)
    gust = world.scene.regions[1]
    found = now(world)
    assert entries(found)["pusher"]["thrusters"] == [{"force": [1, 0], "end": 0.75}, {"force": [0, 2], "at": [0, 1]}]
    assert found.regions[0] is world.scene.regions[0]
    assert found.regions[1].to_data() == {**without(gust.to_data(), "start"), "end": 0.25}
    world.step(60)
    found = now(world)
    assert found.regions[1].to_data() == {**without(gust.to_data(), "end"), "start": 1e6}
    assert entries(found)["pusher"]["thrusters"] == [{"force": [1, 0], "start": 1e6}, {"force": [0, 2], "at": [0, 1]}]
    assert "what is over or switched off begins after a million seconds, so that it is there: pusher, gust" in (
        scene_of(world).remarks
    )


def test_regions_and_thrusters_that_commands_have_changed(world: World, tmp_path: Path) -> None:
    world.apply(SetRegion("pool", surface=-11.0, drag=3.0, flow=(1.0, 0.0)))
    world.apply(SetRegion("gust", enabled=False))
    world.apply(SetThruster("pusher", force=(0.0, 5.0), thruster=1))
    world.apply(SetThruster("pusher", enabled=True, thruster=0))
    found, other = saved(world, tmp_path)
    assert found.scene.regions[0].to_data() == {
        "id": "pool", "water": 1.5, "inside": [-20, -20, -15, -10], "surface": -11, "drag": 3, "angular_drag": 2,
        "flow": [1, 0],
    }  # fmt: skip
    assert found.remarks == ("what is over or switched off begins after a million seconds, so that it is there: gust",)
    assert entries(found.scene)["pusher"]["thrusters"] == [{"force": [1, 0]}, {"force": [0, 5], "at": [0, 1]}]
    other.apply(SetRegion("gust", enabled=True))
    assert other.state.regions[1].start_step == 0


def test_remarks_say_what_has_no_words(world: World) -> None:
    world.apply(StartDrag("twins", (0.0, 3.0)))
    world.apply(ApplyForce("pusher", (1.0, 0.0)))
    world.apply(BreakJoint("pin"))
    world.apply(SetVelocity("wall-1-1", (0.0, 0.0), 1e5))
    found = scene_of(world)
    assert found.remarks == (
        "broken joints are left out: pin",
        "angular_velocity past the limit of scene files is cut to it: wall-1-1",
        "expectations are left out: they speak of the scene as it began",
        "dragged bodies are let go: twins",
        "forces of the coming step are left out: pusher",
    )
    assert found.scene.joints == ()
    assert entries(found.scene)["wall-1-1"]["angular_velocity"] == 1e6


def test_more_turns_than_a_scene_may_say_are_taken_off(tmp_path: Path) -> None:
    world = World(Scene(gravity=(0, 0), bodies=[{"id": "top", "shapes": [{"box": [2, 1]}]}]))
    world.apply(SetPose("top", (0.0, 0.0), 2e4 + 0.5))
    found, other = saved(world, tmp_path)
    assert abs(found.scene.bodies[0].angle) <= 180.0
    assert difference(world, other) < 1e-11


def test_a_joint_that_has_only_borne_a_load_keeps_its_words() -> None:
    """What it bore when the world was put down is no change of the joint."""
    hinge = {"id": "pin", "type": "revolute", "bodies": ["bob"], "anchor": [0, 0]}
    bob = {"id": "bob", "shapes": [{"box": [1, 1]}], "position": [0, -1]}
    scene = Scene(bodies=[bob], joints=[hinge])
    world = World(scene)
    world.step(3)
    present = Present("test", world, scene)
    assert world.state.joints.preload_1[0] != 0.0
    assert not present.moved.any()
    assert not present.rejoined.any()


def test_what_bad_numbers_froze_is_static(tmp_path: Path) -> None:
    words = [{"id": name, "shapes": [{"circle": 1}], "position": [k, 0]} for k, name in enumerate(("a", "b"))]
    weld = {"id": "weld", "type": "weld", "bodies": ["a"], "anchor": [0, 0]}
    world = World(Scene(gravity=(0, 0), bodies=words, joints=[weld]))
    world.apply(ApplyForce("a", (1e300, 0.0)))
    world.step()
    assert world.body("a").type == "static"
    found, other = saved(world, tmp_path)
    assert other.body("a").type == "static"
    assert found.remarks == (
        "joints of bodies that are static now are left out: weld",
        "bodies that bad numbers froze are static for good: a",
    )


def test_a_world_of_a_flat_scene_needs_the_scene_of_its_author(world: World) -> None:
    flat = World(world.scene.flatten())
    with pytest.raises(ArgumentError, match="flat scene"):
        scene_of(flat)
    assert scene_of(flat, world.scene).scene is world.scene
    with pytest.raises(ArgumentError, match="did not begin with this scene"):
        scene_of(flat, Scene(bodies=[]))


def test_the_file_is_laid_out_and_checked(world: World, tmp_path: Path, cli: Callable[..., Any]) -> None:
    world.step(40)
    found, _ = saved(world, tmp_path)
    text = (tmp_path / "saved.scene.json").read_text(encoding="utf-8")
    assert max(map(len, text.splitlines())) < 160
    done = cli("check", tmp_path / "saved.scene.json")
    assert (done.code, done.err) == (0, "")
    assert found.scene.title == "Parts"
