"""What can be collected, and what is said of what cannot."""

from __future__ import annotations

import math
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.sweeps.collector import run_and_collect
from sandbox.sweeps.expression import read_expression, read_expressions
from sandbox.sweeps.readings import BODY, JOINT, WORLD

BALL = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [1, 9], "velocity": [2, 0], "angle": 30}
BOB = {"id": "bob", "shapes": [{"circle": 0.2}], "position": [8, 5]}
ROD = {"id": "rod", "type": "distance", "bodies": [None, "bob"], "anchors": [[8, 7], [8, 5]]}


def world() -> sandbox.World:
    return sandbox.World(sandbox.Scene(bodies=[BALL, BOB], joints=[ROD]))


def collected(*texts: str, steps: int = 60) -> dict[str, float]:
    expressions = read_expressions(texts)
    names = [column for each in expressions for column in each.columns]
    return dict(zip(names, run_and_collect(world(), steps, expressions), strict=True))


def test_columns_are_what_the_world_says() -> None:
    found = collected(*(f"body('ball').{name}" for name in BODY), *(f"joint('rod').{name}" for name in JOINT), *WORLD)
    after = world()
    after.step(60)
    ball, rod = after.body("ball"), after.joint("rod")
    assert (found["ball_position_x"], found["ball_position_y"]) == ball.position == (found["ball_x"], found["ball_y"])
    assert (found["ball_velocity_x"], found["ball_velocity_y"]) == ball.velocity
    assert found["ball_speed"] == pytest.approx(math.hypot(*ball.velocity), rel=1e-15)
    assert found["ball_angle"] == ball.angle
    assert (found["rod_force_x"], found["rod_force_y"]) == rod.force
    assert (found["time"], found["bodies"], found["awake"], found["contacts"]) == (1.0, 2, after.awake_count, 0)


def test_energy_is_that_of_the_fall() -> None:
    start, end = (collected("energy", steps=steps)["energy"] for steps in (0, 30))
    assert end == pytest.approx(start, rel=1e-9)
    mass = math.pi / 4
    by_hand = mass * (9.81 * 9 + 0.5 * 4) + math.pi * 0.04 * 9.81 * 5
    assert start == pytest.approx(by_hand, rel=1e-12)


def test_values_over_time() -> None:
    found = collected("max(body('ball').y)", "low = min(body('ball').y)", "mean(body('ball').velocity.x)",
                      "at(30, body('ball').position)", "final(body('ball').y)")  # fmt: skip
    assert found["max_ball_y"] == 9.0
    assert found["low"] == found["ball_y"] < found["ball_position_at_30_y"] < 9.0
    assert found["mean_ball_velocity_x"] == 2.0
    assert found["ball_position_at_30_x"] == pytest.approx(2.0)


def test_reading_at_steps_leaps_to_the_same_bits() -> None:
    leaping = collected("at(7, body('ball').y)", "body('ball').y")
    watching = collected("at(7, body('ball').y)", "body('ball').y", "max(time)")
    assert leaping == {name: watching[name] for name in leaping}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no expression"),
        ("body('a').position +", "no expression"),
        ("body('a')", "what of it"),
        ("body(a).position", "by its id in quotes"),
        ("body('a').positon", 'did you mean "position"'),
        ("body('a').position.z", "a vector has .x and .y"),
        ("body('a').angle.x", "angle is one number"),
        ("counter('a').x", "a counter is one number"),
        ("enrgy", 'did you mean "energy"'),
        ("max(min(energy))", "outermost"),
        ("at(energy)", "at takes a step"),
        ("at(1.5, energy)", "at takes a step"),
        ("sum(energy)", "there is no sum"),
        ("energy + 1", "write an expression"),
        ("body('a').__class__", "no '__class__'"),
        ("__import__('os')", "there is no __import__"),
        ("__import__('os').system('x')", "write an expression"),
        ("(lambda: 1)()", "write an expression"),
        ("[energy]", "write an expression"),
        ("body(*'a').x", "by its id"),
        ("body('a', key=1).x", "write an expression"),
        ("(" * 300 + ")" * 300, "characters"),
    ],
)  # fmt: skip
def test_what_is_no_expression(text: str, said: str) -> None:
    with pytest.raises(sandbox.ArgumentError) as error:
        read_expression(text)
    assert said in str(error.value)
    assert len(str(error.value)) < 400


@given(st.text(max_size=60) | st.from_regex(r"(max|at|body|joint|energy|[().,'\w ]){1,12}", fullmatch=True))
def test_any_text_is_read_or_refused(text: str) -> None:
    with suppress(sandbox.ArgumentError):
        assert read_expression(text).columns


def test_two_columns_of_one_name_are_refused() -> None:
    with pytest.raises(sandbox.ArgumentError, match="both make a column 'e'"):
        read_expressions(["e = energy", "e = time"])
