"""The arguments of an entry point, found by the names of its parameters."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any

from sandbox._jit import interpreted, kernel_argument
from sandbox.engine.joints.records import JointWork
from sandbox.engine.memory.scratch import Scratch
from sandbox.world.state import State


def bind(function: Callable[..., Any], state: State, scratch: Scratch) -> tuple[Any, ...]:
    """What to call `function` with: each parameter is named like the array of `state` or `scratch` it takes.

    `contacts` are those of the step under way, `old_contacts` those of the step before; `joint_table` is that of the
    state, `joints` the scratch memory of the joint solver, which holds the table, or None.
    """
    arrays = {**vars(state), "old_contacts": state.contacts, "joint_table": state.joints, **vars(scratch)}
    return tuple(_argument(arrays[name]) for name in _parameters(function))


@cache
def _parameters(function: Callable[..., Any]) -> tuple[str, ...]:
    return tuple(inspect.signature(interpreted(function)).parameters)


def _argument(value: Any) -> Any:
    if isinstance(value, JointWork):
        return JointWork(*(kernel_argument(array) for array in value))
    return kernel_argument(value)
