"""What a step asks of the joint solver, which is machine code of its own: only worlds with joints need it.

The parts of a step call it by its address (`_calls.py`), so that each of them is compiled once, for worlds with joints
and without. Who calls it leaves word in the memory of the worker that takes the step: no other one solves what has
joints, but for ranges of the tasks that this offers. Nets, which few worlds have, are a second piece of machine code.
They share no body that moves with parts that are factorised.
"""

from __future__ import annotations

from sandbox._calls import BLOCK, CODE, call_nothing
from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.calls import JOINTS, NETS
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.task_kinds import SECONDS, STAGE

TOUCH, LOAD, SELECT, SOLVE, RELAX, RELAX_LAST, REPORT = 0, 1, 2, 3, 4, 5, 6
"""At the start of a step, when its contacts are known, and when bodies are where they start from; of the substeps of a
level, which `LEVEL` tells, with contacts in the first `SLOTS` slots of the blocks; before a move, after one and after
the last of a step; at the end of a step."""


@inlined_kernel
def has_joints(work: JointWork) -> bool:
    """Whether a joint holds in this world: then the world is the first member."""
    return bool(work.members.shape[0] > 0)


@kernel
def call_joints(contacts: Contacts, workers: Workers, stage: int, seconds: float) -> None:
    """Do a stage of the joint solver with a step or a substep of `seconds`, where a joint holds."""
    workers.numbers[STAGE] = stage
    workers.numbers[SECONDS] = seconds
    calls = contacts.calls[0]
    call_nothing(calls[JOINTS, CODE], calls[JOINTS, BLOCK])
    if calls[NETS, CODE] != 0:
        call_nothing(calls[NETS, CODE], calls[NETS, BLOCK])
