"""The rules between the fields of controls, rules, paths, and of expectations about counters; and how many may be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice, pairwise
from typing import Any

from sandbox.scene import plain
from sandbox.scene.base import Model
from sandbox.scene.declarations import is_misspelt
from sandbox.scene.expect import CounterIs
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.limits import MAX_ALIVE, MAX_ALL_ACTIONS, MAX_COUNTERS, MAX_EXPECTATIONS, MAX_FINDINGS
from sandbox.scene.play.actions import Count
from sandbox.scene.play.path import BodyPath
from sandbox.scene.play.rule import Condition

_TESTS = ("equals", "least", "most")


def play_rules(data: dict[str, Any]) -> Iterator[Finding]:
    """A finding for everything of these that does not fit together."""
    yield from _limits(data)
    for what in ("rules", "controls"):
        yield from _repeated(data, what)
    for path, pattern in plain.patterns(data):
        if isinstance(pattern.get("path"), dict):
            yield from _path(pattern["path"], (*path, "path"))
    for path, action in plain.actions(data):
        if "counter" in action and ("add" in action) == ("set" in action) and not _near(("add", "set"), action, Count):
            yield Finding(path, 'a counter action needs one of "add" and "set"')
    conditions = [((*path, "if"), rule.get("if")) for path, rule in _children(data, "rules")]
    tested = [(path, test) for path, test in conditions if isinstance(test, dict)]
    expected = islice(_children(data, "expect"), MAX_EXPECTATIONS)
    for path, test in (*tested, *((path, wanted) for path, wanted in expected if "counter" in wanted)):
        yield from _range(test, path)


def _limits(data: dict[str, Any]) -> Iterator[Finding]:
    counters = plain.mapping(data.get("counters"))
    if len(counters) > MAX_COUNTERS:
        yield Finding(("counters",), f"there are {len(counters)} counters; {MAX_COUNTERS} is the limit")
    actions = list(plain.actions(data))
    if len(actions) > MAX_ALL_ACTIONS:
        yield Finding(("rules",), f"rules and controls have {len(actions)} actions; {MAX_ALL_ACTIONS:,} is the limit")
    alive: dict[str, int] = {}
    for _, action in actions:
        entry, limit = action.get("spawn"), action.get("limit", 100)
        name = entry.get("id") if isinstance(entry, dict) else None
        if isinstance(name, str) and plain.is_number(limit) and limit <= MAX_ALIVE:  # else its own model says so
            alive[name] = max(alive.get(name, 0), int(limit))
    if sum(alive.values()) > MAX_ALIVE:
        text = f"rules and controls could bring {sum(alive.values())} bodies at once; {MAX_ALIVE:,} is the limit"
        path = next(path for path, action in actions if isinstance(action.get("spawn"), dict))
        yield Finding(path, text, 'give them a lower "limit"')


def _children(data: dict[str, Any], what: str) -> Iterator[plain.Node]:
    return islice(plain.children(data.get(what), (what,)), MAX_FINDINGS)


def _repeated(data: dict[str, Any], what: str) -> Iterator[Finding]:
    seen: set[str] = set()
    for path, entry in _children(data, what):
        name = entry.get("id")
        if isinstance(name, str):
            if name in seen:
                yield Finding((*path, "id"), f"the id {quoted(name)} is taken by another {what[:-1]}")
            seen.add(name)


def _range(test: dict[str, Any], path: Path) -> Iterator[Finding]:
    given = [name for name in _TESTS if test.get(name) is not None]
    least, most = test.get("least"), test.get("most")
    if "counter" not in test:
        if given and not is_misspelt("counter", test, Condition.model_fields):
            yield Finding((*path, given[0]), f'"{given[0]}" of which counter? name one', on_key=True)
        elif not given and "touches" not in test and not _near(("counter", "touches"), test, Condition):
            yield Finding(path, 'a condition needs a "counter", or "touches"')
    elif not given and not _near(_TESTS, test, CounterIs):
        yield Finding(path, 'a counter needs "equals", or "least" and "most" or one of them')
    elif "equals" in given and len(given) > 1:
        yield Finding((*path, given[1]), f'"equals" stands alone, and this one has "{given[1]}" too', on_key=True)
    elif plain.is_number(least) and plain.is_number(most) and least > most:
        yield Finding((*path, "least"), '"least" must not be greater than "most"')


def _near(wanted: Iterable[str], given: dict[str, Any], model: type[Model]) -> bool:
    """Whether an object has a field that is not of its model, and looks like one that is wanted, or is the only one.

    That is told then, with what is known.
    """
    strays = [key for key in islice(given, MAX_FINDINGS) if key not in model.model_fields]
    return len(strays) == 1 or any(is_misspelt(name, given, model.model_fields) for name in wanted)


def _path(path: dict[str, Any], home: Path) -> Iterator[Finding]:
    times, speed, to = path.get("times"), path.get("speed"), path.get("to")
    if (times is None) == (speed is None) and not _near(("times", "speed"), path, BodyPath):
        yield Finding(home, 'a path needs "times" or a "speed", one of them')
    if not isinstance(to, (list, tuple)) or not to:
        return  # its own model says so
    turn = path.get("turn")
    if isinstance(turn, (list, tuple)) and len(turn) != len(to):
        yield Finding((*home, "turn"), f"needs an angle for each of the {len(to)} places, and has {len(turn)}")
    if isinstance(times, (list, tuple)) and all(map(plain.is_number, times)):
        yield from _path_times(path, times, home)


def _path_times(path: dict[str, Any], times: Any, home: Path) -> Iterator[Finding]:
    wanted = len(path["to"]) + (1 if path.get("mode") == "loop" else 0)
    if len(times) != wanted:
        back = ", and one for when it is back" if path.get("mode") == "loop" else ""
        text = f"needs a time for each of the {len(path['to'])} places{back}, and has {len(times)}"
        yield Finding((*home, "times"), text)
        return
    for k, (before, after) in enumerate(pairwise((0.0, *times))):
        if not after > before:
            yield Finding((*home, "times", k), f"each time must be later than the one before ({before:g} s)")
            return
    if "pause" in path:
        yield Finding((*home, "pause"), "a pause goes with a speed; with times, name a place twice", on_key=True)
