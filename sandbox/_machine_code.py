"""Machine code that was made earlier, and how Python calls it: by LLVM alone, for numba takes half a second to load.

Every object has one function, `ENTER`, made by `_linking.py`. It takes the address of a block of 64-bit words: the
arguments, one after another (`_argument_words.py`), behind the room for what it returns if that is a tuple. A block is
filled once for arguments that stay, so that a call costs no more than handing over one number.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, TypeAlias

from sandbox._argument_words import FLOAT, INTEGER, Bundle, word_format, words
from sandbox._object_file import is_whole

ENTER = "enter"
Returns: TypeAlias = Any
"""What a function returns: one of the letters below, or a list of such for a tuple."""
TRUTH, NOTHING = "?", "n"
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

    __slots__ = ("_arguments", "_bundles", "_fields", "_memory", "_results", "_returns", "address")

    def __init__(self, results: str, returns: Returns, arguments: tuple[Any, ...]) -> None:
        self._returns, self._results = returns, struct.Struct(f"={results.replace('?', 'q')}")
        self._fields: list[tuple[int, struct.Struct]] = []
        self._bundles = [Bundle(each) if isinstance(each, tuple) else None for each in arguments]
        end = self._results.size
        for each in arguments:
            field = struct.Struct("=" + (INTEGER if isinstance(each, (tuple, Bundle)) else word_format(each)))
            self._fields.append((end, field))
            end += field.size
        self._memory = ctypes.create_string_buffer(end + 1)
        self.address = ctypes.addressof(self._memory)
        self._arguments: tuple[Any, ...] = (_NONE,) * len(arguments)
        for each, own, (offset, field) in zip(arguments, self._bundles, self._fields, strict=True):
            bundle = each if isinstance(each, Bundle) else own
            if bundle is not None:
                field.pack_into(self._memory, offset, bundle.address)
        self.fill(arguments)

    @property
    def returns_tuple(self) -> bool:
        """Whether `result` has more to do than to give back what it gets."""
        return isinstance(self._returns, list)

    def fill(self, arguments: tuple[Any, ...]) -> None:
        """Take other arguments of the same kind. Those that are the same objects as before cost nothing, and of tuples
        only what is another object is filled in. A `Bundle` stays where it was, and is filled by whoever made it."""
        for k, each in enumerate(arguments):
            if each is self._arguments[k] or isinstance(each, Bundle):
                continue
            own = self._bundles[k]
            if own is not None:
                own.fill(each)
            else:
                offset, field = self._fields[k]
                field.pack_into(self._memory, offset, *words(each))
        self._arguments = arguments

    def result(self, returned: Any) -> Any:
        """What the function returns, after `enter` has given back `returned`."""
        if not self.returns_tuple:
            return returned
        return _tuple_of(self._returns, iter(self._results.unpack_from(self._memory)))


_NONE = object()


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
