"""Calls by address as numba and LLVM have them.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core.registry import cpu_target
from numba.extending import intrinsic

_WORD = types.int64
_BLOCK = ir.IntType(64).as_pointer()


def _result(builder: Any, values: Any, returns: Any) -> Any:
    """Call the function at an address with the address of a block, as `_way_in.py` defines it."""
    function = builder.inttoptr(values[0], ir.FunctionType(returns, [_BLOCK]).as_pointer())
    return builder.call(function, [builder.inttoptr(values[1], _BLOCK)])


@intrinsic
def _call_number(_typing: Any, _code: Any, _block: Any) -> Any:
    def lower(_context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        return _result(builder, values, ir.IntType(64))

    return _WORD(_WORD, _WORD), lower


@intrinsic
def _call_truth(_typing: Any, _code: Any, _block: Any) -> Any:
    def lower(_context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        byte = _result(builder, values, ir.IntType(8))
        return builder.icmp_unsigned("!=", byte, ir.Constant(byte.type, 0))

    return types.boolean(_WORD, _WORD), lower


@intrinsic
def _call_nothing(_typing: Any, _code: Any, _block: Any) -> Any:
    def lower(context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        _result(builder, values, ir.VoidType())
        return context.get_dummy_value()

    return types.void(_WORD, _WORD), lower


_INSTRUCTIONS: dict[str, Any] = {
    "call_number": _call_number,
    "call_truth": _call_truth,
    "call_nothing": _call_nothing,
}
cpu_target.typing_context.refresh()  # a function may be under way, at whose beginning these were not known


def instruction_type(name: str) -> Any:
    """What numba knows a function of `_calls.py` by."""
    return cpu_target.typing_context.resolve_value_type(_INSTRUCTIONS[name])
