"""What every worker but the first runs while a step is taken: it looks for tasks and does its part of them.

A task is done by the machine code of the part of the step that offers it (`tasks.py`), called by its address
(`_calls.py`) as another worker than the first: it would be most of a step to compile it here once more.
"""

from __future__ import annotations

from typing import Any

from sandbox._atomics import atomic_load
from sandbox._calls import BLOCK, CODE, call_nothing, call_number, call_truth
from sandbox._jit import entry_point, kernel
from sandbox.engine.records.calls import COLLIDE, FINISH, JOINTS, NETS, SOLVE
from sandbox.engine.records.workers import NUMBERS, Workers
from sandbox.engine.workers.parallel_for import CLOSED, TASK, look_again, note_done, take
from sandbox.engine.workers.task_kinds import BOUND_SHAPES, END, FIRST, LOAD_NETS, SOLVE_BATCHES, SOLVE_ISLANDS
from sandbox.tables import Integers


@entry_point
def serve(parts: Integers, workers: Workers) -> int:
    """Do parts of what is offered until the step is over, as worker `workers.number`; returns how many it did.

    `parts` [row, CODE or BLOCK] are those of the step (`calls.py`), called as this worker.
    """
    words = workers.words
    own: Any = workers.numbers[workers.number * NUMBERS :]
    done = looks = 0
    while atomic_load(words, CLOSED) == 0:
        first, end = take(words, workers.number)
        if first < end:
            own[FIRST] = first
            own[END] = end
            _call_part(parts, words[TASK])
            note_done(words, end - first)
            done += 1
            looks = 0
        else:
            looks = look_again(looks)
    return done


@kernel
def _call_part(parts: Integers, task: int) -> None:
    """Call the part of the step that a task is of."""
    if task <= BOUND_SHAPES:
        call_number(parts[COLLIDE, CODE], parts[COLLIDE, BLOCK])
    elif task <= SOLVE_ISLANDS:
        call_nothing(parts[SOLVE, CODE], parts[SOLVE, BLOCK])
    elif task < SOLVE_BATCHES:
        call_truth(parts[FINISH, CODE], parts[FINISH, BLOCK])
    elif task < LOAD_NETS:
        call_nothing(parts[JOINTS, CODE], parts[JOINTS, BLOCK])
    else:
        call_nothing(parts[NETS, CODE], parts[NETS, BLOCK])
