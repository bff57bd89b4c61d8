"""The schema for editors: mistakes are told by the kind of what was written, and snippets are right."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
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


STOP = re.compile(r"\$\{(\d+)(?::([^${}|]*)|\|([^${}|]+)\|)\}")
"""A place to fill in: `${1:default}` or `${1|one,other|}`. Neither may hold what an editor would take for more."""


def inserted(body: Any) -> str:
    """The text that an editor makes of the body of a snippet: JSON, but what begins with ^ is put in as it is."""
    if isinstance(body, list):
        return f"[{', '.join(map(inserted, body))}]"
    if isinstance(body, dict):
        return "{" + ", ".join(f"{json.dumps(key)}: {inserted(value)}" for key, value in body.items()) + "}"
    return body[1:] if isinstance(body, str) and body.startswith("^") else json.dumps(body)


def filled(body: Any, choice: int = 0) -> Any:
    """What is there when nothing but a choice is made in the places to fill in."""

    def chosen(found: re.Match[str]) -> str:
        _, default, choices = found.groups()
        return default if choices is None else choices.split(",")[choice % len(choices.split(","))]

    return json.loads(STOP.sub(chosen, inserted(body)))


def lists_of_snippets(node: Any) -> Iterator[list[Any]]:
    """All `defaultSnippets` of a schema."""
    for key, value in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
        if key == "defaultSnippets":
            yield value
        else:
            yield from lists_of_snippets(value)


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
        for entry in (filled(snippet, choice) for choice in range(4)):
            UNIONS[what][kind].model_validate_json(json.dumps(entry))
            if what in PLACES:
                assert mistakes(**{PLACES[what]: [entry]}) == []


def test_an_editor_reads_snippets_as_they_are_meant() -> None:
    """What VS Code takes from a schema: https://code.visualstudio.com/docs/languages/json#_define-snippets-in-json-schemas"""
    found = list(lists_of_snippets(SCHEMA))
    assert len(found) == 1 + len(KINDS)
    for each in found:
        assert len({snippet["label"] for snippet in each}) == len(each)
        for snippet in each:
            assert snippet.keys() == {"label", "body"}
            text = inserted(snippet["body"])
            assert "$" not in STOP.sub("", text)
            stops = [(int(number), default or choices) for number, default, choices in STOP.findall(text)]
            assert {number for number, _ in stops} == set(range(1, len(dict(stops)) + 1))  # from the first one on
            assert len(set(stops)) == len(dict(stops))  # equal numbers are filled in together: they begin equal


def test_there_is_a_snippet_for_every_kind_that_a_scene_begins_with() -> None:
    for what in ("shape", "joint", "generator", "expectation"):
        assert KINDS[what].keys() == UNIONS[what].keys()
    bodies = [{**filled(snippet), "id": f"b-{k}"} for k, snippet in enumerate(BODIES.values())]
    loads_scene(json.dumps({"bodies": bodies, "prefabs": {"prefab": {"shapes": [{"circle": 1}]}}}))
