"""Atomic operations as numba and LLVM have them.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
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
_WORD = types.int64


def _place(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    array = context.make_array(sig.args[0])(context, builder, values[0])
    return builder.gep(array.data, [values[1]])


@intrinsic
def _load(_typing: Any, words: Any, _at: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        return builder.load_atomic(_place(context, builder, sig, values), "acquire", 8)

    return _WORD(words, _WORD), lower


@intrinsic
def _store(_typing: Any, words: Any, _at: Any, _value: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        builder.store_atomic(values[2], _place(context, builder, sig, values), "release", 8)
        return context.get_dummy_value()

    return types.void(words, _WORD, _WORD), lower


@intrinsic
def _add(_typing: Any, words: Any, _at: Any, _value: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        return builder.atomic_rmw("add", _place(context, builder, sig, values), values[2], "acq_rel")

    return _WORD(words, _WORD, _WORD), lower


@intrinsic
def _compare_and_swap(_typing: Any, words: Any, _at: Any, _expected: Any, _value: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        place = _place(context, builder, sig, values)
        return builder.extract_value(builder.cmpxchg(place, values[2], values[3], "acq_rel", "acquire"), 0)

    return _WORD(words, _WORD, _WORD, _WORD), lower


@intrinsic
def _yield_processor(_typing: Any) -> Any:
    name = "SwitchToThread" if sys.platform == "win32" else "sched_yield"

    def lower(context: Any, builder: Any, _sig: Any, _values: Any) -> Any:
        sort = ir.FunctionType(ir.IntType(32), [])
        builder.call(cgutils.get_or_insert_function(builder.module, sort, name), [])
        return context.get_dummy_value()

    return types.void(), lower


_INSTRUCTIONS: dict[str, Any] = {
    "atomic_load": _load,
    "atomic_store": _store,
    "atomic_add": _add,
    "compare_and_swap": _compare_and_swap,
    "yield_processor": _yield_processor,
}
cpu_target.typing_context.refresh()  # a function may be under way, at whose beginning these were not known


def instruction_type(name: str) -> Any:
    """What numba knows a function of `_atomics.py` by."""
    return cpu_target.typing_context.resolve_value_type(_INSTRUCTIONS[name])
