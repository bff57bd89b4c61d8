"""What a player presses, holds and lets go."""

from __future__ import annotations

import pytest

from sandbox.engine.commands.control import Control
from sandbox.engine.world import World
from sandbox.errors import CommandError
from tests.rules.games import add, game, told


def counting() -> World:
    """A world whose control counts in three digits how often it is pressed, held and let go."""
    control = {"id": "go", "press": [add(100)], "hold": [add(1)], "release": [add(10)]}
    return game(controls=[control])


def test_a_control_acts_when_it_is_pressed_while_it_is_held_and_when_it_is_let_go():
    w = counting()
    w.step(3)
    assert w.counters["n"] == 0
    w.apply(Control("go"))
    w.step(4)
    assert w.counters["n"] == 104
    w.apply(Control("go", 0.5))  # still held
    w.step(2)
    assert w.counters["n"] == 106
    w.apply(Control("go", 0.0))
    w.step(5)
    assert w.counters["n"] == 116


def test_a_tap_between_two_steps_is_pressed_and_let_go():
    w = counting()
    w.apply(Control("go"))
    w.apply(Control("go", 0.0))
    w.step(2)
    assert w.counters["n"] == 110


def test_let_go_and_pressed_anew_between_two_steps():
    w = counting()
    w.apply(Control("go"))
    w.step()
    w.apply(Control("go", 0.0))
    w.apply(Control("go"))
    w.step()
    assert w.counters["n"] == 212


def test_what_is_let_go_ends_before_what_is_pressed_begins():
    left, right = ({"id": name, "press": [{"counter": "n", "set": v}], "release": [{"counter": "n", "set": 0}]}
                   for name, v in [("left", -1), ("right", 1)])  # fmt: skip
    w = game(controls=[left, right])
    w.apply(Control("right"))
    w.step()
    w.apply(Control("left"))
    w.apply(Control("right", 0.0))
    w.step()
    assert w.counters["n"] == -1


def test_the_value_multiplies_what_is_held():
    control = {"id": "go", "keys": ["right"], "minus": ["left"], "hold": [{"velocity": [4, None], "of": "ball"}]}
    w = game(controls=[control])
    for value, speed in [(1.0, 4.0), (-0.5, -2.0), (0.25, 1.0)]:
        w.apply(Control("go", value))
        w.step()
        assert w.body("ball").velocity[0] == pytest.approx(speed)


def test_the_pointer_is_a_place():
    control = {"id": "go", "press": [{"put": "ball", "at": "@pointer"}]}
    w = game(controls=[control])
    w.apply(Control("go", 1.0, pointer=(3.0, 4.0)))
    w.step()
    assert w.body("ball").position == pytest.approx((3.0, 4.0))
    w.apply(Control("go", 0.0))
    w.step()
    assert w.controls[0].pointer == (3.0, 4.0)


def test_rules_wait_for_a_press_and_may_ask_whether_two_touch():
    bodies = [
        {"id": "hero", "position": [0, 0.45], "shapes": [{"circle": 0.25}]},
        {"id": "floor", "type": "static", "shapes": [{"box": [9, 0.4]}]},
    ]
    jump = {"when": {"press": "jump"}, "if": {"touches": ["hero", "*"]},
            "do": [{"velocity": [None, 5], "of": "hero"}, add()]}  # fmt: skip
    w = game([jump], bodies=bodies, gravity=(0, -10), controls=[{"id": "jump", "keys": ["space"]}])
    for pause, count in [(30, 1), (10, 1), (90, 2)]:  # the second press is in mid-air
        w.step(pause)
        w.apply(Control("jump"))
        w.step(2)
        w.apply(Control("jump", 0.0))
        assert w.counters["n"] == count


def test_what_controls_bring_is_told_among_the_events_of_the_step():
    control = {"id": "go", "press": [{"spawn": {"id": "x", "position": [5, 5], "shapes": [{"circle": 1}]}}]}
    w = game(controls=[control])
    w.apply(Control("go"))
    w.step()
    assert told(w, "spawn") == [{"event": "spawn", "step": 1, "body": "x-1", "by": "go"}]
    assert w.events.counts["spawn"] == 1
    w.step()
    assert told(w, "spawn") == []


def test_what_a_window_needs_to_know():
    control = {
        "id": "go",
        "title": "Go on",
        "keys": ["right"],
        "minus": ["left"],
        "pad": ["left stick x"],
        "mouse": ["left"],
    }
    w = game(controls=[control])
    w.apply(Control("go", -1.0))
    (found,) = w.controls
    assert (found.id, found.title, found.keys, found.minus) == ("go", "Go on", ("right",), ("left",))
    assert (found.pad, found.mouse, found.value, found.pointer) == (("left stick x",), ("left",), -1.0, (0.0, 0.0))


@pytest.mark.parametrize(
    ("command", "message"),
    [
        (Control("goo"), "no control 'goo' in this world; did you mean 'go'?"),
        (Control("go", 1.5), "Control of 'go': value of 1.5 is past the limit of 1"),
        (Control("go", float("nan")), "Control of 'go': value must be a finite number, not nan"),
        (Control("go", 1.0, (0.0, 1e10)), "Control of 'go': pointer of 1e+10 is past the limit of 1e+09"),
    ],
)
def test_bad_controls_are_refused(command: Control, message: str):
    w = counting()
    before = w.digest()
    with pytest.raises(CommandError) as caught:
        w.apply(command)
    assert str(caught.value) == message
    assert w.digest() == before


def test_a_scene_without_anything_to_play_has_no_game():
    w = game(counters={})
    assert (w.controls, w.counters, w.outcome, w._game, w._paths) == ((), {}, None, None, None)
