"""Prefetching as numba and LLVM have it.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
LLVM's instruction: https://llvm.org/docs/LangRef.html#llvm-prefetch-intrinsic
"""

from __future__ import annotations

import sys
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils as _cgutils
from numba.core.registry import cpu_target
from numba.extending import intrinsic

cgutils: Any = _cgutils
_INT = ir.IntType(32)
_WORD = ir.IntType(64)
_BYTE = ir.IntType(8).as_pointer()
_LINE = 64
"""Bytes that come at once."""
_HEAD = 2 * _LINE
"""Bytes of the head of a row."""
_NUMBER = 8
"""Bytes of a number by itself."""
_TO_READ, _TO_STAY, _DATA = ir.Constant(_INT, 0), ir.Constant(_INT, 3), ir.Constant(_INT, 1)


def _prefetch(table: Any, most: int) -> Any:
    """As numba wants an intrinsic: its type, and what it is in machine code; for `most` bytes of a row."""
    size = table.dtype.size if isinstance(table.dtype, types.Record) else table.dtype.bitwidth // 8
    asked = min(size, most)

    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        array = context.make_array(sig.args[0])(context, builder, values[0])
        start = builder.ptrtoint(array.data, _WORD)
        row = builder.add(start, builder.mul(values[1], ir.Constant(_WORD, size)))
        sort = ir.FunctionType(ir.VoidType(), [_BYTE, _INT, _INT, _INT])
        function = cgutils.get_or_insert_function(builder.module, sort, "llvm.prefetch.p0i8")
        # A row that is no number of whole lines ends in one more, wherever it begins.
        for offset in (*range(0, asked, _LINE), *([asked - 1] if size % _LINE and asked > _NUMBER else [])):
            place = builder.inttoptr(builder.add(row, ir.Constant(_WORD, offset)), _BYTE)
            builder.call(function, [place, _TO_READ, _TO_STAY, _DATA])
        return context.get_dummy_value()

    return types.void(table, types.int64), lower


@intrinsic
def _prefetch_row(_typing: Any, table: Any, _row: Any) -> Any:
    return _prefetch(table, sys.maxsize)


@intrinsic
def _prefetch_head(_typing: Any, table: Any, _row: Any) -> Any:
    return _prefetch(table, _HEAD)


cpu_target.typing_context.refresh()  # a function may be under way, at whose beginning this was not known


def instruction_type(name: str) -> Any:
    """What numba knows the function of that name of `_prefetch.py` by."""
    return cpu_target.typing_context.resolve_value_type(globals()[name])
