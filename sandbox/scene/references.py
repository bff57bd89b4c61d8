"""Names that refer to something: materials, prefabs, categories, and the bodies of expectations."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

from sandbox.scene import plain
from sandbox.scene.expect import is_pattern, matching_ids
from sandbox.scene.finding import Finding, Path, did_you_mean, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.names import BodyNames

_BODY_FIELDS = ("rests", "stands", "asleep", "touches", "apart", "of")


def unknown_names(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    """A finding for every name that refers to nothing."""
    materials = plain.mapping(data.get("materials"))
    for path, node in [*plain.patterns(data), *plain.shapes(data)]:
        yield from _unknown(node, path, "material", "material", materials)
    yield from _prefabs(data)
    yield from _categories(data)
    yield from _bodies(data, ids)


def _unknown(
    node: dict[str, Any], path: Path, field: str, what: str, known: Collection[str]
) -> Iterator[Finding]:
    for place, name in plain.texts(node.get(field), (*path, field)):
        if name not in known:
            yield Finding(place, f"no {what} is named {quoted(name)}", did_you_mean(name, known))


def _prefabs(data: dict[str, Any]) -> Iterator[Finding]:
    known = plain.mapping(data.get("prefabs"))
    for path, body in plain.children(data.get("bodies"), ("bodies",)):
        yield from _unknown(body, path, "prefab", "prefab", known)
    for path, generator in plain.children(data.get("generate"), ("generate",)):
        for kind in GENERATORS:
            if isinstance(generator.get(kind), str):
                yield from _unknown(generator, path, kind, "prefab", known)


def _categories(data: dict[str, Any]) -> Iterator[Finding]:
    known = ["default", *(name for _, name in plain.texts(data.get("categories"), ()))]
    for path, shape in plain.shapes(data):
        for field in ("category", "mask"):
            yield from _unknown(shape, path, field, "category", known)


def _bodies(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    names = list(ids.origins)
    for path, expectation in plain.children(data.get("expect"), ("expect",)):
        for field in _BODY_FIELDS:
            for place, name in plain.texts(expectation.get(field), (*path, field)):
                yield from _body(name, place, ids, names)


def _body(name: str, place: Path, ids: BodyNames, names: list[str]) -> Iterator[Finding]:
    if not ids.counted or name.startswith(ids.unread):
        return
    if not is_pattern(name) and name not in ids.origins:
        yield Finding(place, f"no body has the id {quoted(name)}", did_you_mean(name, names))
    elif is_pattern(name) and not ids.unread and not matching_ids(name, names):
        yield Finding(place, f"no body's id matches {quoted(name)}")
