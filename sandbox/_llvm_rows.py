"""How kernels find a row of a table: from its first one on.

By itself numba takes a negative index for one that counts from the end, as Python does, and asks that of every index
unless LLVM can prove it needless. Kernels have none. With `SANDBOX_CHECK_ROWS=1` they are compiled to end the process
at an index that is negative or past the end, and to name the kernel and who called it; run as Python, they would take
the first for a row from the end.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
"""

from __future__ import annotations

import operator
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from llvmlite import ir
from numba import types as _types
from numba.core import cgutils as _cgutils
from numba.extending import lower_builtin as _lower_builtin
from numba.np import arrayobj as _arrayobj

types: Any = _types
cgutils: Any = _cgutils
arrayobj: Any = _arrayobj
lower_builtin: Any = _lower_builtin
CHECKED = os.environ.get("SANDBOX_CHECK_ROWS", "0").strip() not in ("", "0")
_of_kernels: list[None] = []


@contextmanager
def rows_from_the_first() -> Iterator[None]:
    """Compile kernels so; other functions in the process have numba's indices."""
    _of_kernels.append(None)
    try:
        yield
    finally:
        _of_kernels.pop()


@lower_builtin(operator.getitem, types.Array, types.Integer)  # type: ignore[untyped-decorator]
def _item(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    table, kind = sig.args
    if not _is_item(table, (kind,)):
        return arrayobj.getitem_arraynd_intp(context, builder, sig, values)
    return arrayobj.load_item(context, builder, table, _place(context, builder, table, values[0], (kind,), values[1:]))


@lower_builtin(operator.getitem, types.Array, types.BaseTuple)  # type: ignore[untyped-decorator]
def _item_of_many(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    table, kinds = sig.args
    if not _is_item(table, kinds.types):
        return arrayobj.getitem_array_tuple(context, builder, sig, values)
    rows = cgutils.unpack_tuple(builder, values[1])
    return arrayobj.load_item(context, builder, table, _place(context, builder, table, values[0], kinds.types, rows))


@lower_builtin(operator.setitem, types.Array, types.Integer, types.Any)  # type: ignore[untyped-decorator]
@lower_builtin(operator.setitem, types.Array, types.BaseTuple, types.Any)  # type: ignore[untyped-decorator]
def _set_item(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    table, kind, given = sig.args
    kinds = kind.types if isinstance(kind, types.BaseTuple) else (kind,)
    if not _is_item(table, kinds):
        return arrayobj.setitem_array(context, builder, sig, values)
    rows = cgutils.unpack_tuple(builder, values[1]) if isinstance(kind, types.BaseTuple) else values[1:2]
    value = context.cast(builder, values[2], given, table.dtype)
    arrayobj.store_item(context, builder, table, value, _place(context, builder, table, values[0], kinds, rows))
    return context.get_dummy_value()


def _is_item(table: Any, kinds: Sequence[Any]) -> bool:
    """Whether kernels are compiled, and indices of these types are those of a number or of a row."""
    whole = len(kinds) == table.ndim and all(isinstance(each, types.Integer) for each in kinds)
    return bool(_of_kernels) and whole and table.layout == "C"


def _place(context: Any, builder: Any, table: Any, value: Any, kinds: Sequence[Any], rows: Sequence[Any]) -> Any:
    """Pointer to an item of an array."""
    model = context.data_model_manager[table]
    data, shape, strides = (
        builder.extract_value(value, model.get_field_position(name)) for name in ("data", "shape", "strides")
    )
    words = [context.cast(builder, row, kind, types.intp) for row, kind in zip(rows, kinds, strict=True)]
    lengths = cgutils.unpack_tuple(builder, shape, table.ndim)
    if CHECKED:
        for word, length in zip(words, lengths, strict=True):
            with cgutils.if_unlikely(builder, builder.icmp_unsigned(">=", word, length)):
                _end_process(builder)
    return cgutils.get_item_pointer2(context, builder, data, lengths, strides, table.layout, words)


def _end_process(builder: Any) -> None:
    """Say in which kernel, and from where in Python it is called, and end."""
    module = builder.module
    words = f"sandbox: there is no such row; {module.name} asks for it\0"
    text = cgutils.global_constant(module, "no_such_row", cgutils.make_bytearray(words.encode()))
    pointer = ir.IntType(8).as_pointer()
    end = cgutils.get_or_insert_function(module, ir.FunctionType(ir.VoidType(), [pointer]), "Py_FatalError")
    builder.call(end, [builder.bitcast(text, pointer)])
