"""Calls from kernels into machine code that is known by its address: of another entry point, with a block of arguments.

So one entry point can run others which have been compiled already, without having them compiled into itself
(`_machine_code.py` tells of blocks, `Call.machine` of addresses). Without the compiler there are no addresses.
"""

from __future__ import annotations

import functools
from typing import NoReturn

from sandbox._instruction import Instruction

instruction = functools.partial(Instruction, emitter="sandbox._llvm_calls")


@instruction
def call_number(code: int, block: int) -> int:
    """Run an entry point that returns a whole number."""
    _refuse()


@instruction
def call_truth(code: int, block: int) -> bool:
    """Run an entry point that returns a truth."""
    _refuse()


@instruction
def call_nothing(code: int, block: int) -> None:
    """Run an entry point that returns nothing."""
    _refuse()


def _refuse() -> NoReturn:
    raise RuntimeError("there is no machine code without the compiler")
