"""The JSON Schema of a scene file, made from the models, for editors."""

from __future__ import annotations

from typing import Any

from sandbox.scene.pretty import pretty
from sandbox.scene.scene import Scene


def schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of format 1, with descriptions and units."""
    made = Scene.model_json_schema(by_alias=True)
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Scene, format 1"}
    return {**head, **{key: value for key, value in made.items() if key != "title"}}


def schema_text() -> str:
    """The text of `scenes/scene.schema.json`."""
    return pretty(schema()) + "\n"
