"""The format reference tells the truth: its examples load, its tables name every field, its errors are real."""

from __future__ import annotations

import json
import re
from pathlib import Path

import jsonschema
import pytest

from sandbox.errors import SceneError
from sandbox.scene import Body, Material, Prefab, Scene, Settings, load_scene, loads_scene, schema
from sandbox.scene.expect import CONDITIONS
from sandbox.scene.generators import GENERATORS
from sandbox.scene.play.any_action import ACTIONS
from sandbox.scene.play.control import KEYS, MOUSE_INPUTS, PAD_INPUTS, InputControl
from sandbox.scene.play.path import BodyPath
from sandbox.scene.play.rule import Condition, Rule
from sandbox.scene.play.setting_actions import RegionFields
from sandbox.scene.play.triggers import TRIGGERS
from sandbox.scene.regions import REGIONS
from sandbox.scene.schema import schema_text
from sandbox.scene.shapes import SHAPES
from sandbox.scene.thruster import Thruster

SCENES = Path(__file__).parents[2] / "scenes"
README = (SCENES / "README.md").read_text(encoding="utf-8")


SCHEMA = schema()


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("text", blocks("json"))
def test_every_example_loads(text):
    scene = loads_scene(text)
    assert scene.flatten().bodies


def test_there_are_examples():
    assert len(blocks("json")) >= 7


def test_the_python_example_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (code,) = blocks("python")
    exec(code, {})
    assert len(load_scene(tmp_path / "two.scene.json").bodies) == 2


def test_the_error_example_is_real():
    (told,) = blocks("text")
    shown = dict(re.findall(r"^ +(\d+) \| (.*)$", told, re.MULTILINE))
    text = "{\n\n" + shown["3"] + "\n" + shown["4"] + "\n}"
    with pytest.raises(SceneError) as caught:
        loads_scene(text, "crates.scene.json")
    assert str(caught.value) == told.rstrip("\n")


MODELS = [Scene, Body, Prefab, Material, Settings, Thruster]


PLAY = [Rule, Condition, InputControl, BodyPath, RegionFields, *ACTIONS.values(), *TRIGGERS.values()]


@pytest.mark.parametrize("model", [*MODELS, *PLAY, *SHAPES.values(), *GENERATORS.values(), *REGIONS.values()])
def test_every_field_is_explained(model):
    for name, field in model.model_fields.items():
        assert field.description, name
        assert f"`{field.alias or name}`" in README or f'`"{name}":' in README, name


@pytest.mark.parametrize("kind", [*SHAPES, *GENERATORS, *CONDITIONS, *REGIONS, *ACTIONS, *TRIGGERS])
def test_every_kind_is_explained(kind):
    assert f'`"{kind}":' in README


def test_every_input_is_named():
    named = [*(key for key in KEYS if len(key) > 1), *PAD_INPUTS, *MOUSE_INPUTS]
    assert [name for name in named if f"`{name}`" not in README] == []


def test_the_shipped_schema_is_that_of_the_models():
    # To write it anew: python -c "from sandbox.scene.schema import *; print(schema_text(), end='')" > FILE
    assert (SCENES / "scene.schema.json").read_text(encoding="utf-8") == schema_text()


def test_every_property_of_the_schema_is_described():
    definitions = SCHEMA["$defs"]
    for name, definition in definitions.items():
        for field, value in definition["properties"].items():
            assert value.get("description"), (name, field)
    assert json.loads(schema_text()) == SCHEMA


@pytest.mark.parametrize("path", sorted(SCENES.rglob("*.scene.json")), ids=lambda path: path.name)
def test_every_shipped_scene_follows_the_schema(path):
    jsonschema.Draft202012Validator(SCHEMA).validate(json.loads(path.read_text(encoding="utf-8")))
    scene = load_scene(path)
    assert scene.schema_uri == "../scene.schema.json"
    assert scene.title
    assert scene.about
    assert scene.expect
