"""What becomes of numbers, parameters and includes where a scene is saved, copied, or made of a world."""

from __future__ import annotations

import pytest

from sandbox import World, scene_of
from sandbox.resources import find_scene, part_file, shipped_parts
from sandbox.scene import Material, Scene, load_scene, schema
from sandbox.scene.parse import parse

NAMES = ("convoy", "growing-dominoes")


def shipped(name):
    from pathlib import Path

    return load_scene(find_scene(Path(name)))


@pytest.mark.parametrize("name", NAMES)
def test_a_saved_scene_is_what_its_author_wrote(name, tmp_path):
    scene = shipped(name)
    scene.save(tmp_path / "x.json")
    assert parse((tmp_path / "x.json").read_text(), "x").data == parse(scene.text, "y").data
    assert load_scene(tmp_path / "x.json") == scene


@pytest.mark.parametrize("name", NAMES)
def test_a_world_that_has_gone_on_is_saved_with_all_its_bodies(name, tmp_path):
    scene = shipped(name)
    world = World(scene)
    assert scene_of(world).scene is scene
    world.step(5)
    now = scene_of(world).scene
    now.save(tmp_path / "x.json")
    again = load_scene(tmp_path / "x.json")
    assert again == now
    assert [body.id for body in again.flatten().bodies] == [body.id for body in scene.flatten().bodies]


def test_a_copy_has_what_was_worked_out():
    scene = Scene(vars={"a": 2}, gravity=(0, "=a"), materials={"m": Material(friction=1)})
    copy = scene.model_copy(update={"title": "Two"})
    assert (copy.gravity, copy.title, copy.vars) == ((0, 2), "Two", {"a": 2})
    assert copy.written()["materials"] == {"m": {"friction": 1}}


@pytest.mark.parametrize("name", shipped_parts())
def test_parts_follow_the_schema(name):
    import json

    import jsonschema

    words = json.loads(part_file(name).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema()).validate(words)
    assert words["title"]
    assert words["about"]
