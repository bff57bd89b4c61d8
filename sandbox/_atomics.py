"""Atomic operations on whole numbers in an array, by which threads in kernels tell each other what they do.

Compiled, they are LLVM's (`_llvm_atomics.py`), ordered as in C++: what was written before an `atomic_store` or
`atomic_add` is seen by whoever has loaded what it wrote. Without the compiler there is one thread, and they are plain
Python.
"""

from __future__ import annotations

import functools
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox._instruction import Instruction

Integers: TypeAlias = NDArray[np.int64]
instruction = functools.partial(Instruction, emitter="sandbox._llvm_atomics")


@instruction
def atomic_load(words: Integers, at: int) -> int:
    """The number at a place."""
    return int(words[at])


@instruction
def atomic_store(words: Integers, at: int, value: int) -> None:
    """Write the number at a place."""
    words[at] = value


@instruction
def atomic_add(words: Integers, at: int, value: int) -> int:
    """Add to the number at a place; return what it was."""
    before = int(words[at])
    words[at] = before + value
    return before


@instruction
def yield_processor() -> None:
    """Let another thread have the processor, if one waits for it."""


@instruction
def compare_and_swap(words: Integers, at: int, expected: int, value: int) -> int:
    """Write the number at a place if it is the one expected; return what it was."""
    before = int(words[at])
    if before == expected:
        words[at] = value
    return before
