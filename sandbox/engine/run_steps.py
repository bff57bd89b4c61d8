"""Steps in one call: the parts of each (`step.py`) one after another, by the addresses of their machine code.

In a scene of a few bodies, Python takes as long from one part to the next as all parts together, and from one step to
the next a tenth of a step and more.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._calls import BLOCK, CODE, call_nothing, call_number, call_truth
from sandbox._jit import entry_point, kernel
from sandbox.engine.records.calls import BEGIN, COLLIDE, CONTINUOUS, FIELDS, FINISH, SOLVE
from sandbox.tables import Integers

DONE, LACKS_CONTINUOUS, LACKS_IMPACTS, ASLEEP = 0, -1, -2, -3
"""What came of it, if no number of pairs."""

TURN, FIRST, STEPS, LAST_SWITCH, LOST, WORK, ORDER_WORDS = 0, 1, 2, 3, 4, 5, 6
"""Words of an order: whether the next step is an even (0) or an odd one, the part from which on it runs, how many steps
are to be taken, that one or earlier, the last step in which a region or thruster begins or ceases to act, how many
bodies have been frozen and joints broken, and after how much work to return."""


class CounterWords(NamedTuple):
    """Which words of a world hold the counters that are looked at here."""

    step_count: int
    contact_count: int
    awake_count: int
    still: int
    broken_count: int
    frozen_count: int


@entry_point
def run_steps(parts: Integers, words: Integers, at: CounterWords, order: Integers) -> int:
    """Take the steps of an `order`, which is kept up to date, with `parts` [turn, row, CODE or BLOCK] of a world whose
    counters are among `words`; fields without code are left out.

    Returns `DONE` when all are taken, when the awake bodies and contacts of those that are make up the `WORK` of the
    order, or after one in which something was lost, of which Python has to know. `ASLEEP` where everybody slept: steps
    left in the order have only been counted. Else what the next step lacks before it goes on from another part: a
    number of pairs that scratch memory must have room for before `COLLIDE` is run again, code for impacts
    (`strike_batch`) before `SOLVE`, or code for `CONTINUOUS`.
    """
    while order[STEPS] > 0:
        first = order[FIRST]
        if first == FIELDS and words[at.still] != 0 and words[at.step_count] > order[LAST_SWITCH]:
            words[at.step_count] += order[STEPS]
            return ASLEEP
        run = parts[order[TURN]]
        fast = first == CONTINUOUS
        if first == FIELDS and run[FIELDS, CODE] != 0:
            call_nothing(run[FIELDS, CODE], run[FIELDS, BLOCK])
        if first <= COLLIDE:
            lacking_pairs = call_number(run[COLLIDE, CODE], run[COLLIDE, BLOCK])
            if lacking_pairs != 0:
                return lacking_pairs
            if call_truth(run[BEGIN, CODE], run[BEGIN, BLOCK]):
                return LACKS_IMPACTS
        if first <= SOLVE:
            call_nothing(run[SOLVE, CODE], run[SOLVE, BLOCK])
            fast = call_truth(run[FINISH, CODE], run[FINISH, BLOCK])
        if fast:
            if run[CONTINUOUS, CODE] == 0:
                return LACKS_CONTINUOUS
            call_nothing(run[CONTINUOUS, CODE], run[CONTINUOUS, BLOCK])
        order[TURN] = 1 - order[TURN]
        order[FIRST] = FIELDS
        order[STEPS] -= 1
        order[WORK] -= 1 + words[at.awake_count] + words[at.contact_count]
        if order[WORK] <= 0 or words[at.broken_count] + words[at.frozen_count] != order[LOST]:
            return DONE
    return DONE


@kernel
def lost_count(words: Integers, at: CounterWords) -> int:
    """How many joints have broken, and bodies been frozen, by the counters of a world."""
    return int(words[at.broken_count] + words[at.frozen_count])
