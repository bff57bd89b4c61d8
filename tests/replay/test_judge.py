"""The three times of an expectation: at, always, within."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import Delete, SetPose, Spawn
from sandbox.engine.world import World
from sandbox.replay.expectations import Judge, Verdict
from sandbox.scene import Scene, expect
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape
from sandbox.world.build import build_state

BALL = (FlatShape("circle", ((0.0, 0.0),), radius=0.5),)


def judge_heights(heights: Sequence[float], *wanted: expect.Expectation) -> tuple[Verdict, ...]:
    """Verdicts on a ball that is at `heights[k]` after step k."""
    state = build_state(FlatScene((FlatBody("ball", "dynamic", BALL, position=(0.0, heights[0])),)))
    world = SimpleNamespace(state=state, step_count=0)
    judge = Judge(Scene.model_construct(expect=wanted), world)  # type: ignore[arg-type]
    for step, height in enumerate(heights[1:], start=1):
        state.bodies[0].position_y, world.step_count = height, step
        judge.observe()
    return judge.verdicts()


def above(**time: object) -> expect.Above:
    return expect.Above(above=0, **time)


def test_at_looks_at_one_step_only() -> None:
    (verdict,) = judge_heights([-1, -1, 1, -1], above(at=2))
    assert verdict == Verdict(0, True, 2)


def test_at_fails_with_step_expected_and_got() -> None:
    (verdict,) = judge_heights([1, 1, -2, 1], above(at=2))
    assert verdict == Verdict(0, False, 2, "y at least 0 m", "ball is at y = -2 m")


def test_at_step_zero_is_the_start() -> None:
    assert [v.holds for v in judge_heights([1, -1], above(at=0), expect.Below(at=0, below=0))] == [
        True,
        False,
    ]


def test_always_includes_the_start_and_keeps_the_first_fault() -> None:
    assert judge_heights([1, 1, 1], above(always=True)) == (Verdict(0, True, 2),)
    assert judge_heights([-1, 1, 1], above(always=True))[0].step == 0
    assert judge_heights([1, -1, -3, 1], above(always=True))[0] == Verdict(
        0, False, 1, "y at least 0 m", "ball is at y = -1 m"
    )


def test_within_needs_one_step_of_the_range() -> None:
    assert judge_heights([1, -1, 1, -1], above(within=(1, 3))) == (Verdict(0, True, 2),)
    assert judge_heights([1, -1, -1, -4, 1], above(within=(1, 3))) == (
        Verdict(0, False, 3, "y at least 0 m", "ball is at y = -4 m"),
    )


def test_a_run_that_is_too_short_fails_what_it_did_not_reach() -> None:
    at, within = judge_heights([1, -1], above(at=5), above(within=(1, 3)))
    assert (at.holds, at.expected, at.got) == (False, "a run of at least 5 steps", "the run ended at step 1")
    assert (within.holds, within.expected) == (False, "a run of at least 3 steps")


def test_verdicts_keep_the_order_of_the_scene() -> None:
    verdicts = judge_heights([1, 1, 1], above(always=True), above(at=0), above(within=(1, 2)))
    assert [verdict.index for verdict in verdicts] == [0, 1, 2]


def test_every_condition_must_hold_not_only_the_first() -> None:
    state = build_state(FlatScene((FlatBody("ball", "dynamic", BALL, angular_velocity=1.0),)))
    scene = Scene.model_construct(expect=(expect.Rests(at=0, rests="ball"),))
    judge = Judge(scene, SimpleNamespace(state=state, step_count=0))  # type: ignore[arg-type]
    assert judge.verdicts()[0].got == "ball turns at 1 rad/s"


@pytest.mark.parametrize(("time", "last"), [({"at": 7}, 7), ({"within": (2, 9)}, 9), ({"always": True}, 0)])
def test_the_judge_knows_how_long_a_run_must_be(time: dict[str, object], last: int) -> None:
    state = build_state(FlatScene((FlatBody("ball", "dynamic", BALL),)))
    scene = Scene.model_construct(expect=(above(**time),))
    assert Judge(scene, SimpleNamespace(state=state, step_count=0)).last_step == last  # type: ignore[arg-type]


@given(st.lists(st.sampled_from([-1.0, 1.0]), min_size=6, max_size=12), st.integers(0, 5), st.integers(0, 5))
def test_the_times_agree_with_their_naive_twins(heights: list[float], a: int, b: int) -> None:
    first, last = min(a, b), max(a, b)
    good = [height >= 0 for height in heights]
    at, always, within = judge_heights(heights, above(at=a), above(always=True), above(within=(first, last)))
    assert at.holds == good[a]
    assert always.holds == all(good)
    assert within.holds == any(good[first : last + 1])


def test_an_expectation_follows_the_bodies_that_come_and_go():
    bodies = [{"id": f"b{k}", "shapes": [{"circle": 0.5}], "position": [3 * k, k]} for k in range(3)]
    wanted = [{"at": 3, "stands": "b*", "moved": 0.1}, {"at": 3, "above": 1.5, "of": "b2"}]
    scene = Scene(gravity=(0, 0), bodies=bodies, expect=wanted)
    world = World(scene)
    judge = Judge(scene, world)
    world.apply(Delete("b1"))
    world.apply(Spawn({"id": "b9", "shapes": [{"circle": 0.5}], "position": [50, 50]}))
    for _ in range(3):
        world.step()
        judge.observe()
    assert all(verdict.holds for verdict in judge.verdicts())
    world = World(scene)
    judge = Judge(scene, world)
    world.apply(Delete("b0"))
    world.apply(SetPose("b2", (6.0, 1.0), 0.0))
    for _ in range(3):
        world.step()
        judge.observe()
    assert [verdict.got for verdict in judge.verdicts()] == ["b2 moved 1 m", "b2 is at y = 1 m"]


@pytest.mark.parametrize(
    ("wanted", "got"),
    [
        ({"always": True, "above": -9, "of": "b1"}, "b1 has been deleted"),
        ({"at": 3, "apart": ["b0", "b1"]}, "b1 has been deleted"),
        ({"within": [2, 3], "rests": ["b0", "b1"]}, "b1 has been deleted"),
        ({"at": 3, "stands": ["b?1", "b1"]}, "no body matches b?1 any more"),
        ({"at": 3, "asleep": "*1"}, "no body matches *1 any more"),
        ({"at": 1, "above": -9, "of": "b1"}, ""),
        ({"always": True, "above": -9, "of": "b*"}, ""),
        ({"always": True, "above": -9}, ""),
    ],
)
def test_of_a_deleted_body_nothing_holds(wanted, got):
    bodies = [{"id": f"b{k}", "shapes": [{"circle": 0.5}], "position": [3 * k, k]} for k in range(3)]
    bodies.append({"id": "bx1", "type": "static", "shapes": [{"circle": 0.5}], "position": [0, 9]})
    scene = Scene(gravity=(0, 0), bodies=bodies, expect=[wanted])
    world = World(scene)
    judge = Judge(scene, world)
    world.step()
    judge.observe()
    world.apply(Delete(["b1", "bx1"]))
    for _ in range(2):
        world.step()
        judge.observe()
    (verdict,) = judge.verdicts()
    assert (verdict.holds, verdict.got) == (not got, got)
