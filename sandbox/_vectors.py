"""Vectors of four numbers for kernels: what is one number for one system is a vector for four systems side by side.

Every operation does in each lane what it does with single numbers, to the bit, so no lane knows of the others.
Compiled, they are LLVM's vectors (`_llvm_vectors.py`); without the compiler they are arrays of numpy
(`_plain_vectors.py`).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, ParamSpec, TypeVar

import sandbox._plain_vectors as plain
from sandbox._plain_vectors import WIDTH, Mask, Number, Vector

__all__ = [
    "WIDTH", "Mask", "Number", "Vector", "absolute", "any_lane", "load", "root", "select", "spread", "store",
]  # fmt: skip

P = ParamSpec("P")
R = TypeVar("R")


class Instruction(Generic[P, R]):
    """A function that kernels call: an instruction of LLVM's in machine code, and in Python a plain function."""

    def __init__(self, function: Callable[P, R]) -> None:
        self._function = function

    def __call__(self, *arguments: P.args, **named: P.kwargs) -> R:
        return self._function(*arguments, **named)

    @property
    def _numba_type_(self) -> Any:
        """What numba asks of an object that a kernel mentions."""
        from sandbox._llvm_vectors import instruction_type

        return instruction_type(self._function.__name__)


load = Instruction(plain.load)
"""The vector that begins at a place of an array."""
store = Instruction(plain.store)
"""Write a vector to a place of an array."""
spread = Instruction(plain.spread)
"""The same number in every lane."""
select = Instruction(plain.select)
"""In each lane the one or the other; also for a single truth. Both have been worked out, whatever they are."""
any_lane = Instruction(plain.any_lane)
"""Whether a mask, or a single truth, holds anywhere."""
absolute = Instruction(plain.absolute)
"""Lane by lane, without the sign."""
root = Instruction(plain.root)
"""The square root, lane by lane."""
