"""How kernels are marked, and how Python calls their machine code.

`kernel` marks a function that other kernels call; `entry_point` marks one that Python calls, whose machine code is
kept on disk (`_kernel_cache.py`). numba makes it (`_linking.py`) and is not even imported where it has been made
already (`_machine_code.py`).

Flags are fixed: no fastmath, no parallel, IEEE division. `NUMBA_DISABLE_JIT=1` runs the same functions as Python,
and the determinism contract asks for the same bits.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar, cast

import numpy as np

from sandbox import _compiling
from sandbox._argument_words import unbundled
from sandbox._calls import handle
from sandbox._kernel_cache import is_filled, kept_file
from sandbox._kernel_cache import read as read_kept
from sandbox._kernel_cache import write as write_kept
from sandbox._machine_code import Block, Version, is_usable
from sandbox._plain_rows import plain_rows

F = TypeVar("F", bound=Callable[..., Any])

_DISABLED = os.environ.get("NUMBA_DISABLE_JIT", "0").strip() not in ("", "0")
further: list[Callable[[Any, tuple[Any, ...], Path | None], None]] = []
"""Called with the dispatcher, the arguments and the file of what has just been compiled, which is kept there."""
_base_of: Callable[[Any], Any] = np.ndarray.base.__get__
# Record arrays look through their columns for every attribute first.


def kernel(function: F) -> F:
    """Compile `function` for use by other kernels. The same bits as plain Python, only faster."""
    return function if _DISABLED else cast(F, Kernel(function))


def inlined_kernel(function: F) -> F:
    """A `kernel` that is always inlined: for short functions called in the innermost loops with many arrays."""
    return function if _DISABLED else cast(F, Kernel(function, forceinline=True))


def entry_point(function: F) -> F:
    """Compile `function` for calls from Python and keep its machine code in the cache folder."""
    return function if _DISABLED else cast(F, EntryPoint(function))


class Kernel:
    """A function that is compiled with the entry points that call it."""

    def __init__(self, function: Callable[..., Any], **flags: Any) -> None:
        functools.update_wrapper(cast(Any, self), function)
        self.py_func = function
        self._flags = flags

    @functools.cached_property
    def dispatcher(self) -> Any:
        """The function as numba knows it, made when something is compiled that needs it."""
        from sandbox._linking import dispatcher

        return dispatcher(self.py_func, **self._flags)

    @property
    def _numba_type_(self) -> Any:
        """What numba asks of an object that a kernel mentions."""
        return self.dispatcher._numba_type_


class EntryPoint(Kernel):
    """A function that Python calls. A `Door` or a `Call` is faster where it is called often."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._versions: dict[tuple[Any, ...], Version] = {}
        self._making = threading.RLock()
        """Held while machine code is looked for: two threads that made the same would drop what one of them runs."""

    def __call__(self, *arguments: Any) -> Any:
        version = self.version(arguments)
        block = version.block(arguments)
        return block.result(version.enter(block.address))

    def version(self, arguments: tuple[Any, ...]) -> Version:
        """The machine code for arguments of these types: from memory, from disk or made now, which takes seconds."""
        kinds = tuple(map(_kind, arguments))
        if kinds not in self._versions:
            _compiling.patiently(lambda: self._make(kinds, arguments))
        return self._versions[kinds]

    def found(self, arguments: tuple[Any, ...]) -> Version | None:
        """The same, but None if it is to be made."""
        kinds = tuple(map(_kind, arguments))
        with self._making:
            if kinds not in self._versions:
                self._read(kinds)
            return self._versions.get(kinds)

    def _make(self, kinds: tuple[Any, ...], arguments: tuple[Any, ...]) -> None:
        with self._making:
            if kinds in self._versions or self._read(kinds):
                return
            from sandbox._linking import machine_code

            file = kept_file(cast(Any, self.py_func), kinds)
            with _compiling.compiling(self):
                returns, code = machine_code(self.dispatcher, arguments)
                write_kept(file, returns, code)
                for each in further:
                    each(self.dispatcher, arguments, file)
            self._versions[kinds] = Version(code, returns)

    def _read(self, kinds: tuple[Any, ...]) -> bool:
        """Take machine code from disk; returns whether it was there."""
        kept = read_kept(kept_file(cast(Any, self.py_func), kinds))
        if kept is None or not is_usable(*kept):
            return False
        returns, code = kept
        self._versions[kinds] = Version(code, returns)
        return True


class Door:
    """An entry point for calls whose arguments always have the same types.

    To find which version of the machine code fits the arguments takes 1 us an array, as long as a step of a small
    scene. Here it is asked at the first call only, and compiled then if need be; what is passed again and again is
    laid out once.
    """

    __slots__ = ("_block", "_enter", "_entry")

    def __init__(self, entry: Callable[..., Any]) -> None:
        self._entry = entry
        self._block: Block | None = None
        self._enter: Callable[[int], Any]

    def __call__(self, *arguments: Any) -> Any:
        if self._block is None:
            if _DISABLED:
                return self._entry(*arguments)
            version = cast(EntryPoint, self._entry).version(arguments)
            self._block, self._enter = version.block(arguments), version.enter
        else:
            self._block.fill(arguments)
        return self._block.result(self._enter(self._block.address))


class Call:
    """An entry point with arguments for many calls, as by a `Door`. Those that are a `Bundle` follow what it is filled
    with.

    `unlocked` calls let other threads of Python run meanwhile.
    """

    __slots__ = ("__weakref__", "_arguments", "_block", "_call", "_code", "_enter", "_entry", "_unlocked", "_version")

    def __init__(self, entry: Callable[..., Any], arguments: tuple[Any, ...], unlocked: bool = False) -> None:
        self._entry, self._unlocked = entry, unlocked
        self._arguments = arguments
        self._call: Callable[..., Any] | None = None
        self._version: Version | None = None
        self._block: Block | None = None
        self._code = 0
        self._enter: Callable[[int], Any]

    def __call__(self) -> Any:
        return (self._call or self.bind())()

    def machine(self) -> tuple[int, int]:
        """The addresses of the machine code and of the block of arguments, for a kernel that calls it (`_calls.py`).

        The second holds until other arguments are taken, and both as long as this is there. Without the compiler a
        `handle` of this.
        """
        self.bind()
        return (self._code, self._block.address) if self._block is not None else (handle(self), 0)

    def weight_lacking(self) -> int:
        """The weight (`_compiling.py`) of what has to be compiled before this can be called; 0 if nothing."""
        if not _DISABLED and self._version is None:
            entry = cast(EntryPoint, self._entry)
            self._version = entry.found(tuple(map(unbundled, self._arguments)))
            if self._version is None:
                return _compiling.weight_of(entry)
        return 0

    def bind(self) -> Callable[..., Any]:
        """What this calls: machine code that is there, compiled now if need be."""
        if self._call is None:
            self._call = self._bound()
        return self._call

    def exchange(self, names: tuple[str, ...], others: Mapping[str, Any]) -> bool:
        """Take other arguments of the same types from now on, for those of its parameters that `others` has; returns
        whether some are others, so that it has to be bound again."""
        given = zip(names, self._arguments, strict=True)
        arguments = tuple([others.get(name, before) for name, before in given])
        same = all(each is before for each, before in zip(arguments, self._arguments, strict=True))
        if not same:
            self._arguments = arguments
            self._call = None
        return not same

    def _bound(self) -> Callable[..., Any]:
        if _DISABLED:
            return lambda: self._entry(*map(unbundled, self._arguments))
        if self._block is None:
            version = self._version or cast(EntryPoint, self._entry).version(tuple(map(unbundled, self._arguments)))
            self._version = version
            self._block = version.block(self._arguments)
            self._enter = version.enter_unlocked if self._unlocked else version.enter
            self._code = version.address
        else:
            self._block.fill(self._arguments)
        enter, address, result = self._enter, self._block.address, self._block.result
        if not self._block.returns_tuple:
            run = functools.partial(enter, address)
            run.block = self._block  # type: ignore[attr-defined]  # whose memory is there as long as this is
            return run
        return lambda: result(enter(address))


def _kind(value: Any) -> Any:
    """Equal for values of which numba says that they have the same type."""
    if isinstance(value, np.ndarray):
        flags = value.flags
        layout = "C" if flags.c_contiguous else "F" if flags.f_contiguous else "A"  # a table of one row is both: C
        return value.dtype, value.ndim, layout, flags.writeable, flags.aligned
    if isinstance(value, np.void):
        return type(value), value.dtype
    return (type(value), *map(_kind, value)) if isinstance(value, tuple) else type(value)


def interpreted(function: F) -> F:
    """The Python body of a kernel, for callers in Python, who cannot call the kernel itself; so for those it calls."""
    if not isinstance(function, Kernel):
        return function
    body = cast(FunctionType, function.py_func)
    known = body.__globals__
    called = {name: interpreted(known[name]) for name in body.__code__.co_names if isinstance(known.get(name), Kernel)}
    if not called:
        return cast(F, body)
    return cast(F, FunctionType(body.__code__, known | called, body.__name__, body.__defaults__, body.__closure__))


def kernel_argument(value: Any) -> Any:
    """What to pass to an entry point for an array, or for a tuple, plain or named, of arrays and such tuples.

    Compiled kernels take plain arrays. In Python they need `row.field`.
    """
    if isinstance(value, np.recarray):
        if _DISABLED:
            return plain_rows(value)
        base = _base_of(value)
        return np.asarray(value) if base is None else base  # a copy owns its memory
    if isinstance(value, tuple):
        return getattr(type(value), "_make", tuple)([kernel_argument(each) for each in value])
    return value


def jit_enabled() -> bool:
    """False when `NUMBA_DISABLE_JIT=1` runs kernels as Python."""
    return not _DISABLED


def cache_is_cold() -> bool:
    """True when the next step has to compile the kernels first (10 to 30 seconds)."""
    return jit_enabled() and not is_filled()
