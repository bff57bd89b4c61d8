"""A rule that is never followed: what it waits for cannot come about."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from sandbox.lint.meeting import can_feel, can_push
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.body_refs import matching_ids
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import INFINITE, FlatBody
from sandbox.scene.flat_rules import FlatBreak, FlatCondition, FlatSetting, FlatTrigger, Names

_TOUCHES = ("hit", "begin", "end")
_SENSES = ("enter", "leave")
Why = tuple[str, str]
"""What is wrong, and the mend."""


def check(subject: Subject) -> Iterator[Finding]:
    """Rules by what they wait for, and by their condition."""
    for number, rule in enumerate(subject.flat.rules):
        why = _why(subject, rule.when)
        if why is not None:
            yield Finding(("rules", number, "when"), f"this never comes about: {why[0]}", why[1])
        elif rule.condition is not None and not _can_hold(subject, rule.condition):
            name = quoted(rule.condition.counter)
            text = f"this never holds: nothing changes the counter {name}"
            yield Finding(("rules", number, "if"), text, "change it, or ask for what it starts with")


def _why(subject: Subject, when: FlatTrigger) -> Why | None:
    if when.kind in _TOUCHES:
        return _apart(subject, when)
    if when.kind in _SENSES:
        return _unfelt(subject, when)
    if when.kind == "joint_break":
        return None if _can_break(subject, when.first) else ("no such joint can break", 'give one a "break_force"')
    return _uncounted(subject, when) if when.kind == "count" else None


def _apart(subject: Subject, when: FlatTrigger) -> Why | None:
    first, second = _meant(subject, when.first), _meant(subject, when.second)
    if any(can_push(a, b) for a, b in product(first, second)):
        return None
    text = f"{_told(when.first)} and {_told(when.second)} cannot touch"
    if any(shape.sensor for body in (*first, *second) for shape in body.shapes):
        return text, 'of a sensor and a body, "enter" and "leave" tell'
    return text, "look at their masks; one of two that touch is dynamic"


def _unfelt(subject: Subject, when: FlatTrigger) -> Why | None:
    bearers, others = _meant(subject, when.first), _meant(subject, when.second)
    sensors = [(shape, bearer) for bearer in bearers for shape in bearer.shapes if shape.sensor]
    if any(can_feel(sensor, bearer, other) for (sensor, bearer), other in product(sensors, others)):
        return None
    if not sensors:
        return f"{_told(when.first)} has no sensor", 'give it a shape with "sensor": true; of solid ones "begin" tells'
    return f"the sensor of {_told(when.first)} cannot feel {_told(when.second)}", "look at its mask and category"


def _can_break(subject: Subject, names: Names) -> bool:
    if any(isinstance(action, FlatBreak) for action in subject.actions):
        return True
    set_fields = {name for a in subject.actions if isinstance(a, FlatSetting) for name, _ in a.values}
    joints = {joint.id: min(joint.break_force, joint.break_torque) for joint in subject.flat.joints}
    breakable = any(joints[name] < INFINITE for name in matching_ids(names, [*joints]))
    return breakable or any("break" in name for name in set_fields)


def _uncounted(subject: Subject, when: FlatTrigger) -> Why | None:
    changes, start = subject.changes(when.name), subject.start(when.name)
    if not changes:
        return f"nothing changes the counter {quoted(when.name)}", 'an action does, as {"counter": ..., "add": 1}'
    signs = {(change.value > 0) - (change.value < 0) for change in changes if change.adds}
    if any(not change.adds for change in changes) or signs >= {-1, 1}:
        return None
    if (-1 not in signs and when.value <= start) or (1 not in signs and when.value >= start):
        way = "up" if 1 in signs else "down"
        return f"{quoted(when.name)} starts with {start:g} and only goes {way}", "look at its start and what is added"
    return None


def _can_hold(subject: Subject, condition: FlatCondition) -> bool:
    if not condition.counter or subject.changes(condition.counter):
        return True
    return condition.low <= subject.start(condition.counter) <= condition.high


def _meant(subject: Subject, names: Names) -> list[FlatBody]:
    """The bodies that ids and patterns mean, those that may come included."""
    coming = [body for body in subject.spawned if _means(names, body.id)]
    return [*(subject.bodies[name] for name in subject.named(names)), *coming]


def _means(names: Names, entry: str) -> bool:
    """Whether ids or patterns may mean a body that comes of an entry: ENTRY-1, ENTRY-2, ..."""
    return any(name.rpartition("-")[0] == entry for name in names) or bool(matching_ids(names, [f"{entry}-1"]))


def _told(names: Names) -> str:
    return " or ".join(map(quoted, names))


RULE = Rule("idle-rule", "rules that wait for what cannot come about", check)
