"""The schema for editors: mistakes are told by the kind of what was written, and snippets are right."""

from __future__ import annotations

import json
import re
from typing import Any

import jsonschema
import pytest

from sandbox.scene import loads_scene, schema
from sandbox.scene.snippets import BODIES, KINDS
from sandbox.scene.union import UNIONS

SCHEMA = schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
PLACES = {"joint": "joints", "generator": "generate", "expectation": "expect", "region": "regions"}


def mistakes(**fields: Any) -> list[str]:
    """What a validator says of a scene."""
    return [error.message for error in VALIDATOR.iter_errors(fields)]


def filled(snippet: Any) -> Any:
    """A snippet with its defaults filled in, as an editor would insert it."""
    if isinstance(snippet, list):
        return [filled(entry) for entry in snippet]
    if isinstance(snippet, dict):
        return {key: filled(value) for key, value in snippet.items()}
    if not isinstance(snippet, str):
        return snippet
    text = re.sub(r"\$\{\d+[:|]([^}|,]*)[^}]*\}", r"\1", snippet)
    return json.loads(text[1:]) if text.startswith("^") else text


def test_a_mistake_in_a_joint_is_told_for_its_type() -> None:
    hinge = {"id": "h", "type": "revolute", "bodies": ["a"], "anchor": [0, 0]}
    assert mistakes(joints=[hinge]) == []
    assert mistakes(joints=[{**hinge, "motr_speed": 1}]) == [
        "Additional properties are not allowed ('motr_speed' was unexpected)"
    ]
    del hinge["anchor"]
    assert mistakes(joints=[hinge]) == ["'anchor' is a required property"]
    assert "'hinge' is not one of ['distance', 'revolute'" in mistakes(joints=[{**hinge, "type": "hinge"}])[0]
    assert mistakes(joints=[{"id": "h"}]) == ["'type' is a required property"]


def test_a_mistake_in_a_shape_is_told_for_its_kind() -> None:
    def of(shape: dict[str, Any]) -> list[str]:
        return mistakes(prefabs={"p": {"shapes": [shape]}})

    assert of({"circle": 1}) == []
    assert of({"circle": 1, "raduis": 2}) == ["Additional properties are not allowed ('raduis' was unexpected)"]
    assert of({"circle": "1"}) == ["'1' does not match '^='"]
    assert of({"circle": 1, "box": [1, 1]}) != []
    assert of({}) != []


def test_the_schema_is_a_schema_with_an_address() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$id"].startswith("urn:")
    refs = set(re.findall(r'"\$ref": "#/\$defs/(\w+)"', json.dumps(SCHEMA)))
    assert refs <= SCHEMA["$defs"].keys()


def test_any_object_may_have_a_comment_which_nobody_reads() -> None:
    text = """{"$comment": "all", "bodies": [{"$comment": ["of", "any", {"kind": 1}], "id": "a",
        "shapes": [{"$comment": "round", "circle": 1}]}], "expect": [{"$comment": "", "at": 0, "above": -1}]}"""
    VALIDATOR.validate(json.loads(text))
    assert loads_scene(text).to_data() == {
        "bodies": [{"id": "a", "shapes": [{"circle": 1.0}]}],
        "expect": [{"at": 0, "above": -1.0}],
    }


@pytest.mark.parametrize("what", KINDS)
def test_snippets_are_entries_of_their_kind(what: str) -> None:
    for kind, snippet in KINDS[what].items():
        UNIONS[what][kind].model_validate_json(json.dumps(filled(snippet)))
        if what in PLACES:
            assert mistakes(**{PLACES[what]: [filled(snippet)]}) == []


def test_there_is_a_snippet_for_every_kind_that_a_scene_begins_with() -> None:
    for what in ("shape", "joint", "generator", "expectation"):
        assert KINDS[what].keys() == UNIONS[what].keys()
    bodies = [{**filled(snippet), "id": f"b-{k}"} for k, snippet in enumerate(BODIES.values())]
    loads_scene(json.dumps({"bodies": bodies, "prefabs": {"prefab": {"shapes": [{"circle": 1}]}}}))
