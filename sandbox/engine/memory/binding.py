"""The arguments of an entry point, found by the names of its parameters."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any

from sandbox._jit import interpreted, kernel_argument
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.state import StateTables
from sandbox.world.state import State


def bind(function: Callable[..., Any], state: State, scratch: Scratch) -> tuple[Any, ...]:
    """What to call `function` with: each parameter is named like what it takes.

    That is `state` for the state's tables, a table of the state, or a bundle or table of the scratch memory.
    `old_contacts` are those of the step before, `joint_table` is that of the state, `joints` the scratch memory of the
    joint solver, which holds the table, or None.
    """
    tables = StateTables(*(getattr(state, name) for name in StateTables._fields))
    named = {**vars(state), "old_contacts": state.contacts, "joint_table": state.joints, **vars(scratch)}
    named |= {"state": tables, "active_info": scratch.active.info, "free_motions": scratch.solver.free_motions}
    arguments: tuple[Any, ...] = kernel_argument(tuple(named[name] for name in _parameters(function)))
    return arguments


@cache
def _parameters(function: Callable[..., Any]) -> tuple[str, ...]:
    return tuple(inspect.signature(interpreted(function)).parameters)
