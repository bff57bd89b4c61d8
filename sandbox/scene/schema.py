"""The JSON Schema of a scene file, made from the models, for editors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from sandbox.scene.parse import COMMENT
from sandbox.scene.pretty import pretty
from sandbox.scene.scene import Scene
from sandbox.scene.snippets import BODIES, KINDS, snippets
from sandbox.scene.union import UNIONS

Schema = dict[str, Any]
ADDRESS = "urn:sandbox2d:scene:1"
_REMARK = {"description": "For whoever reads the file; the program leaves it out."}
_TELLING = "type"
"""The field by whose value the kinds of a union are told apart that all have it; others have a key each."""


def schema() -> Schema:
    """JSON Schema (draft 2020-12) of format 1, with descriptions, units, and snippets for editors."""
    made = _tidy(Scene.model_json_schema(by_alias=True))
    definitions = made.pop("$defs")
    unions = {_refs(kinds): name for name, kinds in UNIONS.items()}
    parts = {name: _told_apart(node, unions) for name, node in definitions.items()}
    parts |= {_title(name): _union(name, kinds, definitions) for name, kinds in UNIONS.items()}
    parts["Body"]["defaultSnippets"] = snippets(BODIES)
    root = _told_apart(made, unions)
    for node in (root, *parts.values()):
        if node.get("additionalProperties") is False:
            node["properties"][COMMENT] = _REMARK
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": ADDRESS,
        "title": "Scene, format 1",
        **{key: value for key, value in root.items() if key != "title"},
        "$defs": dict(sorted(parts.items())),
    }


def schema_text() -> str:
    """The text of `scenes/scene.schema.json`."""
    return pretty(schema()) + "\n"


def _told_apart(node: Any, unions: Mapping[tuple[str, ...], str]) -> Any:
    """The same with a reference wherever one of the kinds of a union is wanted."""
    if isinstance(node, list):
        return [_told_apart(entry, unions) for entry in node]
    if not isinstance(node, dict):
        return node
    name = unions.get(tuple(entry.get("$ref", "") for entry in node.get("oneOf", ())))
    if name is None:
        return {key: _told_apart(value, unions) for key, value in node.items()}
    return {**{key: value for key, value in node.items() if key != "oneOf"}, "$ref": f"#/$defs/{_title(name)}"}


def _union(name: str, kinds: Mapping[str, type[BaseModel]], definitions: Mapping[str, Schema]) -> Schema:
    """Who has told its kind is judged as that kind alone, so that a mistake in it is the one that is told."""
    by_value = all(_TELLING in kind.model_fields for kind in kinds.values())
    own = {key: definitions[kind.__name__] for key, kind in kinds.items()}
    told: Schema
    if by_value:
        described = [f"{key}: {own[key]['properties'][_TELLING]['description']}" for key in kinds]
        choice = {"description": "Which kind it is.", "enum": list(kinds), "enumDescriptions": described}
        told = {"properties": {_TELLING: choice}, "required": [_TELLING]}
        tests = [{"properties": {_TELLING: {"const": key}}, "required": [_TELLING]} for key in kinds]
    else:
        told = {"properties": {key: {"description": own[key]["properties"][key]["description"]} for key in kinds}}
        told["oneOf"] = tests = [{"required": [key]} for key in kinds]
    branches = zip(tests, _refs(kinds), strict=True)
    return {
        "description": f"Exactly one of {', '.join(kinds)} tells the kind.",
        "type": "object",
        **told,
        "allOf": [{"if": test, "then": {"$ref": ref}} for test, ref in branches],
        **({"defaultSnippets": snippets(KINDS[name])} if name in KINDS else {}),
    }


def _refs(kinds: Mapping[str, type[BaseModel]]) -> tuple[str, ...]:
    return tuple(f"#/$defs/{kind.__name__}" for kind in kinds.values())


def _title(name: str) -> str:
    return f"Any{name.capitalize()}"


def _tidy(node: Any, in_list: bool = False) -> Any:
    """Without what says nothing to an author: titles made from names, and null as a way to leave a field out.

    Within a list, null is an entry of its own.
    """
    if isinstance(node, list):
        return [_tidy(entry) for entry in node]
    if not isinstance(node, dict):
        return node
    kept = {key: _tidy(value, key == "items") for key, value in node.items() if not _is_noise(key, value)}
    choices = [entry for entry in kept.get("anyOf", ()) if entry != {"type": "null"}]
    if len(choices) == 1 and not in_list:
        kept = {**choices[0], **{key: value for key, value in kept.items() if key != "anyOf"}}
    return _or_expression(kept) if kept.get("type") in ("number", "integer") and "const" not in kept else kept


def _or_expression(number: dict[str, Any]) -> dict[str, Any]:
    """Where a number may stand, an expression may; the limits of the one say nothing about the other."""
    return {**number, "type": [number["type"], "string"], "pattern": "^="}


def _is_noise(key: str, value: Any) -> bool:
    return (key == "title" and isinstance(value, str)) or (key == "default" and value is None)
