"""Rules that would run away are refused in time, or kept within bounds."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sandbox.engine.commands.control import Control
from sandbox.engine.world import World
from sandbox.errors import SceneError
from sandbox.scene import Scene, loads_scene
from tests.rules.games import add, ball, game, told, wall

DOT = {"id": "dot", "shapes": [{"circle": 0.05, "restitution": 1}]}


def refused(**fields: Any) -> list[str]:
    """The messages of a scene that is refused, with their hints."""
    text = json.dumps({"bodies": [ball()], **fields})
    with pytest.raises(SceneError) as caught:
        loads_scene(text)
    return [f"{problem.message}: {problem.hint}".removesuffix(": ") for problem in caught.value.problems]


def test_what_brings_more_wherever_it_strikes_comes_to_an_end():
    burst = [{"spawn": DOT, "at": "@first", "limit": 60} for _ in range(20)]
    rule = {"when": {"hit": ["*", "*"]}, "do": burst}
    w = game([rule], bodies=[ball(velocity=[0, 6]), wall("top", 1), wall("floor", -1)])
    w.step(200)
    assert 40 < len(w.names) <= 63


@pytest.mark.slow
def test_what_deletes_and_brings_at_once_is_bounded_in_a_step():
    swap = [{"delete": "dot-*"}, {"spawn": {**DOT, "position": [0, 1]}, "limit": 3}] * 50
    rules = [{"when": {"every": 0.001}, "do": swap} for _ in range(10)]
    w = game(rules)
    w.step(3)
    assert w.names[0] == "ball"
    assert len(w.names) == 2


def test_rules_that_count_each_other_up_end_with_the_step():
    rules = [
        {"when": {"time": 0}, "do": [{"counter": "a", "add": 1}]},
        {"when": {"count": "a", "reaches": 1}, "do": [{"counter": "b", "add": 1}, {"counter": "a", "set": 0}]},
        {"when": {"count": "b", "reaches": 1}, "do": [{"counter": "a", "add": 1}, {"counter": "b", "set": 0}]},
    ]
    w = game(rules, counters={"a": 0, "b": 0})
    w.step(10)
    assert w.counters == {"a": 1, "b": 0}


def test_a_counter_never_becomes_infinite():
    w = game([{"when": {"every": 0.001}, "do": [add(1e12)] * 100}])
    w.step(100)
    assert w.counters["n"] == 1e15


def test_too_much_in_one_step_is_left_out_and_told_once():
    everything = [{"impulse": [0.001, 0], "of": "dot-*"}] * 100
    w = game(
        [{"id": "all", "when": {"every": 0.001}, "do": everything}],
        bodies=[], prefabs={"dot": {"shapes": DOT["shapes"]}},
        generate=[{"id": "dot", "grid": "dot", "columns": 30, "rows": 30, "spacing": [0.2, 0.2]}],
    )  # fmt: skip
    w.step(2)
    (event,) = told(w, "refused")
    assert event["text"] == ("rules and controls want more than 10,000 things done in one step; the rest is left out")


def test_a_control_that_is_held_brings_no_more_than_its_limit_and_rate():
    w = game(controls=[{"id": "rain", "hold": [{"spawn": {**DOT, "velocity": [9, 0]}, "limit": 5, "every": 0.1}]}])
    w.apply(Control("rain"))
    w.step(20)
    assert len(w.names) == 1 + 4
    w.step(100)
    assert len(w.names) == 1 + 5


def test_a_body_that_is_too_fast_for_any_world_is_frozen():
    path = {"to": [[1e9, 0]], "times": [0.001], "mode": "ping-pong"}
    w = World(Scene(bodies=[{"id": "a", "type": "kinematic", "shapes": [{"circle": 1}], "path": path}, ball()]))
    w.step(50)
    assert abs(w.body("a").position[0]) <= 1e9


def test_thousands_of_rules():
    (message,) = refused(rules=[{"when": {"time": 1}, "do": [{"win": ""}]}] * 30_000)
    assert message == "rules has 30000 entries; 1000 is the limit"


def test_too_many_actions():
    rules = [{"when": {"time": 1}, "do": [{"win": ""}] * 100}] * 51
    assert refused(rules=rules) == ["rules and controls have 5100 actions; 5,000 is the limit"]


def test_too_many_bodies():
    rules = [{"when": {"time": 1}, "do": [{"spawn": {**DOT, "id": f"dot{k}"}, "limit": 200} for k in range(51)]}]
    assert refused(rules=rules) == [
        'rules and controls could bring 10200 bodies at once; 10,000 is the limit: give them a lower "limit"'
    ]


def test_too_many_of_everything_else():
    assert refused(counters={f"c{k}": 0 for k in range(101)}) == ["there are 101 counters; 100 is the limit"]
    assert refused(controls=[{"id": f"c{k}"} for k in range(101)]) == ["controls has 101 entries; 100 is the limit"]
    (message,) = refused(rules=[{"when": {"time": 1}, "do": [{"win": ""}] * 101}])
    assert message == "do has 101 entries; 100 is the limit"


@pytest.mark.slow
def test_a_hundred_thousand_wrong_names_are_told_in_time():
    rules = [
        {"when": {"hit": ["bal", "bal*l"]}, "do": [{"delete": f"x{k}-{j}"} for j in range(100)]} for k in range(1000)
    ]
    messages = refused(rules=rules)
    assert 'no body has the id "bal", here and elsewhere: did you mean "ball"?' in messages
    assert len(messages) <= 101
