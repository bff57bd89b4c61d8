"""The function through which Python enters machine code: it unpacks a block of words and calls an entry point.

What lies where in a block is told by `_machine_code.py` and `_argument_words.py`, which fill it.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types as _types

from sandbox._argument_words import FLOAT, INTEGER
from sandbox._llvm_bundles import BundleType
from sandbox._llvm_words import DOUBLE, WORD, Words, number, word_count
from sandbox._machine_code import ENTER, NOTHING, TRUTH, Returns

types: Any = _types
_RESULTS = {INTEGER: WORD, FLOAT: DOUBLE, TRUTH: ir.IntType(8), NOTHING: ir.VoidType()}


def way_in(library: Any, compiled: Any) -> tuple[Any, Returns]:
    """A module with the function, for what numba has compiled, and what it returns."""
    context, signature = compiled.target_context, compiled.signature
    returns = _returns(signature.return_type)
    module = library.create_ir_module("way_in")
    _define_parts_of_floats(module)
    result = ir.VoidType() if isinstance(returns, list) else _RESULTS[returns]
    function = ir.Function(module, ir.FunctionType(result, [WORD.as_pointer()]), ENTER)
    builder = ir.IRBuilder(function.append_basic_block())
    words = Words(context, builder, function.args[0])
    if isinstance(returns, list):  # results lie before arguments
        words.skip(word_count(signature.return_type))
    arguments = [_argument(context, builder, words, each) for each in signature.args]
    entry = context.declare_function(module, compiled.fndesc)
    status, value = context.call_conv.call_function(builder, entry, signature.return_type, signature.args, arguments)
    with builder.if_then(status.is_error, likely=False):
        context.get_python_api(builder).err_set_string("PyExc_RuntimeError", "a kernel has failed")
    if isinstance(returns, list):
        Words(context, builder, function.args[0]).write(signature.return_type, value)
        builder.ret_void()
    elif returns == NOTHING:
        builder.ret_void()
    else:
        builder.ret(number(builder, signature.return_type, value, _RESULTS[returns]))
    return module, returns


def _argument(context: Any, builder: Any, words: Words, kind: Any) -> Any:
    """The next argument, of a type of numba's: what is in a tuple lies in a bundle, whose address is here."""
    if isinstance(kind, (BundleType, types.BaseTuple)):
        bundle = builder.inttoptr(builder.load(words.place()), WORD.as_pointer())
        return bundle if isinstance(kind, BundleType) else Words(context, builder, bundle).read(kind)
    return words.read(kind)


def _define_parts_of_floats(module: Any) -> None:
    """What numba calls for `math.frexp` and `math.ldexp`: the C library's, which is not held to zero and infinities."""
    small = ir.IntType(32)
    for name, exponent in (("frexp", small.as_pointer()), ("ldexp", small)):
        sort = ir.FunctionType(DOUBLE, [DOUBLE, exponent])
        function = ir.Function(module, sort, f"numba_{name}")
        number, other = function.args
        builder = ir.IRBuilder(function.append_basic_block())
        nought = ir.Constant(DOUBLE, 0.0)
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
