"""Vectors of four numbers for kernels: what is one number for one system is a vector for four systems side by side.

Every operation does in each lane what it does with single numbers, to the bit, so no lane knows of the others.
Compiled, they are LLVM's vectors (`_llvm_vectors.py`); without the compiler they are arrays of numpy
(`_plain_vectors.py`).
"""

from __future__ import annotations

import sandbox._plain_vectors as plain
from sandbox._instruction import Instruction
from sandbox._plain_vectors import WIDTH, Mask, Number, Vector

__all__ = [
    "WIDTH", "Mask", "Number", "Vector", "absolute", "any_lane", "lane_numbers", "lanes", "load", "load_fields", "root",
    "select", "spread", "store", "store_fields", "transpose",
]  # fmt: skip

_EMITTER = "sandbox._llvm_vectors"

load = Instruction(plain.load, _EMITTER)
"""The vector that begins at a place of an array."""
store = Instruction(plain.store, _EMITTER)
"""Write a vector to a place of an array."""
load_fields = Instruction(plain.load_fields, _EMITTER)
"""The vector of four fields of a row, from the one with a number on, where each eight bytes are a field. What is no
float can only be written back."""
store_fields = Instruction(plain.store_fields, _EMITTER)
"""Write a vector to four fields of a row."""
transpose = Instruction(plain.transpose, _EMITTER)
"""Of four vectors those of their first, second, third and fourth numbers: rows of a table become columns, and back."""
lane_numbers = Instruction(plain.lane_numbers, _EMITTER)
"""0.0, 1.0, 2.0 and 3.0."""
lanes = Instruction(plain.lanes, _EMITTER)
"""The four numbers of a vector."""
spread = Instruction(plain.spread, _EMITTER)
"""The same number in every lane."""
select = Instruction(plain.select, _EMITTER)
"""In each lane the one or the other; also for a single truth. Both have been worked out, whatever they are."""
any_lane = Instruction(plain.any_lane, _EMITTER)
"""Whether a mask, or a single truth, holds anywhere."""
absolute = Instruction(plain.absolute, _EMITTER)
"""Lane by lane, without the sign."""
root = Instruction(plain.root, _EMITTER)
"""The square root, lane by lane."""
