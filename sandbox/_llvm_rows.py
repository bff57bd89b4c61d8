"""How kernels find a row of a table: from its first one on.

By itself numba takes a negative index for one that counts from the end, as Python does, and asks that of every index
unless LLVM can prove it needless. Kernels have none. With `SANDBOX_CHECK_ROWS=1` they are compiled to end the process
at an index that is negative or past the end, and to name the kernel; run as Python, they would take the first for a row
from the end.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils as _cgutils
from numba.np import arrayobj as _arrayobj

cgutils: Any = _cgutils
arrayobj: Any = _arrayobj
CHECKED = os.environ.get("SANDBOX_CHECK_ROWS", "0").strip() not in ("", "0")


@contextmanager
def rows_from_the_first() -> Iterator[None]:
    """Compile kernels so."""
    usual = arrayobj.fix_integer_index
    arrayobj.fix_integer_index = _index
    try:
        yield
    finally:
        arrayobj.fix_integer_index = usual


def _index(context: Any, builder: Any, kind: Any, value: Any, size: Any) -> Any:
    """An index as a word."""
    row = context.cast(builder, value, kind, types.intp if kind.signed else types.uintp)
    if CHECKED:
        with cgutils.if_unlikely(builder, builder.icmp_unsigned(">=", row, size)):
            _end_process(builder)
    return row


def _end_process(builder: Any) -> None:
    """Say in which kernel, by functions of C's library, and end."""
    module, nothing = builder.module, ir.VoidType()
    words = f"sandbox: there is no such row; {module.name} asks for it"
    place = cgutils.make_bytearray((words + "\0").encode())
    text = cgutils.global_constant(module, "no_such_row", place)
    pointer = ir.IntType(8).as_pointer()
    say = cgutils.get_or_insert_function(module, ir.FunctionType(nothing, [pointer]), "perror")
    end = cgutils.get_or_insert_function(module, ir.FunctionType(nothing, []), "abort")
    builder.call(say, [builder.bitcast(text, pointer)])
    builder.call(end, [])
