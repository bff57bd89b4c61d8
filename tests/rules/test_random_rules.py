"""Whatever rules and controls a scene has: it loads, comes back as it was, and runs to the same bits."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.commands.control import Control
from sandbox.engine.world import World
from sandbox.scene import Scene, loads_scene, schema
from tests.examples import examples

SCHEMA = jsonschema.Draft202012Validator(schema())
BASE: dict[str, Any] = {
    "prefabs": {"dot": {"shapes": [{"circle": 0.2, "restitution": 0.9}]},
                "lift": {"type": "kinematic", "shapes": [{"box": [1, 0.2]}],
                         "path": {"to": [[1, 2], [0, 0]], "times": [0.3, 0.9], "turn": [40, -9], "mode": "ping-pong"}}},
    "bodies": [
        {"id": "floor", "type": "static", "shapes": [{"box": [12, 1]}]},
        {"id": "gate", "type": "static", "position": [0, 1.5], "shapes": [{"box": [2, 2], "sensor": True}]},
        {"id": "lift", "prefab": "lift", "position": [-3, 1]},
        {"id": "dot-a", "prefab": "dot", "position": [0, 3], "thrusters": [{"force": [0, 1]}]},
        {"id": "dot-b", "prefab": "dot", "position": [0.1, 5]},
        {"id": "wheel", "position": [4, 2], "shapes": [{"circle": 0.8}]},
    ],
    "joints": [
        {"id": "axle", "type": "revolute", "bodies": ["wheel"], "anchor": [4, 2], "motor_speed": 90},
        {"id": "rod", "type": "distance", "bodies": ["dot-a", "dot-b"], "anchors": [[0, 3], [0.1, 5]], "max": 3},
    ],
    "regions": [{"id": "air", "wind": [1, 0]}, {"id": "sea", "water": 1, "surface": 1}],
    "counters": {"n": 0, "m": 5},
}  # fmt: skip

numbers = st.one_of(st.integers(-20, 20), st.floats(-20, 20), st.sampled_from([0.0, 1e6, -1e6]))
pairs = st.tuples(numbers, numbers).map(list)
seconds = st.floats(0, 1)
one = st.sampled_from(["floor", "gate", "lift", "dot-a", "dot-b", "wheel", "new-1", "new-2"])
ids = st.one_of(one, st.sampled_from(["*", "dot-*", "new-*"]), st.lists(one, min_size=1, max_size=3))
joints = st.sampled_from(["axle", "rod", "*"])
counters = st.sampled_from(["n", "m"])


def record(needed: dict[str, Any], more: dict[str, Any] | None = None) -> st.SearchStrategy[dict[str, Any]]:
    return st.fixed_dictionaries(needed, optional=more or {})


def actions(tokens: list[str]) -> st.SearchStrategy[dict[str, Any]]:
    """Actions where only some @ names stand for something."""
    bodies = [token for token in tokens if token != "@pointer"]
    who = st.one_of(ids, st.sampled_from(bodies)) if bodies else ids
    place = st.one_of(pairs, one, st.sampled_from(tokens)) if tokens else st.one_of(pairs, one)
    along = {"along": st.one_of(one, st.sampled_from(["@self", "@motion", *tokens])), "reach": seconds}
    named = {"id": st.just("new"), "prefab": st.sampled_from(["dot", "lift"])}
    body = record(named, {"position": pairs, "angle": numbers})
    return st.one_of(
        record({"delete": who}),
        record({"spawn": body}, {"at": one, "limit": st.integers(1, 9), "every": seconds}),
        record({"impulse": pairs, "of": who}, {**along, "turning": numbers}),
        record({"force": pairs, "of": who}, {**along, "torque": numbers}),
        record({"velocity": st.tuples(st.none() | numbers, st.none() | numbers).map(list), "of": who},
               {**along, "angular_velocity": numbers}),
        record({"put": who, "at": place}, {"angle": numbers}),
        record({"explode": numbers, "at": place, "radius": st.floats(0.1, 5)}),
        record({"gravity": pairs}),
        record({"surface": record({}, {"friction": st.floats(0, 2), "density": st.floats(0.1, 5),
                                       "restitution": st.floats(0, 1), "surface_speed": numbers}), "of": who}),
        record({"thruster": st.booleans(), "of": who}, {"thrust": pairs, "number": st.integers(0, 2)}),
        record({"joint": joints}, {"enabled": st.booleans(), "motor_speed": numbers, "upper": numbers, "hertz": seconds,
                                   "max": st.floats(0, 9), "length": st.floats(0, 9), "rest": numbers}),
        record({"break_joint": joints}),
        record({"region": st.sampled_from(["air", "sea", "*"])},
               {"enabled": st.booleans(), "set": record({}, {"wind": pairs, "surface": numbers, "drag": seconds})}),
        record({"path": who}, {"enabled": st.booleans(), "time": seconds}),
        record({"counter": counters, "add": numbers}),
        record({"counter": counters, "set": numbers}),
        record({"win": st.text(max_size=5)}),
        record({"lose": st.text(max_size=5)}),
    )  # fmt: skip


def rule(trigger: st.SearchStrategy[dict[str, Any]], tokens: list[str]) -> st.SearchStrategy[dict[str, Any]]:
    least = record({"counter": counters, "least": numbers})
    touches = record({"touches": st.tuples(one, one).map(list)})
    more = {"if": st.one_of(least, touches), "limit": st.integers(1, 5), "cooldown": seconds}
    return record({"when": trigger, "do": st.lists(actions(tokens), min_size=1, max_size=4)}, more)


pair = st.tuples(st.one_of(one, st.just("*")), st.one_of(one, st.just("*"))).map(list)
events = st.one_of(
    record({"hit": pair}, {"speed": st.floats(0, 3)}),
    *(record({kind: pair}) for kind in ("begin", "end", "enter", "leave")),
)
others = st.one_of(
    record({"joint_break": joints}), record({"time": seconds}), record({"every": st.floats(0.01, 1)}),
    record({"count": counters, "reaches": numbers}),
)  # fmt: skip
press = st.just({"press": "go"})
rules = st.one_of(rule(events, ["@first", "@second"]), rule(others, []), rule(press, ["@pointer"]))
occasion = st.lists(actions(["@pointer"]), max_size=3)
control = record({"id": st.just("go")}, {"keys": st.just(["space"]), "press": occasion, "hold": occasion,
                                         "release": occasion})  # fmt: skip
NEW = {"when": {"time": 0.2}, "do": [{"spawn": {"id": "new", "prefab": "dot", "position": [2, 6]}}]}
games = st.builds(
    lambda made, control: {**BASE, "rules": [NEW, *made], "controls": [control]},
    st.lists(rules, min_size=1, max_size=5), control,
)  # fmt: skip


@given(games, st.tuples(numbers, numbers), st.sampled_from([1.0, -0.5]))
@examples(100)
def test_any_game_runs(data: dict[str, Any], pointer: tuple[float, float], value: float):
    text = json.dumps(data)
    SCHEMA.validate(json.loads(text))
    scene = loads_scene(text)
    assert Scene(**scene.to_data()) == scene
    one, two = World(scene), World(scene)
    for step in range(48):
        for world in (one, two):
            if step in (5, 40):
                world.apply(Control("go", value, pointer))
            if step == 20:
                world.apply(Control("go", 0.0))
        if step % 12 == 6:
            two.restore(one.snapshot())
        one.step()
        two.step()
        assert one.digest() == two.digest()
        assert list(one.events.happenings) == list(two.events.happenings)


coming = [{"spawn": {"id": name, "prefab": prefab, "position": [0, 3]}, "limit": 6}
          for name in ("new", "more") for prefab in ("dot", "lift")]  # fmt: skip
refused = {"spawn": {"id": "far", "prefab": "dot", "position": [1e9, 0]}, "at": "wheel"}
follower = record({"spawn": record({"id": st.just("new"), "prefab": st.just("dot")}, {"position": pairs})},
                  {"at": st.sampled_from(["new-1", "more-1", "@first"]), "every": seconds})  # fmt: skip
goings = record({"delete": st.sampled_from(["new-*", "*-1", "more-2", "dot-a", "wheel", "@first", "@second"])})
between = st.sampled_from([{"counter": "n", "add": 1}, {"put": "new-*", "at": [0, 5]}, refused])
crowded = st.lists(st.one_of(st.sampled_from(coming), follower, goings, between), min_size=1, max_size=6)
crowds = st.lists(
    record({"when": st.sampled_from([{"begin": ["*", "*"]}, {"enter": ["gate", "*"]}]), "do": crowded},
           {"if": st.sampled_from([{"touches": ["dot-*", "*"]}, {"counter": "n", "most": 20}])}),
    min_size=1, max_size=4,
)  # fmt: skip


@given(crowds)
@examples(30)
@pytest.mark.slow
def test_what_comes_and_goes_at_once_comes_out_as_one_by_one(crowd: list[dict[str, Any]]):
    scene = Scene(**{**BASE, "rules": [{"when": {"every": 0.05}, "do": [*coming, refused]}, *crowd]})
    at_once, singly = World(scene), World(scene)
    wait = singly._game._actor._gathering.add
    singly._game._actor._gathering.add = lambda *command: (wait(*command), singly._game._actor.finish())
    for _ in range(24):
        at_once.step()
        singly.step()
        assert (at_once.digest(), at_once.names) == (singly.digest(), singly.names)
        assert at_once.events.happenings == singly.events.happenings
        assert sorted(map(str, at_once.events)) == sorted(map(str, singly.events))
