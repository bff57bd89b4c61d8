"""Materials, prefabs, categories and counters that nothing uses, and controls that do nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.expect import CounterIs
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.flat_rules import FlatCount
from sandbox.scene.generators import kind_of
from sandbox.scene.plain import entries, patterns, shapes


def check(subject: Subject) -> Iterator[Finding]:
    """Every name that is given and that nobody mentions."""
    data = subject.data
    for what, used in (("materials", _materials(data)), ("prefabs", _prefabs(subject))):
        for name in data.get(what, {}):
            if name not in used:
                yield _unused((what, name), f"the {what[:-1]} {quoted(name)}")
    members = _members(data)
    for number, name in enumerate(data.get("categories", [])):
        if members is not None and name not in members:
            yield _unused(("categories", number), f"the category {quoted(name)}", "no shape is in it")

    counted = _counted(subject)
    for name in data.get("counters", {}):
        if name not in counted:
            yield _unused(("counters", name), f"the counter {quoted(name)}", "nothing changes it or asks for it")
    awaited = {rule.when.name for rule in subject.flat.rules if rule.when.kind == "press"}
    for number, control in enumerate(subject.flat.controls):
        if not (control.press or control.hold or control.release) and control.id not in awaited:
            text = f"the control {quoted(control.id)} does nothing, and no rule waits for it"
            yield Finding(("controls", number), text, 'give it a "press" or a "hold", or take it out')


def _counted(subject: Subject) -> set[str]:
    """The counters that are changed, waited for, or looked at."""
    found = {action.counter for action in subject.actions if isinstance(action, FlatCount)}
    for rule in subject.flat.rules:
        found.add(rule.condition.counter if rule.condition else "")
        found.add(rule.when.name if rule.when.kind == "count" else "")
    return found | {each.counter for each in subject.scene.expect if isinstance(each, CounterIs)}


def _unused(path: Path, what: str, why: str = "nothing names it") -> Finding:
    return Finding(path, f"{what} is never used", f"{why}: take it out", on_key=path[0] != "categories")


def _materials(data: dict[str, Any]) -> set[Any]:
    return {node.get("material") for nodes in (patterns(data), shapes(data)) for _, node in nodes}


def _prefabs(subject: Subject) -> set[Any]:
    repeated = {getattr(generator, kind_of(generator)) for generator in subject.scene.generate}
    return repeated | {entry.get("prefab") for _, entry in entries(subject.data)}


def _members(data: dict[str, Any]) -> set[str] | None:
    """The categories that have shapes; None where bits are given instead of names."""
    found: set[str] = set()
    for _, shape in shapes(data):
        given = shape.get("category", ())
        if isinstance(given, int):
            return None
        found.update([given] if isinstance(given, str) else given)
    return found


RULE = Rule("unused", "materials, prefabs, categories, counters and controls that nothing uses", check)
