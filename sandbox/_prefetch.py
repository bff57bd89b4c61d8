"""A hint for the memory of the machine: rows of a table that will be asked for soon.

Rows that are looked up in another order than they lie in come from far away one by one, each waited for. A kernel that
knows which comes some turns later asks for it now. Without the compiler it does nothing.
"""

from __future__ import annotations

from typing import Any

from sandbox._instruction import Instruction

AHEAD = 8
"""How many turns of a loop before a row is needed it is asked for: long enough for main memory, few enough for L1."""


def _prefetch_row(table: Any, row: int) -> None:
    """Ask for all of a row. It need not be in the table: a hint changes nothing."""


def _prefetch_head(table: Any, row: int) -> None:
    """Ask for its first two cache lines."""


prefetch_row = Instruction(_prefetch_row, "sandbox._llvm_prefetch")
prefetch_head = Instruction(_prefetch_head, "sandbox._llvm_prefetch")
