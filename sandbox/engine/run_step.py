"""A step in one call: its parts (`step.py`) one after another, each by the address of its machine code (`_calls.py`).

In a scene of a few bodies, Python takes as long from one part to the next as all parts together.
"""

from __future__ import annotations

from sandbox._calls import BLOCK, CODE, call_nothing, call_number, call_truth
from sandbox._jit import entry_point
from sandbox.engine.records.calls import BEGIN, COLLIDE, CONTINUOUS, FIELDS, FINISH, SOLVE
from sandbox.tables import Integers

DONE, LACKS_CONTINUOUS, LACKS_IMPACTS = 0, -1, -2
"""What came of it, if no number of pairs."""


@entry_point
def run_step(parts: Integers, first: int) -> int:
    """Run the `parts` [row, CODE or BLOCK] of a step from the `first` one on; fields without code are left out.

    Returns `DONE`, or what it lacks: a number of pairs that scratch memory must have room for before `COLLIDE` is run
    again, code for `CONTINUOUS`, from which it goes on, or for impacts (`strike_batch`) before `SOLVE`.
    """
    fast = first == CONTINUOUS
    if first == FIELDS and parts[FIELDS, CODE] != 0:
        call_nothing(parts[FIELDS, CODE], parts[FIELDS, BLOCK])
    if first <= COLLIDE:
        lacking_pairs = call_number(parts[COLLIDE, CODE], parts[COLLIDE, BLOCK])
        if lacking_pairs != 0:
            return lacking_pairs
        if call_truth(parts[BEGIN, CODE], parts[BEGIN, BLOCK]):
            return LACKS_IMPACTS
    if first <= SOLVE:
        call_nothing(parts[SOLVE, CODE], parts[SOLVE, BLOCK])
        fast = call_truth(parts[FINISH, CODE], parts[FINISH, BLOCK])
    if fast:
        if parts[CONTINUOUS, CODE] == 0:
            return LACKS_CONTINUOUS
        call_nothing(parts[CONTINUOUS, CODE], parts[CONTINUOUS, BLOCK])
    return DONE
