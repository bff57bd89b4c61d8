"""Pydantic's validation errors in the words of a scene's author."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel, ValidationError

from sandbox.scene.body import Body, Prefab
from sandbox.scene.expect import CONDITIONS
from sandbox.scene.finding import Finding, Path, did_you_mean, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.material import Material
from sandbox.scene.quantities import describe
from sandbox.scene.settings import Settings, View
from sandbox.scene.shapes import SHAPES
from sandbox.scene.union import TAG

_UNIONS: dict[str, Mapping[str, type[BaseModel]]] = {
    "shape": SHAPES,
    "generator": GENERATORS,
    "expectation": CONDITIONS,
}
_KINDS: dict[str, type[BaseModel]] = {**SHAPES, **GENERATORS, **CONDITIONS}
_FIELDS: dict[str, type[BaseModel]] = {
    "bodies": Body,
    "prefabs": Prefab,
    "materials": Material,
    "settings": Settings,
    "view": View,
}
_HOMES: dict[str, type[BaseModel]] = {
    "a material": Material,
    "a shape": SHAPES["box"],
    "a body": Body,
    '"settings"': Settings,
    '"view"': View,
}
_WANTED = {
    "float_type": "must be a number",
    "int_type": "must be a whole number",
    "bool_type": "must be true or false",
    "string_type": "must be text",
    "model_type": "must be an object {...}",
    "model_attributes_type": "must be an object {...}",
    "dict_type": "must be an object {...}",
}


def findings(error: ValidationError, root: type[BaseModel] | None = None) -> list[Finding]:
    """The findings of a validation of `root` (None: some part of a scene), in pydantic's order."""
    found: list[Finding] = []
    for item in error.errors(include_url=False):
        found += _reworded(item, root)
    return found


def _reworded(item: Mapping[str, Any], root: type[BaseModel] | None) -> list[Finding]:
    loc = item["loc"]
    path: Path = tuple(part for part in loc if not (isinstance(part, str) and part.startswith(TAG)))
    kind = item["type"]
    if kind == "extra_forbidden":
        return [_unknown_field(path, _names(_model_at(loc[:-1], root)))]
    if kind == "missing":
        return [Finding(path[:-1], f'"{path[-1]}" is missing')]
    if kind == "kind":
        return _no_kind(path, item)
    if path and path[-1] == "[key]":
        return [Finding(path[:-1], f"the name {quoted(str(path[-2]))} {item['msg']}", on_key=True)]
    message, hint = _message(item)
    if kind in ("polygon", "ends"):
        index = item["ctx"]["index"]
        return [Finding(path if index is None else (*path, index), message)]
    return [Finding(path, f"{_label(path)}{message}", hint)]


def _message(item: Mapping[str, Any]) -> tuple[str, str]:
    kind, value, context = item["type"], item["input"], item.get("ctx", {})
    if kind in _WANTED:
        wanted = _WANTED[kind]
        same = kind == "int_type" and isinstance(value, float)
        return (wanted, "") if same else (f"{wanted}, not {describe(value)}", "")
    if kind == "literal_error":
        return _not_a_choice(value, context["expected"])
    if kind == "choice":
        shown = str(value) if isinstance(value, float) else describe(value)
        return f"must be {item['msg']}, not {shown}", ""
    fixed = {
        "finite_number": "must be a finite number",
        "int_from_float": "must be a whole number",
        "string_unicode": "is not valid text",
        "string_too_short": "must not be empty",
    }
    return fixed.get(kind, str(item["msg"])), ""


def _not_a_choice(value: object, expected: str) -> tuple[str, str]:
    names = re.findall(r"'([^']*)'", expected)
    if not names:
        return f"must be {expected.lower()}", ""
    listed = ", ".join(f'"{name}"' for name in names)
    return f"must be one of {listed}", did_you_mean(value, names) if isinstance(value, str) else ""


def _label(path: Path) -> str:
    """How to name the value at a path: its field's name, with indices behind it."""
    keys = [i for i, part in enumerate(path) if isinstance(part, str)]
    if not keys:
        return ""
    return f"{path[keys[-1]]}{''.join(f'[{part}]' for part in path[keys[-1] + 1 :])} "


def _unknown_field(path: Path, known: list[str]) -> Finding:
    name = str(path[-1])
    hint = did_you_mean(name, known)
    homes = [home for home, model in _HOMES.items() if name in model.model_fields]
    if homes and hint != f'did you mean "{name}"?':
        hint = f"it belongs in {' or '.join(homes)}"
    return Finding(path, f"unknown field {quoted(name)}", hint, on_key=True)


def _no_kind(path: Path, item: Mapping[str, Any]) -> list[Finding]:
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
        return [
            Finding(
                (*path, given[-1]), f"{article} {what} has one kind, and this one has {listed}", on_key=True
            )
        ]
    strays = [key for key in value if key not in fields]
    unknown = [_unknown_field((*path, key), fields) for key in strays]
    if any(did_you_mean(key, kinds) for key in strays):
        return unknown
    listed = ", ".join(f'"{key}"' for key in kinds)
    return [Finding(path, f"{article} {what} needs one of {listed}"), *unknown]


def _model_at(loc: Path, root: type[BaseModel] | None) -> type[BaseModel] | None:
    """The model that a pydantic location lies in."""
    model = root
    for place, part in enumerate(loc):
        if isinstance(part, str) and part.startswith(TAG):
            model = _KINDS[part[len(TAG) :]]
        elif place == 0 and part in _FIELDS:
            model = _FIELDS[part]
    return model


def _names(model: type[BaseModel] | None) -> list[str]:
    """The fields of a model by the names they have in a file."""
    fields = model.model_fields if model else {}
    return [field.alias or name for name, field in fields.items()]
