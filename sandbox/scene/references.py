"""Names that refer to something: materials, prefabs, categories, and the bodies of expectations."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body_refs import BODY_FIELDS, is_pattern, matches_any
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.joint_references import joint_references
from sandbox.scene.known import Known
from sandbox.scene.limits import MAX_EXPECTATIONS, MAX_MATCHES, MAX_NAME
from sandbox.scene.names import BodyNames
from sandbox.scene.near_names import did_you_mean

MOVING = "moving"
"""What a camera follows that goes with whatever moves."""
_TOO_MANY = f"there are too many patterns for so many bodies; patterns times bodies may be {MAX_MATCHES:,}"


def unknown_names(data: dict[str, Any], ids: BodyNames, known: Known) -> Iterator[Finding]:
    """A finding for every name that refers to nothing."""
    materials = plain.mapping(data.get("materials"))
    for path, node in [*plain.patterns(data), *plain.shapes(data)]:
        yield from _unknown(node, path, "material", "material", materials)
    yield from _prefabs(data)
    yield from _categories(data)
    yield from _bodies(data, ids)
    yield from _followed(data, ids)
    yield from joint_references(data, ids, known.kinds)


def _unknown(node: dict[str, Any], path: Path, field: str, what: str, known: Collection[str]) -> Iterator[Finding]:
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
    if not ids.counted:
        return
    known: dict[str, bool] = {}
    left = MAX_MATCHES
    for path, expectation in islice(plain.children(data.get("expect"), ("expect",)), MAX_EXPECTATIONS):
        for field in BODY_FIELDS:
            for place, name in plain.texts(expectation.get(field), (*path, field)):
                if len(name) > MAX_NAME:  # its own model says so
                    continue
                if name not in known:
                    left -= len(ids) if is_pattern(name) else 0
                    if left < 0:
                        yield Finding(("expect",), _TOO_MANY)
                        return
                    known[name] = _is_known(name, ids)
                if not known[name]:
                    yield _unknown_body(name, place, ids)


def _followed(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    """The body that the camera goes with; `MOVING` means whatever moves."""
    name = plain.mapping(data.get("view")).get("follow")
    if ids.counted and isinstance(name, str) and name != MOVING and not name.startswith(ids.unread) and name not in ids:
        yield _unknown_body(name, ("view", "follow"), ids)


def _is_known(name: str, ids: BodyNames) -> bool:
    """Whether an id or pattern means a body, or may mean one of a generator that cannot be read."""
    if name.startswith(ids.unread):
        return True
    if is_pattern(name):
        return bool(ids.unread) or matches_any(name, ids)
    return name in ids


def _unknown_body(name: str, place: Path, ids: BodyNames) -> Finding:
    if is_pattern(name):
        return Finding(place, f"no body's id matches {quoted(name)}")
    return Finding(place, f"no body has the id {quoted(name)}", did_you_mean(name, ids))
