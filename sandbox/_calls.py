"""Calls from kernels into machine code that is known by its address: of another entry point, with a block of arguments.

So one entry point can run others which have been compiled already, without having them compiled into itself
(`_machine_code.py` tells of blocks, `Call.machine` of addresses). A caller that runs as Python calls functions of
Python, by a `handle` in the place of an address.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any
from weakref import WeakValueDictionary

from sandbox._instruction import Instruction

instruction = functools.partial(Instruction, emitter="sandbox._llvm_calls")


CODE, BLOCK = 0, 1
"""Columns of a table of calls: the addresses of machine code and of the block of arguments (`Call.machine`)."""

_functions: WeakValueDictionary[int, Callable[[], Any]] = WeakValueDictionary()


def handle(function: Callable[[], Any]) -> int:
    """A number to call a function by, as long as somebody holds it."""
    number = id(function)
    _functions[number] = function
    return number


@instruction
def call_number(code: int, block: int) -> int:
    """Run an entry point that returns a whole number."""
    return int(_functions[code]())


@instruction
def call_truth(code: int, block: int) -> bool:
    """Run an entry point that returns a truth."""
    return bool(_functions[code]())


@instruction
def call_nothing(code: int, block: int) -> None:
    """Run an entry point that returns nothing."""
    _functions[code]()
