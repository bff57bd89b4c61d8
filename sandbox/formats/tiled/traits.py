"""What names and properties of Tiled say of bodies and surfaces."""

from __future__ import annotations

from typing import Any

from sandbox.formats.numbers import tidy
from sandbox.formats.outlines import Words
from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks

_KINDS = ("static", "kinematic", "dynamic")
_TYPE_KEYS = ("body", "bodytype", "body_type", "type", "physics")
_SOLID_KEYS = ("collides", "collidable", "collision", "solid")
_SHAPE = {
    "density": ("density", 1e9), "friction": ("friction", 1e3), "restitution": ("restitution", 1.0),
    "bounce": ("restitution", 1.0),
}  # fmt: skip
_BODY = {"lineardamping": "linear_damping", "angulardamping": "angular_damping", "gravityscale": "gravity_scale"}
_FLAGS = {"fixedrotation": "fixed_rotation", "bullet": "bullet"}


def properties_of(node: Node) -> dict[str, Any]:
    """Properties by name in lower case, of new files (a list) and old ones (an object)."""
    given = node.data.get("properties")
    if isinstance(given, dict):
        return {str(key).lower(): value for key, value in given.items()}
    return {each.text("name").lower(): each.data.get("value") for each in node.nodes("properties")}


def kind_of(node: Node) -> str:
    """The type of body that a property, the class, or the name of an object or layer asks for; "" if none does."""
    properties = properties_of(node)
    said = [properties.get(key) for key in _TYPE_KEYS]
    said += [kind for kind in _KINDS if properties.get(kind) is True]
    said += [node.data.get(key) for key in ("class", "type", "name")]
    words = (value.lower() for value in said if isinstance(value, str))
    return next((word for word in words if word in _KINDS), "")


def is_solid(node: Node) -> bool:
    """Whether a property says that a tile, or a whole layer, is solid."""
    properties = properties_of(node)
    return any(properties.get(key) is True for key in _SOLID_KEYS)


def surface_words(node: Node) -> Words:
    """Fields of a shape."""
    found: Words = {}
    for key, value in properties_of(node).items():
        if key in _SHAPE and _is_number(value):
            name, most = _SHAPE[key]
            found[name] = tidy(min(max(float(value), 0.0), most))
        elif key == "sensor" and value is True:
            found["sensor"] = True
    return found


def body_words(node: Node) -> Words:
    """Fields of a body that moves."""
    found: Words = {}
    for key, value in properties_of(node).items():
        plain = key.replace("_", "")
        if plain in _BODY and _is_number(value):
            found[_BODY[plain]] = tidy(float(value))
        elif plain in _FLAGS and value is True:
            found[_FLAGS[plain]] = True
    return found


def note_others(node: Node, remarks: Remarks) -> None:
    """A remark on properties that mean nothing here."""
    plain = {key: key.replace("_", "") for key in properties_of(node)}
    known = {*_KINDS, *_TYPE_KEYS, *_SOLID_KEYS, *_SHAPE, "sensor"}
    others = [key for key, word in plain.items() if key not in known and word not in {*_BODY, *_FLAGS}]
    if others:
        place = f"{node.place} ({', '.join(others)[:80]})".strip()
        remarks.note(place, "properties that mean nothing to a scene are left out")


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e20
