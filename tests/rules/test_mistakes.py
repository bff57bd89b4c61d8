"""What an author of a game gets wrong, and what he is told: the place, and the mend."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sandbox.errors import SceneError
from sandbox.scene import loads_scene
from tests.rules.games import ball

BASE: dict[str, Any] = {
    "bodies": [ball(), {"id": "wall", "type": "static", "shapes": [{"box": [1, 1]}]}],
    "joints": [{"id": "pin", "type": "revolute", "bodies": ["ball"], "anchor": [0, 0]}],
    "regions": [{"id": "air", "wind": [0, 0]}],
    "counters": {"score": 0},
    "controls": [{"id": "jump", "keys": ["space"]}],
}
HIT = {"hit": ["ball", "wall"]}


def mistakes(**fields: Any) -> list[tuple[str, str]]:
    """Pointer and message with hint of each."""
    with pytest.raises(SceneError) as caught:
        loads_scene(json.dumps({**BASE, **fields}))
    return [(one.pointer, f"{one.message}: {one.hint}".removesuffix(": ")) for one in caught.value.problems]


def rule(*do: Any, when: Any = HIT, **fields: Any) -> dict[str, Any]:
    return {"rules": [{"when": when, "do": list(do), **fields}]}


WIN = {"win": ""}
CASES: list[tuple[dict[str, Any], str, str]] = [
    (rule({"delete": "wal"}), "/rules/0/do/0/delete", 'no body has the id "wal": did you mean "wall"?'),
    (rule({"delete": "x*"}), "/rules/0/do/0/delete", 'no body\'s id matches "x*"'),
    (rule(WIN, when={"hit": ["ball", "wal"]}), "/rules/0/when/hit/1", 'no body has the id "wal": did you mean "wall"?'),
    (rule(WIN, when={"hit": ["ball"]}), "/rules/0/when/hit", 'hit needs 2 entries, ["id", "id"], and has 1'),
    (rule(WIN, when={"hitt": ["ball", "wall"]}), "/rules/0/when/hitt", 'unknown field "hitt": did you mean "hit"?'),
    (rule(WIN, when={"hit": ["ball", "wall"], "time": 1}), "/rules/0/when/time",
     'a trigger has one kind, and this one has "hit" and "time"'),
    (rule({"delete": "@first"}, when={"time": 1}), "/rules/0/do/0/delete",
     "@first is a body of the event, and here is none: triggers with two: hit, begin, end, enter, leave"),
    (rule({"delete": "@frist"}), "/rules/0/do/0/delete",
     'there is no "@frist"; there are @first, @second, @pointer, @self, @motion: did you mean "@first"?'),
    (rule({"put": "ball", "at": "@pointer"}), "/rules/0/do/0/at",
     "@pointer is where a control's pointer is: only controls and rules with press have one"),
    (rule({"put": "ball", "at": "wal*"}), "/rules/0/do/0/at", 'a place is one body, and "wal*" may be several'),
    (rule({"impulse": [1, 0], "of": "@self"}), "/rules/0/do/0/of",
     '@self only says in "along" which way x points: as in the body itself'),
    (rule({"impulse": [1, 0]}), "/rules/0/do/0", '"of" is missing'),
    (rule({"counter": "scor", "add": 1}), "/rules/0/do/0/counter", 'no counter is named "scor": did you mean "score"?'),
    (rule({"counter": "score"}), "/rules/0/do/0", 'a counter action needs one of "add" and "set"'),
    (rule({"joint": "pim"}), "/rules/0/do/0/joint", 'no joint has the id "pim": did you mean "pin"?'),
    (rule({"region": "x*"}), "/rules/0/do/0/region", 'no region\'s id matches "x*"'),
    (rule(WIN, when={"press": "jmp"}), "/rules/0/when/press", 'no control has the id "jmp": did you mean "jump"?'),
    (rule(WIN, when={"count": "score"}), "/rules/0/when", '"reaches" is missing'),
    (rule(WIN, **{"if": {"counter": "score"}}), "/rules/0/if",
     'a counter needs "equals", or "least" and "most" or one of them'),
    (rule(WIN, **{"if": {"counter": "score", "equals": 1, "most": 2}}), "/rules/0/if/most",
     '"equals" stands alone, and this one has "most" too'),
    (rule(WIN, **{"if": {"counter": "score", "least": 3, "most": 2}}), "/rules/0/if/least",
     '"least" must not be greater than "most"'),
    (rule(WIN, **{"if": {}}), "/rules/0/if", 'a condition needs a "counter", or "touches"'),
    (rule(WIN, **{"if": {"touches": ["ball", "wal"]}}), "/rules/0/if/touches/1",
     'no body has the id "wal": did you mean "wall"?'),
    (rule(), "/rules/0/do", "do needs at least 1 entry and has 0"),
    (rule({"spawn": {"id": "x"}}), "/rules/0/do/0/spawn", 'the body "x" has no shapes: give it one, as in '
     '"shapes": [{"circle": 0.5}]'),
    (rule({"spawn": {"id": "x", "prefab": "y"}}), "/rules/0/do/0/spawn/prefab", 'no prefab is named "y"'),
    (rule({"spawn": {"id": "x", "shapes": [{"circle": 1, "material": "y"}]}}), "/rules/0/do/0/spawn/shapes/0/material",
     'no material is named "y"'),
    (rule({"spawn": {"id": "x", "shapes": [{"circle": 1, "density": 0}]}}), "/rules/0/do/0/spawn",
     "a dynamic body without mass: give its shapes a density and an area, or give it a mass"),
    ({"controls": [{"id": "a", "keys": ["spce"]}]}, "/controls/0/keys/0",
     "keys[0] is no key; keys are letters, digits, and names such as left, space, enter, left shift: "
     'did you mean "space"?'),
    ({"controls": [{"id": "a", "mouse": ["lft"]}]}, "/controls/0/mouse/0",
     'mouse[0] must be one of "left", "middle", "right", "move": did you mean "left"?'),
    ({"controls": [{"id": "a"}, {"id": "a"}]}, "/controls/1/id", 'the id "a" is taken by another control'),
    ({"counters": {"a b": 0}}, "/counters/a b", 'the name "a b" must be 1 to 100 letters, digits or any of _ - . :'),
    ({"expect": [{"at": 1, "counter": "scor", "equals": 1}]}, "/expect/0/counter",
     'no counter is named "scor": did you mean "score"?'),
    ({"expect": [{"at": 1, "counter": "score"}]}, "/expect/0",
     'a counter needs "equals", or "least" and "most" or one of them'),
    ({"expect": [{"at": 1, "outcome": "win"}]}, "/expect/0/outcome",
     'outcome must be one of "won", "lost", "open": did you mean "won"?'),
]  # fmt: skip


@pytest.mark.parametrize(("fields", "pointer", "message"), CASES, ids=[message for _, _, message in CASES])
def test_one_mistake(fields: dict[str, Any], pointer: str, message: str):
    assert mistakes(**fields) == [(pointer, message)]


def path(**fields: Any) -> dict[str, Any]:
    lift = {"id": "lift", "type": "kinematic", "shapes": [{"circle": 1}]}
    return {"bodies": [ball(), {**lift, "path": {"to": [[0, 1], [0, 2]], **fields}}, BASE["bodies"][1]]}


PATHS: list[tuple[dict[str, Any], str, str]] = [
    (path(), "/bodies/1/path", 'a path needs "times" or a "speed", one of them'),
    (path(times=[1, 2], speed=1), "/bodies/1/path", 'a path needs "times" or a "speed", one of them'),
    (path(times=[1]), "/bodies/1/path/times", "needs a time for each of the 2 places, and has 1"),
    (path(times=[1, 2], mode="loop"), "/bodies/1/path/times",
     "needs a time for each of the 2 places, and one for when it is back, and has 2"),
    (path(times=[2, 2]), "/bodies/1/path/times/1", "each time must be later than the one before (2 s)"),
    (path(times=[1, 2], pause=1), "/bodies/1/path/pause", "a pause goes with a speed; with times, name a place twice"),
    (path(speed=1, turn=[90]), "/bodies/1/path/turn", "needs an angle for each of the 2 places, and has 1"),
    (path(speed=1, mode="pingpong"), "/bodies/1/path/mode",
     'mode must be one of "once", "loop", "ping-pong": did you mean "ping-pong"?'),
    (path(speed=1, to=[[0, 0]]), "/bodies/1",
     "a path takes at least 0.001 s: to turn on the spot, or to wait, give it times"),
    (path(speed=1e6, to=[[1e-300, 0]], mode="loop"), "/bodies/1",
     "a path takes at least 0.001 s: to turn on the spot, or to wait, give it times"),
]  # fmt: skip


@pytest.mark.parametrize(("fields", "pointer", "message"), PATHS, ids=[message for _, _, message in PATHS])
def test_one_mistake_in_a_path(fields: dict[str, Any], pointer: str, message: str):
    assert mistakes(**fields) == [(pointer, message)]


def test_only_a_kinematic_body_has_a_path():
    fields = path(speed=1)
    fields["bodies"][1].pop("type")
    assert mistakes(**fields) == [("/bodies/1", 'only a kinematic body follows a path: give it "type": "kinematic"')]


def test_the_ids_that_rules_give_are_known_to_rules_and_expectations():
    fields = rule({"spawn": {"id": "dot", "shapes": [{"circle": 1}]}}, when={"time": 1})
    fields["rules"].append({"when": {"hit": ["dot-*", "dot-7"]}, "do": [WIN]})
    loads_scene(json.dumps({**BASE, **fields, "expect": [{"at": 100, "below": 9, "of": ["dot-1", "dot-*"]}]}))
    fields["rules"].append({"when": {"hit": ["dot", "dot-x"]}, "do": [WIN]})
    assert mistakes(**fields) == [
        ("/rules/2/when/hit/0", 'no body has the id "dot": did you mean "dot-1"?'),
        ("/rules/2/when/hit/1", 'no body has the id "dot-x": did you mean "dot-1"?'),
    ]
