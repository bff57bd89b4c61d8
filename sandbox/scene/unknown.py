"""Mistakes in field names: unknown ones, and objects whose kind they do not tell."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import islice
from typing import Any

from pydantic import BaseModel

from sandbox.scene.body import Body, Prefab
from sandbox.scene.constraints import describe
from sandbox.scene.expect import CONDITIONS
from sandbox.scene.finding import Finding, Path, did_you_mean, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.joints import JOINTS
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.material import Material
from sandbox.scene.regions import REGIONS
from sandbox.scene.settings import Settings, View
from sandbox.scene.shapes import SHAPES
from sandbox.scene.thruster import Thruster
from sandbox.scene.union import TAG

_UNIONS: dict[str, Mapping[str, type[BaseModel]]] = {
    "shape": SHAPES,
    "generator": GENERATORS,
    "expectation": CONDITIONS,
    "region": REGIONS,
}
_KINDS: dict[str, type[BaseModel]] = {**SHAPES, **GENERATORS, **CONDITIONS, **JOINTS, **REGIONS}
_FIELDS: dict[str, type[BaseModel]] = {
    "bodies": Body,
    "prefabs": Prefab,
    "materials": Material,
    "settings": Settings,
    "view": View,
}
TAGS = {TAG + key for key in (*_KINDS, "number", "text", "list")}
"""What pydantic puts into locations to tell the kinds of a union."""

_HOMES: dict[str, type[BaseModel]] = {
    "a material": Material,
    "a shape": SHAPES["box"],
    "a body": Body,
    '"settings"': Settings,
    '"view"': View,
}


def unknown_field(path: Path, known: list[str]) -> Finding:
    name = str(path[-1])
    hint = did_you_mean(name, known)
    homes = [home for home, model in _HOMES.items() if name in model.model_fields]
    if homes and hint != f'did you mean "{name}"?':
        hint = f"it belongs in {' or '.join(homes)}"
    return Finding(path, f"unknown field {quoted(name)}", hint, on_key=True)


def no_kind(path: Path, item: Mapping[str, Any]) -> list[Finding]:
    """An object of a union of which no kind, or more than one, can be told."""
    value, what = item["input"], item["msg"]
    kinds = list(_UNIONS[what])
    fields = list(dict.fromkeys(name for kind in _UNIONS[what].values() for name in kind.model_fields))
    article = "an" if what[0] in "aeiou" else "a"
    if not isinstance(value, dict):
        return [
            Finding(
                path,
                f'{article} {what} must be an object such as {{"{kinds[0]}": ...}}, not {describe(value)}',
            )
        ]
    given = [key for key in kinds if key in value]
    if given:
        listed = " and ".join(f'"{key}"' for key in given)
        return [Finding((*path, given[-1]), f"{article} {what} has one kind, and this one has {listed}", on_key=True)]
    strays = [key for key in islice(value, MAX_FINDINGS) if key not in fields]
    unknown = [unknown_field((*path, key), fields) for key in strays]
    if any(did_you_mean(key, kinds) for key in strays):
        return unknown
    listed = ", ".join(f'"{key}"' for key in kinds)
    return [Finding(path, f"{article} {what} needs one of {listed}"), *unknown]


def no_type(path: Path, item: Mapping[str, Any]) -> list[Finding]:
    """A joint whose `type` is missing or unknown."""
    value, what = item["input"], item["msg"]
    if not isinstance(value, dict):
        return [Finding(path, f'a {what} must be an object such as {{"type": "revolute", ...}}, not {describe(value)}')]
    kinds = [*JOINTS]
    given = value.get("type")
    listed = ", ".join(f'"{key}"' for key in kinds)
    if isinstance(given, str):
        return [Finding((*path, "type"), f"type must be one of {listed}", did_you_mean(given, kinds))]
    if "type" in value:
        return [Finding((*path, "type"), f"type must be text, not {describe(given)}")]
    near = [key for key in islice(value, MAX_FINDINGS) if did_you_mean(key, ["type"])]
    if near:
        return [unknown_field((*path, near[0]), ["type"])]
    return [Finding(path, f'a {what} needs a "type", one of {listed}')]


def model_at(loc: Path, root: type[BaseModel] | None) -> type[BaseModel] | None:
    """The model that a pydantic location lies in."""
    model = root
    for place, part in enumerate(loc):
        if part in TAGS:
            model = _KINDS.get(str(part)[len(TAG) :], model)
        elif place == 0 and part in _FIELDS:
            model = _FIELDS[part]
        elif part == "thrusters":
            model = Thruster
    return model


def names(model: type[BaseModel] | None) -> list[str]:
    """The fields of a model by the names they have in a file."""
    fields = model.model_fields if model else {}
    return [field.alias or name for name, field in fields.items()]
