"""Names in rules and controls: bodies, joints, regions, counters and controls they are about, and the @ names."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body_check import BodyCheck
from sandbox.scene.body_refs import is_pattern, matches_any
from sandbox.scene.finding import TAKEN, Finding, Path, quoted
from sandbox.scene.flat_rules import FIRST, MOTION, POINTER, SECOND, SELF
from sandbox.scene.joint_references import joint_ids
from sandbox.scene.limits import MAX_EXPECTATIONS, MAX_NAME, MAX_RULES
from sandbox.scene.names import BodyNames
from sandbox.scene.near_names import did_you_mean, near_or_all, near_pattern
from sandbox.scene.play.triggers import TRIGGERS

PAIRS = ("hit", "begin", "end", "enter", "leave")
"""Triggers with two bodies."""
_BODIES = ("delete", "of", "put", "path")
_PLACES = ("at", "along", "target")
_JOINTS = ("joint", "break_joint")
_DECLARING = {
    "joint": ("joints", "generate", TAKEN), "region": ("regions",), "counter": ("counters",), "control": ("controls",)
}  # fmt: skip
"""The fields that bring what can be named."""


def play_references(data: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    """A finding for every name that refers to nothing, or to nothing that is there then."""
    if not any(data.get(name) for name in ("rules", "controls", "expect")):
        return
    look_up = _LookUp(data, ids)
    for path, wanted in islice(plain.children(data.get("expect"), ("expect",)), MAX_EXPECTATIONS):
        yield from look_up.one("counter", wanted.get("counter"), (*path, "counter"))
    for path, rule in islice(plain.children(data.get("rules"), ("rules",)), MAX_RULES):
        when = plain.mapping(rule.get("when"))
        yield from _trigger(when, (*path, "when"), look_up)
        test = plain.mapping(rule.get("if"))
        yield from look_up.one("counter", test.get("counter"), (*path, "if", "counter"))
        yield from look_up.bodies(test.get("touches"), (*path, "if", "touches"))
        there = _there(when)
        for place, action in islice(plain.children(rule.get("do"), (*path, "do")), MAX_RULES):
            yield from _action(action, place, look_up, there)
    for path, control in plain.children(data.get("controls"), ("controls",)):
        for occasion in plain.OCCASIONS:
            for place, action in islice(plain.children(control.get(occasion), (*path, occasion)), MAX_RULES):
                yield from _action(action, place, look_up, {POINTER})


def _there(when: dict[str, Any]) -> set[str]:
    """The @ names that a trigger brings; of one that cannot be read, all that any brings."""
    if any(kind in when for kind in PAIRS):
        return {FIRST, SECOND}
    if "press" in when:
        return {POINTER}
    return set() if any(kind in when for kind in TRIGGERS) else {FIRST, SECOND, POINTER}


class _LookUp:
    """All that names can refer to."""

    def __init__(self, data: dict[str, Any], ids: BodyNames) -> None:
        self._bodies = BodyCheck(ids, ("rules",)) if ids.counted else None
        self._joints, self._ids = joint_ids(data), ids
        regions = (region.get("id") for _, region in plain.children(data.get("regions"), ("regions",)))
        controls = (control.get("id") for _, control in plain.children(data.get("controls"), ("controls",)))
        self._named: dict[str, Collection[str]] = {
            "joint": self._joints,
            "region": [name for name in regions if isinstance(name, str)],
            "counter": plain.mapping(data.get("counters")),
            "control": [name for name in controls if isinstance(name, str)],
        }

    def bodies(self, value: object, path: Path, there: Collection[str] = ()) -> Iterator[Finding]:
        """Faults of ids of bodies, patterns, and the @ names that are `there`."""
        for place, name in plain.texts(value, path):
            if name.startswith("@"):
                yield from _token(name, place, there)
            elif self._bodies is not None:
                for fault in self._bodies.faults(name, place):
                    is_token = f"@{name}" in there
                    yield replace(fault, hint=f'did you mean "@{name}"?') if is_token else fault

    def several(self, what: str, value: object, path: Path) -> Iterator[Finding]:
        """Faults of ids of other things, or patterns for them."""
        for place, name in plain.texts(value, path):
            if not is_pattern(name):
                yield from self.one(what, name, place)
            elif len(name) <= MAX_NAME and not matches_any(name, self._named[what]) and not self._may_match(what):
                near = near_pattern(name, self._named[what])
                yield Finding(place, f"no {what}'s id matches {quoted(name)}", near, lacks=_DECLARING[what])

    def _may_match(self, what: str) -> bool:
        return what == "joint" and bool(self._ids.unread)

    def one(self, what: str, name: object, path: Path) -> Iterator[Finding]:
        """The fault of an id."""
        if isinstance(name, str) and name not in self._named[what]:
            if what == "joint" and self._ids.is_unread(name):
                return
            told = f"no {what} is named {quoted(name)}" if what == "counter" else f"no {what} has the id {quoted(name)}"
            known = self._named[what]
            hint = near_or_all(name, known)
            if what == "counter" and not known:
                hint = f'declare it: "counters": {{{quoted(name)}: 0}}'
            yield Finding(path, told, hint, lacks=_DECLARING[what])


def _trigger(when: dict[str, Any], path: Path, look_up: _LookUp) -> Iterator[Finding]:
    for kind in PAIRS:
        yield from look_up.bodies(when.get(kind), (*path, kind))
    yield from look_up.several("joint", when.get("joint_break"), (*path, "joint_break"))
    yield from look_up.one("counter", when.get("count"), (*path, "count"))
    yield from look_up.one("control", when.get("press"), (*path, "press"))


def _action(action: dict[str, Any], path: Path, look_up: _LookUp, there: set[str]) -> Iterator[Finding]:
    bodies = there - {POINTER}
    for field in _BODIES:
        yield from look_up.bodies(action.get(field), (*path, field), bodies)
    for field in _PLACES:
        if isinstance(action.get(field), str):
            known = there | ({SELF, MOTION} if field == "along" else set())
            if field == "at" and "spawn" in action:
                known = bodies
            yield from _place(action[field], (*path, field), look_up, known)
    for field in _JOINTS:
        yield from look_up.several("joint", action.get(field), (*path, field))
    yield from look_up.several("region", action.get("region"), (*path, "region"))
    yield from look_up.one("counter", action.get("counter"), (*path, "counter"))


def _place(name: str, path: Path, look_up: _LookUp, there: set[str]) -> Iterator[Finding]:
    if is_pattern(name):
        yield Finding(path, f"a place is one body, and {quoted(name)} may be several")
    else:
        yield from look_up.bodies(name, path, there)


def _token(name: str, place: Path, there: Collection[str]) -> Iterator[Finding]:
    if name in there:
        return
    if name in (FIRST, SECOND):
        yield Finding(
            place, f"{name} is a body of the event, and here is none", f"triggers with two: {', '.join(PAIRS)}"
        )
    elif name == POINTER:
        yield Finding(place, "@pointer is where a control's pointer is", "only controls and rules with press have one")
    elif name in (SELF, MOTION):
        way = "as in the body itself" if name == SELF else "the way the body moves"
        yield Finding(place, f'{name} only says in "along" which way x points: {way}')
    else:
        listed = (FIRST, SECOND, POINTER, SELF, MOTION)
        yield Finding(place, f"there is no {quoted(name)}; there are {', '.join(listed)}", did_you_mean(name, listed))
