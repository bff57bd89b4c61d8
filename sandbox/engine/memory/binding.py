"""The arguments of an entry point, found by the names of its parameters."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any

from sandbox._jit import interpreted, kernel_argument
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.state import StateTables
from sandbox.world.state import ARRAYS, State


def bind(function: Callable[..., Any], state: State, scratch: Scratch) -> tuple[Any, ...]:
    """What to call `function` with: each parameter is named like what it takes.

    That is `state` for the state's tables, a table of the state, or a bundle or table of the scratch memory.
    `old_contacts` are those of the step before, `joint_table` is that of the state, `joints` the scratch memory of the
    joint solver, which holds the table, or None.
    """
    named = state_arguments(state) | scratch_arguments(scratch)
    return tuple(named[name] for name in parameters(function))


def state_arguments(state: State) -> dict[str, Any]:
    """What is bound of a state."""
    tables = StateTables(*(getattr(state, name) for name in StateTables._fields))
    own = {name: getattr(state, name) for name in ARRAYS}
    named = own | {"state": tables, "old_contacts": state.contacts, "joint_table": state.joints}
    return {name: kernel_argument(value) for name, value in named.items()}


def scratch_arguments(scratch: Scratch) -> dict[str, Any]:
    """What is bound of scratch memory."""
    named = vars(scratch) | {"active_info": scratch.active.info, "free_motions": scratch.solver.free_motions}
    return {name: kernel_argument(value) for name, value in named.items()}


@cache
def parameters(function: Callable[..., Any]) -> tuple[str, ...]:
    """The names of the parameters of an entry point."""
    return tuple(inspect.signature(interpreted(function)).parameters)
