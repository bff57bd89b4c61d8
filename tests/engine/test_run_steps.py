"""What runs of steps, from where, and what is asked for meanwhile: `run_steps` with functions in the place of parts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sandbox._calls import CODE, handle
from sandbox._jit import interpreted
from sandbox.engine.records.calls import BEGIN, COLLIDE, CONTINUOUS, FIELDS, FINISH, SOLVE
from sandbox.engine.run_steps import (
    ASLEEP,
    DONE,
    FIRST,
    LACKS_CONTINUOUS,
    LACKS_IMPACTS,
    LAST_SWITCH,
    ORDER_WORDS,
    STEPS,
    TURN,
    WORK,
    run_steps,
)
from sandbox.engine.step_calls import COUNTER_WORDS as AT

STEP = [FIELDS, COLLIDE, BEGIN, SOLVE, FINISH]


class Parts:
    """A table of parts that note when they run; what `collide`, `begin` and `finish` return can be set. `at_end` is
    called with the counters at the end of each step."""

    def __init__(self, without: tuple[int, ...] = ()) -> None:
        self.ran: list[int] = []
        self.turns: list[int] = []
        self.returns: dict[int, Any] = {COLLIDE: 0, BEGIN: False, FINISH: False}
        self.words = np.zeros(16, np.int64)
        self.order = np.zeros(ORDER_WORDS, np.int64)
        self.at_end: Callable[[Any], None] = lambda words: None
        self.functions = [[self._part(number, turn) for number in range(CONTINUOUS + 1)] for turn in (0, 1)]
        self.table = np.zeros((2, CONTINUOUS + 1, 2), np.int64)
        for turn, functions in enumerate(self.functions):
            for number, function in enumerate(functions):
                self.table[turn, number, CODE] = 0 if number in without else handle(function)

    def _part(self, number: int, turn: int) -> Callable[[], Any]:
        def run() -> Any:
            self.ran.append(number)
            if number == FINISH:
                self.turns.append(turn)
                self.words[AT.step_count] += 1
                self.at_end(self.words)
            return self.returns.get(number)

        return run

    def run(self, first: int = FIELDS, steps: int = 1, work: int = 1000) -> int:
        """What so many steps come to."""
        self.order[FIRST], self.order[STEPS], self.order[WORK] = first, steps, work
        return int(interpreted(run_steps)(self.table, self.words, AT, self.order))

    @property
    def left(self) -> int:
        return int(self.order[STEPS])


@pytest.mark.parametrize("fast", [False, True])
def test_all_parts_run_in_order_and_the_last_one_where_something_is_fast(fast: bool) -> None:
    parts = Parts()
    parts.returns[FINISH] = fast
    assert parts.run() == DONE
    assert parts.ran == ([*STEP, CONTINUOUS] if fast else STEP)


def test_a_world_without_fields_leaves_them_out() -> None:
    parts = Parts(without=(FIELDS,))
    assert parts.run() == DONE
    assert parts.ran == STEP[1:]


def test_pairs_that_lack_room_are_told_before_anything_else_runs_and_fields_act_once() -> None:
    parts = Parts()
    parts.returns[COLLIDE] = 40
    assert parts.run() == 40
    assert parts.ran == [FIELDS, COLLIDE]
    parts.returns[COLLIDE] = 0
    assert parts.run(COLLIDE) == DONE
    assert parts.ran == [FIELDS, COLLIDE, *STEP[1:]]


def test_the_last_part_is_asked_for_when_it_is_needed_and_nothing_else_runs_again() -> None:
    parts = Parts(without=(CONTINUOUS,))
    parts.returns[FINISH] = True
    assert parts.run() == LACKS_CONTINUOUS
    parts.table[0, CONTINUOUS, CODE] = handle(parts.functions[0][CONTINUOUS])
    assert parts.run(CONTINUOUS) == DONE
    assert parts.ran == [*STEP, CONTINUOUS]


def test_what_resolves_impacts_is_asked_for_before_anything_moves() -> None:
    parts = Parts()
    parts.returns[BEGIN] = True
    assert parts.run() == LACKS_IMPACTS
    assert parts.ran == STEP[:3]
    assert parts.run(SOLVE) == DONE
    assert parts.ran == STEP


def test_even_and_odd_steps_take_turns_until_all_are_taken() -> None:
    parts = Parts()
    assert parts.run(steps=3) == DONE
    assert (parts.turns, parts.left, parts.order[TURN]) == ([0, 1, 0], 0, 1)
    assert parts.run(steps=2) == DONE
    assert parts.turns == [0, 1, 0, 1, 0]


def test_what_takes_long_comes_back_after_some_steps_but_one_at_least() -> None:
    parts = Parts()
    parts.words[AT.awake_count], parts.words[AT.contact_count] = 5, 4
    assert parts.run(steps=9, work=25) == DONE
    assert len(parts.turns) == 3
    assert parts.left == 6
    assert parts.run(steps=9, work=0) == DONE
    assert parts.left == 8


@pytest.mark.parametrize("lost", [AT.broken_count, AT.frozen_count])
def test_a_step_in_which_something_is_lost_is_the_last_one_for_now(lost: int) -> None:
    parts = Parts()

    def lose_one(words: Any) -> None:
        words[lost] += words[AT.step_count] == 2

    parts.at_end = lose_one
    assert parts.run(steps=9) == DONE
    assert parts.left == 7


def test_a_step_that_lacks_something_is_still_to_be_taken() -> None:
    parts = Parts()
    assert parts.run(steps=2) == DONE
    parts.returns[COLLIDE] = 40
    assert parts.run(steps=5) == 40
    assert (parts.left, parts.order[TURN]) == (5, 0)


def test_steps_in_which_everybody_sleeps_are_counted_once_no_switch_is_to_come() -> None:
    parts = Parts()
    parts.words[AT.still] = 1
    parts.order[LAST_SWITCH] = 3
    assert parts.run(steps=10) == ASLEEP
    assert (len(parts.turns), parts.left, parts.words[AT.step_count]) == (4, 6, 10)
