"""The rules between fields of one object, and the list of all rules between fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body import Body
from sandbox.scene.field_rules import field_rules
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.known import NOTHING, Known
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.names import body_ids
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.plain import SEVERAL, is_several
from sandbox.scene.play.play_rules import play_rules
from sandbox.scene.references import unknown_names

_TIMES = ("at", "always", "within")


def cross_checks(data: object, known: Known = NOTHING) -> list[Finding]:
    """All mistakes between fields of a scene's plain data; single values are the models' business.

    The data may refer to what is `known` besides.
    """
    if not isinstance(data, dict):
        return []
    ids = body_ids(data, known)
    rules: list[Iterable[Finding]] = [
        ids.findings,
        unknown_names(data, ids, known),
        _without_shapes(data),
        _several_in_one(data),
        _overrounded(data),
        _times(data),
        field_rules(data, known),
        play_rules(data),
        _repeated_categories(data),
    ]
    return [finding for rule in rules for finding in islice(rule, MAX_FINDINGS)]


def _without_shapes(data: dict[str, Any]) -> Iterator[Finding]:
    prefabs = plain.mapping(data.get("prefabs"))
    for path, body in plain.entries(data):
        if "shapes" in body or _misspelt(body) or ("prefab" in body and _has_shapes(prefabs, body["prefab"])):
            continue
        name = body.get("id")
        whose = f"the body {quoted(name)}" if isinstance(name, str) else "the body"
        yield Finding(path, f"{whose} has no shapes", 'give it one, as in "shapes": [{"circle": 0.5}]')
    for path, generator in plain.children(data.get("generate"), ("generate",)):
        for kind in GENERATORS:
            if kind in generator and not _has_shapes(prefabs, generator[kind]):
                yield Finding((*path, kind), f"the prefab {quoted(generator[kind])} has no shapes")


def _several_in_one(data: dict[str, Any]) -> Iterator[Finding]:
    """Bodies cannot be made of prefabs of several; and what parameters are left have nothing to fill in."""
    prefabs = plain.mapping(data.get("prefabs"))
    for path, body in plain.entries(data):
        name = body.get("prefab")
        if isinstance(name, str) and is_several(prefabs.get(name)):
            hint = f'place it: {{"id": ..., "place": {quoted(name)}, "at": [0, 0]}} in "generate"'
            yield Finding((*path, "prefab"), f"the prefab {quoted(name)} has several bodies", hint)
        elif isinstance(body.get("params"), dict) and (name is None or name in prefabs):
            text = "there is no prefab here to fill in"
            yield Finding((*path, "params"), text, "a body of a running world takes its prefab as it is", on_key=True)
    for path, prefab in plain.children(prefabs, ("prefabs",)):
        stray = [key for key in prefab if key not in (*SEVERAL, "params")]
        if is_several(prefab) and stray:
            text = f"a prefab of several bodies has no {quoted(str(stray[0]))} of its own"
            yield Finding((*path, stray[0]), text, "give it to its bodies", on_key=True)


def _misspelt(body: dict[str, Any]) -> bool:
    """Whether a body has a field that looks like "shapes" or "prefab"; that mistake is told then."""
    strays = [key for key in body if key not in Body.model_fields]
    return any(did_you_mean(key, ["shapes", "prefab"]) for key in strays)


def _has_shapes(prefabs: dict[str, Any], name: object) -> bool:
    """Whether a prefab gives shapes; unknown names are told elsewhere and count as having some."""
    known = isinstance(name, str) and isinstance(prefabs.get(name), dict) and not is_several(prefabs[name])
    return not known or "shapes" in prefabs[str(name)]


def _overrounded(data: dict[str, Any]) -> Iterator[Finding]:
    for path, shape in plain.shapes(data):
        size, radius = shape.get("box"), shape.get("radius")
        if not (isinstance(size, (list, tuple)) and len(size) == 2 and all(map(plain.is_number, size))):
            continue
        if plain.is_number(radius) and radius > 0 and not min(size) / 2 - radius >= 5e-7:
            text = f"the radius must be less than half the box's smaller side ({min(size) / 2:g} m)"
            yield Finding((*path, "radius"), text, "a box rounded that far is a capsule")


def _times(data: dict[str, Any]) -> Iterator[Finding]:
    for path, expectation in plain.children(data.get("expect"), ("expect",)):
        given = [key for key in _TIMES if expectation.get(key) is not None]
        if not given:
            yield Finding(path, 'an expectation needs a time: "at": step, "always": true, or "within": [first, last]')
        elif len(given) > 1:
            listed = " and ".join(f'"{key}"' for key in given)
            yield Finding((*path, given[-1]), f"an expectation has one time, and this one has {listed}", on_key=True)


def _repeated_categories(data: dict[str, Any]) -> Iterator[Finding]:
    seen = {"default"}
    for path, name in plain.texts(data.get("categories"), ("categories",)):
        if name in seen:
            yield Finding(path, f"the category {quoted(name)} is there already")
        seen.add(name)
