"""Machine code that was made earlier, and how Python calls it: by LLVM alone, for numba takes half a second to load.

Every object has one function, `ENTER`, made by `_linking.py`. It takes the address of a block of 64-bit words: the
arguments, one after another, each flattened (`_words`), behind the room for what it returns if that is a tuple. A block
is filled once for arguments that stay, so that a call costs no more than handing over one number.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, TypeAlias

import numpy as np

from sandbox._object_file import is_whole

ENTER = "enter"
Returns: TypeAlias = Any
"""What a function returns: one of the letters below, or a list of such for a tuple."""
INTEGER, FLOAT, TRUTH, NOTHING = "q", "d", "?", "n"
_RESULTS = {INTEGER: ctypes.c_int64, FLOAT: ctypes.c_double, TRUTH: ctypes.c_bool, NOTHING: None}


def is_usable(returns: Any, code: bytes) -> bool:
    """Whether `Version` can be made of what was kept: LLVM takes the process down with it if it cannot."""
    return _is_returns(returns) and is_whole(code)


def _is_returns(value: Any) -> bool:
    return all(map(_is_returns, value)) if isinstance(value, list) else isinstance(value, str) and value in _RESULTS


class Version:
    """The machine code of an entry point for arguments of one kind."""

    def __init__(self, code: bytes, returns: Returns) -> None:
        self._engine = _engine(code)
        self._returns = returns
        self._results = "".join(_letters(returns)) if isinstance(returns, list) else ""
        result = None if self._results else _RESULTS[returns]
        self.address: int = self._engine.get_function_address(ENTER)
        self.enter: Callable[[int], Any] = ctypes.PYFUNCTYPE(result, ctypes.c_void_p)(self.address)
        self.enter_unlocked: Callable[[int], Any] = ctypes.CFUNCTYPE(result, ctypes.c_void_p)(self.address)
        """The same, without the lock of the interpreter: other threads run meanwhile."""

    def block(self, arguments: tuple[Any, ...]) -> Block:
        """A block for arguments of the kind that this is for."""
        return Block(self._results, self._returns, arguments)


class Block:
    """What `Version.enter` is called with: give it `address`, and take `result` of what it gives back.

    Arrays among the arguments are kept alive; the block follows what is written to them.
    """

    __slots__ = ("_arguments", "_fields", "_memory", "_parts", "_results", "_returns", "address")

    def __init__(self, results: str, returns: Returns, arguments: tuple[Any, ...]) -> None:
        self._returns, self._results = returns, struct.Struct(f"={results.replace('?', 'q')}")
        self._fields: list[list[tuple[int, struct.Struct]]] = []
        end = self._results.size
        for each in arguments:
            fields = [struct.Struct("=" + _format(part)) for part in _parts(each)]
            self._fields.append([])
            for field in fields:
                self._fields[-1].append((end, field))
                end += field.size
        self._memory = ctypes.create_string_buffer(end + 1)
        self.address = ctypes.addressof(self._memory)
        self._arguments: tuple[Any, ...] = (_NONE,) * len(arguments)
        self._parts: list[list[Any]] = [[_NONE] * len(fields) for fields in self._fields]
        self.fill(arguments)

    @property
    def returns_tuple(self) -> bool:
        """Whether `result` has more to do than to give back what it gets."""
        return isinstance(self._returns, list)

    def fill(self, arguments: tuple[Any, ...]) -> None:
        """Take other arguments of the same kind. Those that are the same objects as before cost nothing, and of tuples
        only what is another object is filled in."""
        for k, each in enumerate(arguments):
            if each is not self._arguments[k]:
                parts = _parts(each)
                for part, before, (offset, field) in zip(parts, self._parts[k], self._fields[k], strict=True):
                    if part is not before:
                        field.pack_into(self._memory, offset, *_words(part))
                self._parts[k] = parts
        self._arguments = arguments

    def result(self, returned: Any) -> Any:
        """What the function returns, after `enter` has given back `returned`."""
        if not self.returns_tuple:
            return returned
        return _tuple_of(self._returns, iter(self._results.unpack_from(self._memory)))


_NONE = object()


def _parts(argument: Any) -> list[Any]:
    """What is in an argument: in a tuple all that is in its items."""
    if not isinstance(argument, tuple):
        return [argument]
    found: list[Any] = []
    for each in argument:
        if isinstance(each, tuple):
            found += _parts(each)
        else:
            found.append(each)
    return found


def _words(value: Any) -> tuple[Any, ...]:
    """The words of what is no tuple: of an array the address, the shape and the strides in bytes; of a row the address.

    `__array_interface__` has the address too, but describes all columns before it tells it, which takes 30 us.
    """
    if isinstance(value, np.ndarray):
        return (value.ctypes.data, *value.shape, *value.strides)
    if isinstance(value, np.void):
        return (np.frombuffer(value, np.uint8).ctypes.data,)
    if isinstance(value, np.bool_):
        return (int(value),)
    return () if value is None else (value,)


def _format(value: Any) -> str:
    """The letters of `struct` for the words of what is no tuple."""
    if isinstance(value, np.ndarray):
        return (1 + 2 * value.ndim) * INTEGER
    if isinstance(value, (float, np.floating)):
        return FLOAT
    if isinstance(value, (int, np.integer, np.bool_, np.void)):
        return INTEGER
    if value is None:
        return ""
    raise TypeError(f"an entry point takes numbers, arrays, rows and tuples of them, no {type(value).__name__}")


def _letters(returns: Returns) -> Iterator[str]:
    """What takes a word of a tuple that is returned."""
    if isinstance(returns, list):
        for each in returns:
            yield from _letters(each)
    elif returns != NOTHING:
        yield returns


def _tuple_of(returns: Returns, words: Iterator[Any]) -> Any:
    if isinstance(returns, list):
        return tuple(_tuple_of(each, words) for each in returns)
    if returns == NOTHING:
        return None
    word = next(words)
    return bool(word) if returns == TRUTH else word


@cache
def _target() -> Any:
    from llvmlite import binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_triple(llvm.get_process_triple())


def _engine(code: bytes) -> Any:
    """An engine of LLVM's for each object, as objects may have functions of the same name."""
    target = _target()
    from llvmlite import binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target.create_target_machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine
