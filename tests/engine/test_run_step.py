"""What runs of a step, from where, and what is asked for meanwhile: `run_step` with functions in the place of parts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sandbox._calls import CODE, handle
from sandbox._jit import interpreted
from sandbox.engine.records.calls import BEGIN, COLLIDE, CONTINUOUS, FIELDS, FINISH, SOLVE
from sandbox.engine.run_step import DONE, LACKS_CONTINUOUS, LACKS_IMPACTS, run_step

STEP = [FIELDS, COLLIDE, BEGIN, SOLVE, FINISH]


class Parts:
    """A table of parts that note when they run; what `collide`, `begin` and `finish` return can be set."""

    def __init__(self, without: tuple[int, ...] = ()) -> None:
        self.ran: list[int] = []
        self.returns: dict[int, Any] = {COLLIDE: 0, BEGIN: False, FINISH: False}
        self.functions = [self._part(number) for number in range(CONTINUOUS + 1)]
        self.table = np.zeros((CONTINUOUS + 1, 2), np.int64)
        for number, function in enumerate(self.functions):
            self.table[number, CODE] = 0 if number in without else handle(function)

    def _part(self, number: int) -> Callable[[], Any]:
        def run() -> Any:
            self.ran.append(number)
            return self.returns.get(number)

        return run

    def run(self, first: int = FIELDS) -> int:
        """What a step comes to."""
        return int(interpreted(run_step)(self.table, first))


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
    parts.table[CONTINUOUS, CODE] = handle(parts.functions[CONTINUOUS])
    assert parts.run(CONTINUOUS) == DONE
    assert parts.ran == [*STEP, CONTINUOUS]


def test_what_resolves_impacts_is_asked_for_before_anything_moves() -> None:
    parts = Parts()
    parts.returns[BEGIN] = True
    assert parts.run() == LACKS_IMPACTS
    assert parts.ran == STEP[:3]
    assert parts.run(SOLVE) == DONE
    assert parts.ran == STEP
