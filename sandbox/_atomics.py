"""Atomic operations on whole numbers in an array, by which threads in kernels tell each other what they do.

Compiled, they are LLVM's (`_llvm_atomics.py`), ordered as in C++: what was written before an `atomic_store` or
`atomic_add` is seen by whoever has loaded what it wrote. Without the compiler there is one thread, and they are plain
Python.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, ParamSpec, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

Integers: TypeAlias = NDArray[np.int64]
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
        from sandbox._llvm_atomics import instruction_type

        return instruction_type(self._function.__name__)


@Instruction
def atomic_load(words: Integers, at: int) -> int:
    """The number at a place."""
    return int(words[at])


@Instruction
def atomic_store(words: Integers, at: int, value: int) -> None:
    """Write the number at a place."""
    words[at] = value


@Instruction
def atomic_add(words: Integers, at: int, value: int) -> int:
    """Add to the number at a place; return what it was."""
    before = int(words[at])
    words[at] = before + value
    return before


@Instruction
def yield_processor() -> None:
    """Let another thread have the processor, if one waits for it."""


@Instruction
def compare_and_swap(words: Integers, at: int, expected: int, value: int) -> int:
    """Write the number at a place if it is the one expected; return what it was."""
    before = int(words[at])
    if before == expected:
        words[at] = value
    return before
