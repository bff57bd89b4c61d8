"""Bodies like others that were read before: which body it is, where it is and how it moves is all that is read again.

A world in which the same things come again and again has few *templates*: entries less those five fields. What makes
an entry of a known one wrong can only be its own fields, so these alone are validated, by the fields of the same model
and all entries at once. Whoever asks is told nothing about mistakes: what is not plainly right has to be read in full.
"""

from __future__ import annotations

import marshal
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

from pydantic import TypeAdapter, ValidationError, create_model

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.base import Model
from sandbox.scene.body import Body
from sandbox.scene.flat import FlatBody

OWN = ("id", "position", "angle", "velocity", "angular_velocity")
"""The fields that bodies of one template have for themselves."""
_DEGREES = ("angle", "angular_velocity")
_STILL = ((0.0, 0.0), 0.0)
_WITHOUT_REFERENCES = 2
"""The version of `marshal` that writes equal values alike, whoever else holds them."""
_MOST = 1024
"""So many templates are kept; then all are forgotten."""

_FIELDS: dict[str, Any] = {name: (Body.model_fields[name].annotation, Body.model_fields[name]) for name in OWN}
_Own = create_model("_Own", __base__=Model, **_FIELDS)
_own = TypeAdapter(list[_Own])  # type: ignore[valid-type]
Key: TypeAlias = tuple[tuple[str, ...], bytes]
Words: TypeAlias = dict[str, Any]


@dataclass(frozen=True)
class _Template:
    """One body that was read: its flat fields, and its entry as a file holds it."""

    flat: dict[str, Any]
    words: Words


class Templates:
    """The templates of the bodies that one world has read."""

    def __init__(self) -> None:
        self._known: dict[Key, _Template] = {}

    def learn(self, entries: Sequence[Any], bodies: Sequence[FlatBody], words: Sequence[Words]) -> None:
        """Note the templates of entries that have been read in full, and found right."""
        for entry, body, plain in zip(entries, bodies, words, strict=True):
            key = _key(entry)
            if key is not None and key not in self._known:
                if len(self._known) >= _MOST:
                    self._known.clear()
                self._known[key] = _Template({item.name: getattr(body, item.name) for item in fields(body)}, plain)

    def read(self, entries: Sequence[Any]) -> list[tuple[FlatBody, Words]] | None:
        """Bodies and words of entries; None unless all are of known templates and right by themselves."""
        keys = [_key(entry) for entry in entries]
        templates = [self._known[key] for key in keys if key is not None and key in self._known]
        if len(templates) < len(entries):
            return None
        given = [key[0] for key in keys if key is not None]
        try:
            own = _own.validate_python(
                [{n: entry[n] for n in names} for entry, names in zip(entries, given, strict=True)]
            )
        except ValidationError:
            return None
        found = []
        words = _own.dump_python(own, mode="json", exclude_unset=True)
        for each, names, template, mine in zip(own, given, templates, words, strict=True):
            body = _flat(vars(each), names, template)
            if body is None:
                return None
            found.append((body, {**template.words, **mine}))
        return found


def _flat(own: Mapping[str, Any], given: Sequence[str], template: _Template) -> FlatBody | None:
    """A body of a template; None if it is one that may not move and does."""
    values = dict(template.flat)
    for name in given:
        values[name] = own[name] * RADIANS_PER_DEGREE if name in _DEGREES else own[name]
    if values["type"] == "static" and (values["velocity"], values["angular_velocity"]) != _STILL:
        return None
    body = object.__new__(FlatBody)
    vars(body).update(values)  # each field by itself takes three times as long
    return body


def _key(entry: Any) -> Key | None:
    """Equal for entries of one template, down to the types and the bits of their values; None for what is no entry.

    What is not of a plain type does not come back as it was, or not at all; bytes and sets do, but no model takes them.
    """
    if type(entry) is not dict:
        return None
    given = tuple(name for name in OWN if name in entry)
    rest = {name: value for name, value in entry.items() if name not in given}
    try:
        written = marshal.dumps(rest, _WITHOUT_REFERENCES)
        return (given, written) if marshal.loads(written) == rest else None
    except ValueError:
        return None
