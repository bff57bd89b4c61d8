"""The arguments of an entry point, found by the names of its parameters."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any

from sandbox._jit import interpreted, kernel_argument
from sandbox.engine.joints.part_tables import no_joints
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.world.state import State


def bind(function: Callable[..., Any], state: State, scratch: Scratch) -> tuple[Any, ...]:
    """What to call `function` with: each parameter is named like what it takes.

    That is `state` for the state's tables, a table of the state, or a bundle or table of the scratch memory.
    `old_contacts` are those of the step before, `joint_table` is that of the state, `joints` the scratch memory of the
    joint solver, which holds the table, or empty tables if no joint holds.
    """
    named = state_arguments(state) | scratch_arguments(scratch) | contact_arguments(scratch.contacts)
    return tuple(named[name] for name in parameters(function))


def state_arguments(state: State) -> dict[str, Any]:
    """What is bound of a state."""
    tables = StateTables(*[getattr(state, name) for name in StateTables._fields])
    return {"state": kernel_argument(tables), "joint_table": kernel_argument(state.joints)}


def contact_arguments(contacts: Contacts) -> dict[str, Any]:
    """What is bound of the tables of contacts."""
    tables = kernel_argument(contacts)
    return {"contacts": tables, "old_contacts": tables.before}


def scratch_arguments(scratch: Scratch) -> dict[str, Any]:
    """What is bound of scratch memory."""
    named = vars(scratch) | {"free_motions": scratch.solver.free_motions}
    return {name: kernel_argument(value) for name, value in named.items()} | joint_arguments(scratch)


def joint_arguments(scratch: Scratch) -> dict[str, Any]:
    """What is bound of what scratch memory has of joints."""
    joints = kernel_argument(scratch.joints or no_joints())
    return {"joints": joints, "joint_filter": kernel_argument(scratch.joint_filter)}


@cache
def parameters(function: Callable[..., Any]) -> tuple[str, ...]:
    """The names of the parameters of an entry point."""
    return tuple(inspect.signature(interpreted(function)).parameters)
