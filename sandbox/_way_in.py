"""The function through which Python enters machine code: it unpacks a block of words and calls an entry point.

What lies where in a block is told by `_machine_code.py` and `_argument_words.py`, which fill it. How numba passes
numbers, arrays and tuples is asked of numba itself (its data models and calling convention), not repeated here.
https://numba.readthedocs.io/en/stable/developer/architecture.html
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types as _types
from numba.np.arrayobj import get_itemsize, populate_array

from sandbox._argument_words import FLOAT, INTEGER
from sandbox._machine_code import ENTER, NOTHING, TRUTH, Returns

types: Any = _types
_WORD, _DOUBLE = ir.IntType(64), ir.DoubleType()
_RESULTS = {INTEGER: _WORD, FLOAT: _DOUBLE, TRUTH: ir.IntType(8), NOTHING: ir.VoidType()}


def way_in(library: Any, compiled: Any) -> tuple[Any, Returns]:
    """A module with the function, for what numba has compiled, and what it returns."""
    context, signature = compiled.target_context, compiled.signature
    returns = _returns(signature.return_type)
    module = library.create_ir_module("way_in")
    _define_parts_of_floats(module)
    result = ir.VoidType() if isinstance(returns, list) else _RESULTS[returns]
    function = ir.Function(module, ir.FunctionType(result, [_WORD.as_pointer()]), ENTER)
    builder = ir.IRBuilder(function.append_basic_block())
    block = _Block(context, builder, function.args[0])
    words = _Block(context, builder, function.args[0])  # results lie before arguments
    if isinstance(returns, list):
        words.skip(signature.return_type)
    arguments = [words.argument(each) for each in signature.args]
    entry = context.declare_function(module, compiled.fndesc)
    status, value = context.call_conv.call_function(builder, entry, signature.return_type, signature.args, arguments)
    with builder.if_then(status.is_error, likely=False):
        context.get_python_api(builder).err_set_string("PyExc_RuntimeError", "a kernel has failed")
    if isinstance(returns, list):
        block.write(signature.return_type, value)
        builder.ret_void()
    elif returns == NOTHING:
        builder.ret_void()
    else:
        builder.ret(_number(builder, signature.return_type, value, _RESULTS[returns]))
    return module, returns


def _define_parts_of_floats(module: Any) -> None:
    """What numba calls for `math.frexp` and `math.ldexp`: the C library's, which is not held to zero and infinities."""
    small = ir.IntType(32)
    for name, exponent in (("frexp", small.as_pointer()), ("ldexp", small)):
        sort = ir.FunctionType(_DOUBLE, [_DOUBLE, exponent])
        function = ir.Function(module, sort, f"numba_{name}")
        number, other = function.args
        builder = ir.IRBuilder(function.append_basic_block())
        nought = ir.Constant(_DOUBLE, 0.0)
        finite = builder.fcmp_ordered("==", builder.fsub(number, number), nought)
        with builder.if_then(builder.and_(finite, builder.fcmp_ordered("!=", number, nought))):
            builder.ret(builder.call(ir.Function(module, sort, name), [number, other]))
        if name == "frexp":
            builder.store(ir.Constant(small, 0), other)
        builder.ret(number)


def _returns(kind: Any) -> Returns:
    """The letters for a type that is returned."""
    if isinstance(kind, types.BaseTuple):
        return [_returns(each) for each in kind.types]
    for letter, sort in ((TRUTH, types.Boolean), (INTEGER, types.Integer), (FLOAT, types.Float)):
        if isinstance(kind, sort):
            return letter
    if isinstance(kind, types.NoneType):
        return NOTHING
    raise TypeError(f"an entry point returns numbers and tuples of them, no {kind}")


def _number(builder: Any, kind: Any, value: Any, wanted: Any) -> Any:
    """A number as a word, a double or a byte."""
    if isinstance(kind, types.Float):
        return value if value.type == wanted else builder.fpext(value, wanted)
    if value.type == wanted:
        return value
    return builder.sext(value, wanted) if getattr(kind, "signed", False) else builder.zext(value, wanted)


class _Block:
    """Reads or writes the words of a block, one after another."""

    def __init__(self, context: Any, builder: Any, pointer: Any) -> None:
        self._context, self._builder, self._pointer = context, builder, pointer
        self._next = 0

    def argument(self, kind: Any) -> Any:
        """The next argument, of a type of numba's: what is in a tuple lies in a bundle, whose address is here."""
        if not isinstance(kind, types.BaseTuple):
            return self.read(kind)
        bundle = self._builder.inttoptr(self._builder.load(self._word()), _WORD.as_pointer())
        return _Block(self._context, self._builder, bundle).read(kind)

    def read(self, kind: Any) -> Any:
        """The next value, of a type of numba's."""
        if isinstance(kind, types.Array):
            return self._array(kind)
        if isinstance(kind, types.BaseTuple):
            return self._context.make_tuple(self._builder, kind, [self.read(each) for each in kind.types])
        if isinstance(kind, types.NoneType):
            return self._context.get_dummy_value()
        if isinstance(kind, types.Record):
            row = self._builder.load(self._word())
            return self._builder.inttoptr(row, self._context.get_value_type(kind))
        return self._number(kind)

    def write(self, kind: Any, value: Any) -> None:
        """Write a value that is returned."""
        if isinstance(kind, types.BaseTuple):
            for k, each in enumerate(kind.types):
                self.write(each, self._builder.extract_value(value, k))
        elif not isinstance(kind, types.NoneType):
            number = _number(self._builder, kind, value, _DOUBLE if isinstance(kind, types.Float) else _WORD)
            at = self._word()
            self._builder.store(number, self._builder.bitcast(at, number.type.as_pointer()))

    def skip(self, kind: Any) -> None:
        """Pass over as many words as `write` takes for a type."""
        if isinstance(kind, types.BaseTuple):
            for each in kind.types:
                self.skip(each)
        elif not isinstance(kind, types.NoneType):
            self._next += 1

    def _word(self) -> Any:
        self._next += 1
        return self._builder.gep(self._pointer, [_WORD(self._next - 1)])

    def _array(self, kind: Any) -> Any:
        context, builder = self._context, self._builder
        array = context.make_array(kind)(context, builder)
        data = builder.inttoptr(builder.load(self._word()), array.data.type)
        shape, strides = ([builder.load(self._word()) for _ in range(kind.ndim)] for _ in range(2))
        populate_array(array, data, shape, strides, context.get_constant(types.intp, get_itemsize(context, kind)), None)
        return array._getvalue()

    def _number(self, kind: Any) -> Any:
        builder = self._builder
        if isinstance(kind, types.Float):
            value = builder.load(builder.bitcast(self._word(), _DOUBLE.as_pointer()))
        else:
            value = builder.load(self._word())
        if isinstance(kind, types.Boolean):
            return builder.icmp_unsigned("!=", value, _WORD(0))
        wanted = self._context.get_value_type(kind)
        if value.type == wanted:
            return value
        return builder.fptrunc(value, wanted) if isinstance(kind, types.Float) else builder.trunc(value, wanted)
