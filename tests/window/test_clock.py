from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.window.clock import SPEEDS, StepClock

STEP = 1 / 60
frames = st.lists(st.floats(0.0, 0.05), min_size=1, max_size=200)


@given(frames)
def test_no_time_is_lost_or_made(elapsed: list[float]) -> None:
    clock = StepClock(STEP)
    steps = sum(clock.advance(seconds, 100) for seconds in elapsed)
    assert steps * STEP + clock.alpha * STEP == pytest.approx(sum(elapsed), abs=1e-9)


@given(frames, st.integers(1, 5))
def test_never_more_steps_than_allowed_and_the_picture_stays_between_two(elapsed: list[float], most: int) -> None:
    clock = StepClock(STEP)
    for seconds in elapsed:
        assert 0 <= clock.advance(seconds, most) <= most
        assert 0.0 <= clock.alpha <= 1.0


@given(frames, st.sampled_from([speed for speed in SPEEDS if speed <= 1.0]))
def test_slow_motion_takes_the_same_steps_later(elapsed: list[float], speed: float) -> None:
    slow, normal = StepClock(STEP), StepClock(STEP)
    slow.speed = speed
    steps = sum(slow.advance(seconds, 1000) for seconds in elapsed)
    expected = sum(normal.advance(seconds * speed, 1000) for seconds in elapsed)
    assert steps == expected
    assert slow.alpha == normal.alpha


@given(frames)
def test_pause_stands_still(elapsed: list[float]) -> None:
    clock = StepClock(STEP)
    clock.advance(0.4 * STEP, 8)
    clock.paused = True
    assert [clock.advance(seconds, 8) for seconds in elapsed] == [0] * len(elapsed)
    assert clock.alpha == pytest.approx(0.4)


def test_time_beyond_the_limit_is_dropped() -> None:
    clock = StepClock(STEP)
    assert clock.advance(10.0, 3) == 3
    assert clock.advance(0.0, 3) == 0


def test_settle_shows_the_last_step_and_is_due_for_the_next() -> None:
    clock = StepClock(STEP)
    clock.snap_to_step()
    assert clock.alpha == 1.0
    assert clock.advance(0.5 * STEP, 8) == 1
    assert clock.alpha == pytest.approx(0.5)


def test_speeds_stop_at_the_ends() -> None:
    clock = StepClock(STEP)
    clock.change_speed(-1)
    assert clock.speed == 0.5
    clock.change_speed(-100)
    assert clock.speed == SPEEDS[0]
    clock.change_speed(100)
    assert clock.speed == SPEEDS[-1]
