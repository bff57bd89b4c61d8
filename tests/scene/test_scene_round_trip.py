"""Random valid scenes load, save and load again as the same scene."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import jsonschema
import pytest
from hypothesis import given

from sandbox.scene import Scene, load_scene, loads_scene, schema
from tests.examples import examples
from tests.scene.scene_strategies import scenes

VALIDATOR = jsonschema.Draft202012Validator(schema())


@given(scenes())
def test_a_saved_scene_loads_to_an_equal_scene(data):
    scene = loads_scene(json.dumps(data))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "x.scene.json"
        scene.save(path)
        again = load_scene(path)
        text = path.read_text(encoding="utf-8")
        again.save(path)
        assert path.read_text(encoding="utf-8") == text
    assert again == scene
    assert again.flatten() == scene.flatten()


@given(scenes())
def test_python_and_file_build_the_same_scene(data):
    built, loaded = Scene(**data), loads_scene(json.dumps(data))
    assert built == loaded
    assert built.flatten() == loaded.flatten()


@given(scenes())
@examples(50)
def test_the_json_schema_accepts_what_the_loader_accepts(data):
    loads_scene(json.dumps(data))
    VALIDATOR.validate(data)


def test_the_json_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(schema())


@pytest.mark.parametrize(
    "data",
    [
        {"bodies": [{"shapes": [{"circle": 1}]}]},
        {"bodies": [{"id": "a", "shapes": [{"circle": -1}]}]},
        {"bodies": [{"id": "a", "shapes": [{"disc": 1}]}]},
        {"bodies": [{"id": "a", "shpaes": []}]},
        {"format": 2},
        {"gravity": [0]},
    ],
)
def test_the_json_schema_refuses_mistakes(data):
    with pytest.raises(jsonschema.ValidationError):
        VALIDATOR.validate(data)


def test_a_scene_with_other_values_is_not_equal():
    one = Scene(bodies=[{"id": "a", "shapes": [{"circle": 1}]}])
    two = Scene(bodies=[{"id": "a", "shapes": [{"circle": 2}]}])
    assert one != two
    assert one == Scene(bodies=[{"id": "a", "shapes": [{"circle": 1.0}]}])
