"""Which entry points a step consists of: rows of a table of calls by address, [row, CODE or BLOCK] (`_calls.py`)."""

from __future__ import annotations

FIELDS, COLLIDE, BEGIN, SOLVE, FINISH, CONTINUOUS = 0, 1, 2, 3, 4, 5
"""The parts of a step, in order (`run_steps.py`)."""
IMPACTS, JOINTS, NETS, JOINT_IMPACTS = 6, 7, 8, 9
"""What parts of a step call where a world has it: impacts of a batch, factorised joints, those of nets, and impacts
that joints pass on."""
ROWS = 10
