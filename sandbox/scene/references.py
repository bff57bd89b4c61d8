"""Names that refer to something: materials, prefabs, categories, and the bodies of expectations."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body_check import BodyCheck, unknown_body
from sandbox.scene.body_refs import BODY_FIELDS
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.joint_references import joint_references
from sandbox.scene.known import Known
from sandbox.scene.limits import MAX_EXPECTATIONS
from sandbox.scene.names import BodyNames
from sandbox.scene.near_names import did_you_mean, near_or_all
from sandbox.scene.play.references import play_references

MOVING = "moving"
"""What a camera follows that goes with whatever moves."""
_ONE_OF = {"materials": "material", "prefabs": "prefab", "categories": "category"}


def unknown_names(data: dict[str, Any], ids: BodyNames, known: Known) -> Iterator[Finding]:
    """A finding for every name that refers to nothing."""
    materials = plain.mapping(data.get("materials"))
    for path, node in [*plain.patterns(data), *plain.shapes(data)]:
        yield from _unknown(node, path, "material", materials, "materials")
    yield from _prefabs(data)
    yield from _categories(data)
    yield from _bodies(data, ids)
    yield from followed(data, ids)
    yield from joint_references(data, ids, known.kinds)
    yield from play_references(data, ids)


def _unknown(
    node: dict[str, Any], path: Path, field: str, known: Collection[str], lacks: str, mend: str = ""
) -> Iterator[Finding]:
    what = _ONE_OF[lacks]
    for place, name in plain.texts(node.get(field), (*path, field)):
        if name not in known:
            hint = did_you_mean(name, known) or mend if mend else near_or_all(name, known)
            yield Finding(place, f"no {what} is named {quoted(name)}", hint, lacks=(lacks,))


def _prefabs(data: dict[str, Any]) -> Iterator[Finding]:
    known = plain.mapping(data.get("prefabs"))
    for path, body in plain.entries(data):
        yield from _unknown(body, path, "prefab", known, "prefabs")
    for path, generator in plain.children(data.get("generate"), ("generate",)):
        for kind in GENERATORS:
            if isinstance(generator.get(kind), str):
                yield from _unknown(generator, path, kind, known, "prefabs")


def _categories(data: dict[str, Any]) -> Iterator[Finding]:
    known = ["default", *(name for _, name in plain.texts(data.get("categories"), ()))]
    for path, shape in plain.shapes(data):
        for field in ("category", "mask"):
            yield from _unknown(shape, path, field, known, "categories", 'list it in "categories"')


def _bodies(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    if not ids.counted:
        return
    check = BodyCheck(ids, ("expect",))
    for path, expectation in islice(plain.children(data.get("expect"), ("expect",)), MAX_EXPECTATIONS):
        for field in BODY_FIELDS:
            for place, name in plain.texts(expectation.get(field), (*path, field)):
                yield from check.faults(name, place)
                if check.given_up:
                    return


def followed(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    """The body that the camera goes with; `MOVING` means whatever moves."""
    name = plain.mapping(data.get("view")).get("follow")
    if not ids.counted or not isinstance(name, str) or name == MOVING or ids.is_unread(name):
        return
    if name not in ids and not ids.is_spawned(name):
        yield unknown_body(name, ("view", "follow"), ids)
