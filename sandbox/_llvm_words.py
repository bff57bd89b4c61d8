"""Values of numba's types in words of memory, as `_argument_words.py` lays them out.

How numba passes numbers and arrays is asked of numba itself (its data models), not repeated here.
https://numba.readthedocs.io/en/stable/developer/architecture.html
"""

from __future__ import annotations

from functools import reduce
from typing import Any

from llvmlite import ir
from numba.core import types as _types
from numba.core.cgutils import pack_array
from numba.np.arrayobj import get_itemsize

types: Any = _types
WORD, DOUBLE = ir.IntType(64), ir.DoubleType()


def word_count(kind: Any) -> int:
    """How many words a value of a type takes."""
    if isinstance(kind, types.Array):
        return 1 + 2 * int(kind.ndim)
    if isinstance(kind, types.BaseTuple):
        return sum(map(word_count, kind.types))
    return 0 if isinstance(kind, types.NoneType) else 1


def number(builder: Any, kind: Any, value: Any, wanted: Any) -> Any:
    """A number as a word, a double or a byte."""
    if isinstance(kind, types.Float):
        return value if value.type == wanted else builder.fpext(value, wanted)
    if value.type == wanted:
        return value
    return builder.sext(value, wanted) if getattr(kind, "signed", False) else builder.zext(value, wanted)


class Words:
    """Reads or writes values one after another, from `pointer` on.

    What is `constant` is the same whenever machine code looks at it: LLVM reads it once, whatever is written between.
    """

    def __init__(self, context: Any, builder: Any, pointer: Any, constant: bool = False) -> None:
        self._context, self._builder, self._pointer = context, builder, pointer
        self._constant = constant
        self._next = 0

    def read(self, kind: Any) -> Any:
        """The next value, of a type of numba's."""
        if isinstance(kind, types.Array):
            return self._array(kind)
        if isinstance(kind, types.BaseTuple):
            return self._context.make_tuple(self._builder, kind, [self.read(each) for each in kind.types])
        if isinstance(kind, types.NoneType):
            return self._context.get_dummy_value()
        if isinstance(kind, types.Record):
            return self._load(self._context.get_value_type(kind))
        return self._number(kind)

    def write(self, kind: Any, value: Any) -> None:
        """Write a value."""
        if isinstance(kind, types.BaseTuple):
            for k, each in enumerate(kind.types):
                self.write(each, self._builder.extract_value(value, k))
        elif not isinstance(kind, types.NoneType):
            word = number(self._builder, kind, value, DOUBLE if isinstance(kind, types.Float) else WORD)
            self._builder.store(word, self._builder.bitcast(self.place(), word.type.as_pointer()))

    def skip(self, count: int) -> None:
        """Pass over some words."""
        self._next += count

    def place(self) -> Any:
        """Pointer to the next word, which is passed over."""
        self._next += 1
        return self._builder.gep(self._pointer, [WORD(self._next - 1)])

    def _load(self, kind: Any) -> Any:
        value = self._builder.load(self._builder.bitcast(self.place(), kind.as_pointer()))
        if self._constant:
            value.set_metadata("invariant.load", self._builder.module.add_metadata([]))
        return value

    def _array(self, kind: Any) -> Any:
        context, builder = self._context, self._builder
        model = context.data_model_manager[kind]
        members = dict(zip(model._fields, model.get_value_type().elements, strict=True))
        data = self._load(members["data"])
        shape, strides = ([self._load(WORD) for _ in range(kind.ndim)] for _ in range(2))
        nothing = {name: ir.Constant(members[name], None) for name in ("meminfo", "parent")}
        count = reduce(builder.mul, shape)
        sizes = {"nitems": count, "itemsize": WORD(get_itemsize(context, kind))}
        lengths = {"shape": pack_array(builder, shape), "strides": pack_array(builder, strides)}
        array = ir.Constant(model.get_value_type(), ir.Undefined)
        for name, value in (nothing | sizes | lengths | {"data": data}).items():
            array = builder.insert_value(array, value, model.get_field_position(name))
        return array

    def _number(self, kind: Any) -> Any:
        builder = self._builder
        value = self._load(DOUBLE if isinstance(kind, types.Float) else WORD)
        if isinstance(kind, types.Boolean):
            return builder.icmp_unsigned("!=", value, WORD(0))
        wanted = self._context.get_value_type(kind)
        if value.type == wanted:
            return value
        return builder.fptrunc(value, wanted) if isinstance(kind, types.Float) else builder.trunc(value, wanted)
