"""Names that nothing uses: materials, prefabs, categories, counters, numbers; and controls that do nothing."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.authoring.evaluate import names_asked_for
from sandbox.scene.expect import CounterIs
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.flat import FlatBody
from sandbox.scene.flat_rules import FlatCount
from sandbox.scene.generators import GENERATORS

_NAMING = {"material": "materials", "prefab": "prefabs", **dict.fromkeys(GENERATORS, "prefabs")}
"""The fields that name a material or a prefab."""


def check(subject: Subject) -> Iterator[Finding]:
    """Every name that the scene itself gives, and that neither it nor what it includes mentions."""
    words = _words(subject)
    for what in ("materials", "prefabs"):
        for name in subject.data.get(what, {}):
            if (what, name) not in words:
                yield _unused((what, name), f"the {what[:-1]} {quoted(name)}")
    members = _members([*subject.flat.bodies, *subject.spawned])
    for number, name in enumerate(subject.scene.categories):
        if not members & 2 << number:
            yield _unused(("categories", number), f"the category {quoted(name)}", "no shape is in it")
    counted = _counted(subject)
    for name in subject.scene.counters:
        if name not in counted:
            yield _unused(("counters", name), f"the counter {quoted(name)}", "nothing changes it or asks for it")
    awaited = {rule.when.name for rule in subject.flat.rules if rule.when.kind == "press"}
    for number, control in enumerate(subject.flat.controls):
        if not (control.press or control.hold or control.release) and control.id not in awaited:
            text = f"the control {quoted(control.id)} does nothing, and no rule waits for it"
            yield Finding(("controls", number), text, 'give it a "press" or a "hold", or take it out')
        elif not (control.keys or control.minus or control.pad or control.mouse):
            text = f"the control {quoted(control.id)} has no keys, no button and no stick: nobody can press it"
            yield Finding(("controls", number), text, 'give it some, as in "keys": ["space"]')
    yield from _numbers(subject)


def _numbers(subject: Subject) -> Iterator[Finding]:
    """Numbers by name, and parameters of prefabs, that no expression asks for."""
    scene, words = subject.scene, subject.words
    parts = [json.loads(file.read_text(encoding="utf-8")) for file in scene.included_files]
    asked = names_asked_for([words, scene.set_values, parts])
    for name in words.get("vars", {}):
        if name not in asked:
            yield _unused(("vars", name), f"the number {quoted(name)}", "no expression asks for it")
    for name, prefab in words.get("prefabs", {}).items():
        asked = names_asked_for(prefab)
        for param in prefab.get("params", {}):
            if param not in asked:
                what = f"the parameter {quoted(param)} of {quoted(name)}"
                yield _unused(("prefabs", name, "params", param), what, "no expression in the prefab asks for it")


def _words(subject: Subject) -> set[tuple[str, str]]:
    """The materials and prefabs that are named anywhere, as ("materials", name)."""
    found: set[tuple[str, str]] = set()
    nodes: list[Any] = [subject.data, subject.scene.to_data()]
    while nodes:
        node = nodes.pop()
        if isinstance(node, dict):
            pairs = ((_NAMING.get(key), value) for key, value in node.items())
            found |= {(what, value) for what, value in pairs if what and isinstance(value, str)}
            nodes += node.values()
        elif isinstance(node, (list, tuple)):
            nodes += node
    return found


def _counted(subject: Subject) -> set[str]:
    """The counters that are changed, waited for, or looked at."""
    found = {action.counter for action in subject.actions if isinstance(action, FlatCount)}
    for rule in subject.flat.rules:
        found.add(rule.condition.counter if rule.condition else "")
        found.add(rule.when.name if rule.when.kind == "count" else "")
    return found | {each.counter for each in subject.scene.expect if isinstance(each, CounterIs)}


def _unused(path: Path, what: str, why: str = "nothing names it") -> Finding:
    return Finding(path, f"{what} is never used", f"{why}: take it out", on_key=path[0] != "categories")


def _members(bodies: Iterable[FlatBody]) -> int:
    """The bits of the categories that have shapes, those included that may come."""
    bits = 0
    for body in bodies:
        for shape in body.shapes:
            bits |= shape.category
    return bits


RULE = Rule("unused", "materials, prefabs, categories, counters, numbers and controls that nothing uses", check)
