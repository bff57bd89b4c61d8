"""The rules between fields of one object, and the list of all rules between fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body import Body
from sandbox.scene.declarations import is_misspelt, without_follow_ups
from sandbox.scene.field_rules import field_rules
from sandbox.scene.finding import TAKEN, Finding, quoted
from sandbox.scene.generators import GENERATORS
from sandbox.scene.known import NOTHING, Known
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.names import body_ids
from sandbox.scene.plain import SEVERAL, is_several
from sandbox.scene.play.play_rules import play_rules
from sandbox.scene.prefab import Prefab
from sandbox.scene.references import unknown_names
from sandbox.scene.union import UNIONS

_TIMES = ("at", "always", "within")
_BODY_FIELDS = {**Body.model_fields, **Prefab.model_fields}
_WANTED = {name: None for kind in UNIONS["expectation"].values() for name in kind.model_fields}
_GIVE_SHAPES = 'give it one, as in "shapes": [{"circle": 0.5}]'


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
    found = [finding for rule in rules for finding in islice(rule, MAX_FINDINGS)]
    return without_follow_ups(found, data, (*known.lacking, *([TAKEN] if ids.findings else [])))


def _without_shapes(data: dict[str, Any]) -> Iterator[Finding]:
    prefabs, told = plain.mapping(data.get("prefabs")), set[str]()
    for _, generator in plain.children(data.get("generate"), ()):
        for name in (generator[kind] for kind in GENERATORS if kind in generator):
            if isinstance(name, str) and name not in told and not _has_shapes(prefabs, name):
                told.add(name)
                yield Finding(("prefabs", name), f"the prefab {quoted(name)} has no shapes", _GIVE_SHAPES)
    for path, body in plain.entries(data):
        pattern = body.get("prefab")
        if "shapes" in body or _misspelt(body) or (pattern is not None and _has_shapes(prefabs, pattern)):
            continue
        if isinstance(pattern, str):
            if pattern in told:
                continue
            told.add(pattern)
        name = body.get("id")
        whose = f"the body {quoted(name)}" if isinstance(name, str) else "the body"
        yield Finding(path, f"{whose} has no shapes", _GIVE_SHAPES)


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
        stray = [key for key in prefab if key in Prefab.model_fields and key not in (*SEVERAL, "params")]
        if is_several(prefab) and stray:
            text = f"a prefab of several bodies has no {quoted(str(stray[0]))} of its own"
            yield Finding((*path, stray[0]), text, "give it to its bodies", on_key=True)


def _misspelt(body: dict[str, Any]) -> bool:
    """Whether a body or prefab has a field that looks like "shapes" or "prefab"; that mistake is told then."""
    return is_misspelt("shapes", body, _BODY_FIELDS) or is_misspelt("prefab", body, _BODY_FIELDS)


def _has_shapes(prefabs: dict[str, Any], name: object) -> bool:
    """Whether a prefab gives shapes; unknown names are told elsewhere and count as having some."""
    prefab = prefabs.get(name) if isinstance(name, str) else None
    return not isinstance(prefab, dict) or is_several(prefab) or "shapes" in prefab or _misspelt(prefab)


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
        if not given and not any(is_misspelt(key, expectation, _WANTED) for key in _TIMES):
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
