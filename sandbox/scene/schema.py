"""The JSON Schema of a scene file, made from the models, for editors."""

from __future__ import annotations

from typing import Any

from sandbox.scene.pretty import pretty
from sandbox.scene.scene import Scene


def schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of format 1, with descriptions and units."""
    made = _tidy(Scene.model_json_schema(by_alias=True))
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Scene, format 1",
        **{key: value for key, value in made.items() if key != "title"},
    }


def schema_text() -> str:
    """The text of `scenes/scene.schema.json`."""
    return pretty(schema()) + "\n"


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
