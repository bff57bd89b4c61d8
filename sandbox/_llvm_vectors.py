"""Vectors of four numbers as numba and LLVM have them, cut into registers as long as the machine has them.

`load` and `store` alone touch memory: LLVM need not prove anything to keep four numbers together, as it must for a loop
over lanes.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir
from numba import types
from numba.core.cgutils import get_or_insert_function
from numba.core.registry import cpu_target
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model

from sandbox._llvm_aliasing import of_any_type
from sandbox._plain_vectors import WIDTH

_FLOATS = ir.VectorType(ir.DoubleType(), WIDTH)
_BITS = ir.VectorType(ir.IntType(1), WIDTH)
_INDEX = ir.IntType(32)


class _VectorType(types.Type):
    """numba's name for a `Vector`."""


class _MaskType(types.Type):
    """numba's name for a `Mask`."""


_VECTOR = _VectorType("Vector")
_MASK = _MaskType("Mask")
_FLOAT = types.float64


@register_model(_VectorType)
class _VectorModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _FLOATS)


@register_model(_MaskType)
class _MaskModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _BITS)


def _spread_over(builder: Any, number: Any) -> Any:
    """A vector with the same number in every lane."""
    one = builder.insert_element(ir.Constant(_FLOATS, ir.Undefined), number, ir.Constant(_INDEX, 0))
    return builder.shuffle_vector(one, one, ir.Constant(ir.VectorType(_INDEX, WIDTH), [0] * WIDTH))


def _as_vectors(builder: Any, kinds: Sequence[Any], values: Sequence[Any]) -> list[Any]:
    return [_spread_over(builder, v) if kind == _FLOAT else v for kind, v in zip(kinds, values, strict=True)]


def _teach(function: Any, result: Any, signatures: Sequence[tuple[Any, ...]], emit: Callable[..., Any]) -> None:
    """Tell numba what an operator gives for operands of such types, and by which instruction."""

    def lower(_context: Any, builder: Any, sig: Any, values: Any) -> Any:
        return emit(builder, *_as_vectors(builder, sig.args, values))

    cases = [signature(result, *operands) for operands in signatures]
    infer_global(function)(type(f"_{function.__name__}", (ConcreteTemplate,), {"cases": cases}))
    for operands in signatures:
        lower_builtin(function, *operands)(lower)


def teach_operators() -> None:
    """Tell numba about operators on vectors and masks; before it compiles, for only then does it look for new ones."""
    pairs = [(_VECTOR, _VECTOR), (_VECTOR, _FLOAT), (_FLOAT, _VECTOR)]
    _teach(operator.add, _VECTOR, pairs, lambda builder, a, b: builder.fadd(a, b))
    _teach(operator.sub, _VECTOR, pairs, lambda builder, a, b: builder.fsub(a, b))
    _teach(operator.mul, _VECTOR, pairs, lambda builder, a, b: builder.fmul(a, b))
    _teach(operator.truediv, _VECTOR, pairs, lambda builder, a, b: builder.fdiv(a, b))
    _teach(operator.neg, _VECTOR, [(_VECTOR,)], lambda builder, a: builder.fneg(a))
    _teach(operator.lt, _MASK, pairs, lambda builder, a, b: builder.fcmp_ordered("<", a, b))
    _teach(operator.le, _MASK, pairs, lambda builder, a, b: builder.fcmp_ordered("<=", a, b))
    _teach(operator.gt, _MASK, pairs, lambda builder, a, b: builder.fcmp_ordered(">", a, b))
    _teach(operator.ge, _MASK, pairs, lambda builder, a, b: builder.fcmp_ordered(">=", a, b))
    _teach(operator.eq, _MASK, pairs, lambda builder, a, b: builder.fcmp_ordered("==", a, b))
    _teach(operator.ne, _MASK, pairs, lambda builder, a, b: builder.fcmp_unordered("!=", a, b))
    _teach(operator.and_, _MASK, [(_MASK, _MASK)], lambda builder, a, b: builder.and_(a, b))
    _teach(operator.or_, _MASK, [(_MASK, _MASK)], lambda builder, a, b: builder.or_(a, b))
    _teach(operator.invert, _MASK, [(_MASK,)], lambda builder, a: builder.not_(a))


def _place(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    """Pointer to the vector that begins at a place of an array."""
    array = context.make_array(sig.args[0])(context, builder, values[0])
    return builder.bitcast(builder.gep(array.data, [values[1]]), _FLOATS.as_pointer())


@intrinsic
def _load(_typing: Any, values: Any, _at: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, arguments: Any) -> Any:
        return builder.load(_place(context, builder, sig, arguments), align=8)

    return _VECTOR(values, types.int64), lower


@intrinsic
def _store(_typing: Any, values: Any, _at: Any, _vector: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, arguments: Any) -> Any:
        builder.store(arguments[2], _place(context, builder, sig, arguments), align=8)
        return context.get_dummy_value()

    return types.void(values, types.int64, _VECTOR), lower


def _fields(context: Any, builder: Any, sig: Any, values: Any) -> Any:
    """Pointer to the vector of the fields of a row that begin with the one of a number."""
    words = ir.IntType(64)
    array = context.make_array(sig.args[0])(context, builder, values[0])
    word = builder.mul(values[1], ir.Constant(words, sig.args[0].dtype.size // 8))
    floats = builder.bitcast(array.data, ir.DoubleType().as_pointer())
    return builder.bitcast(builder.gep(floats, [builder.add(word, values[2])]), _FLOATS.as_pointer())


@intrinsic
def _load_fields(_typing: Any, table: Any, _row: Any, _first: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        return of_any_type(builder.module, builder.load(_fields(context, builder, sig, values), align=8))

    return _VECTOR(table, types.int64, types.int64), lower


@intrinsic
def _store_fields(_typing: Any, table: Any, _row: Any, _first: Any, _vector: Any) -> Any:
    def lower(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        of_any_type(builder.module, builder.store(values[3], _fields(context, builder, sig, values), align=8))
        return context.get_dummy_value()

    return types.void(table, types.int64, types.int64, _VECTOR), lower


_NUMBERS_OF_PAIRS = ([0, 4, 2, 6], [1, 5, 3, 7])
_HALVES = ([0, 1, 4, 5], [2, 3, 6, 7])


@intrinsic
def _transpose(_typing: Any, _a: Any, _b: Any, _c: Any, _d: Any) -> Any:
    result = types.UniTuple(_VECTOR, WIDTH)

    def lower(context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        def shuffled(one: Any, other: Any, order: list[int]) -> Any:
            return builder.shuffle_vector(one, other, ir.Constant(ir.VectorType(_INDEX, WIDTH), order))

        upper = [shuffled(values[0], values[1], order) for order in _NUMBERS_OF_PAIRS]
        lower = [shuffled(values[2], values[3], order) for order in _NUMBERS_OF_PAIRS]
        columns = [shuffled(upper[k], lower[k], order) for order in _HALVES for k in range(2)]
        return context.make_tuple(builder, result, columns)

    return result(_VECTOR, _VECTOR, _VECTOR, _VECTOR), lower


@intrinsic
def _lane_numbers(_typing: Any) -> Any:
    return _VECTOR(), lambda _context, _builder, _sig, _values: ir.Constant(_FLOATS, [float(k) for k in range(WIDTH)])


@intrinsic
def _lanes(_typing: Any, _vector: Any) -> Any:
    result = types.UniTuple(_FLOAT, WIDTH)

    def lower(context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        numbers = [builder.extract_element(values[0], ir.Constant(_INDEX, k)) for k in range(WIDTH)]
        return context.make_tuple(builder, result, numbers)

    return result(_VECTOR), lower


@intrinsic
def _spread(_typing: Any, _number: Any) -> Any:
    return _VECTOR(_FLOAT), lambda _context, builder, _sig, values: _spread_over(builder, values[0])


@intrinsic
def _select(_typing: Any, truth: Any, one: Any, other: Any) -> Any:
    kinds = [_VECTOR if kind == _VECTOR else _FLOAT for kind in (one, other)]

    def lower(_context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        pair = _as_vectors(builder, kinds, values[1:]) if truth == _MASK else values[1:]
        return builder.select(values[0], *pair)

    return (_VECTOR if truth == _MASK else _FLOAT)(truth, *kinds), lower


@intrinsic
def _any_lane(_typing: Any, truth: Any) -> Any:
    def lower(_context: Any, builder: Any, _sig: Any, values: Any) -> Any:
        if truth != _MASK:
            return values[0]
        bits = builder.bitcast(values[0], ir.IntType(WIDTH))
        return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))

    return types.boolean(truth), lower


def _by_name(name: str) -> Any:
    """An intrinsic of LLVM on one number, of the same name for vectors."""

    @intrinsic
    def apply(_typing: Any, number: Any) -> Any:
        kind = number if number == _VECTOR else _FLOAT

        def lower(_context: Any, builder: Any, _sig: Any, values: Any) -> Any:
            shape = values[0].type
            full = f"{name}.v{WIDTH}f64" if shape == _FLOATS else f"{name}.f64"
            function = get_or_insert_function(builder.module, ir.FunctionType(shape, [shape]), full)
            return builder.call(function, values)

        return kind(kind), lower

    return apply


_INSTRUCTIONS: dict[str, Any] = {
    "load": _load,
    "store": _store,
    "load_fields": _load_fields,
    "store_fields": _store_fields,
    "transpose": _transpose,
    "lane_numbers": _lane_numbers,
    "lanes": _lanes,
    "spread": _spread,
    "select": _select,
    "any_lane": _any_lane,
    "absolute": _by_name("llvm.fabs"),
    "root": _by_name("llvm.sqrt"),
}


def instruction_type(name: str) -> Any:
    """What numba knows a function of `_vectors.py` by."""
    return cpu_target.typing_context.resolve_value_type(_INSTRUCTIONS[name])
