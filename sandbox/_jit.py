"""The only file, with `_linking.py`, that imports numba: how kernels are compiled and where the machine code is kept.

`kernel` marks a function that other kernels call; `entry_point` marks one that Python calls, whose machine code is
kept on disk. numba's own cache looks only at the file of the entry point, so the cache folder is named by a hash
of every kernel source: a change in any of them starts a new folder and never runs stale code.

Flags are fixed: no fastmath, no parallel, IEEE division. `NUMBA_DISABLE_JIT=1` runs the same functions as Python,
and the determinism contract asks for the same bits.
"""

from __future__ import annotations

import hashlib
import os
import platform
import shutil
import time
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
import numpy as np
from numba import njit
from numba.core import config as _config
from platformdirs import user_cache_path

from sandbox._linking import EntryPointCompiler, KernelCompiler, take_literals_as_values

config: Any = _config

F = TypeVar("F", bound=Callable[..., Any])

_ROOMS = (
    "_jit.py",
    "_linking.py",
    "tables.py",
    "geometry",
    "world/records.py",
    "world/joint_records.py",
    "world/field_records.py",
    "engine",
)
_base_of: Callable[[Any], Any] = np.ndarray.base.__get__
# Record arrays look through their columns for every attribute first.
_FLAGS: dict[str, Any] = {"error_model": "numpy", "boundscheck": False, "_nrt": False}
# Kernels allocate nothing, so numba's reference counting is off: its atomic counters around every call that takes an
# array cost more than the arithmetic (the grid ran 7 times slower with them).
_INNER: dict[str, Any] = _FLAGS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_STALE_SECONDS = 14 * 24 * 3600


def kernel(function: F) -> F:
    """Compile `function` for use by other kernels. The same bits as plain Python, only faster."""
    return cast(F, _compiled(function, KernelCompiler, **_INNER))


def inlined_kernel(function: F) -> F:
    """A `kernel` that is always inlined: for short functions called in the innermost loops with many arrays."""
    return cast(F, _compiled(function, KernelCompiler, **_INNER, forceinline=True))


def entry_point(function: F) -> F:
    """Compile `function` for calls from Python and keep its machine code in `cache_folder()`."""
    return cast(F, _compiled(function, EntryPointCompiler, **_FLAGS, cache=True))


def _compiled(function: Any, compiler: type, **flags: Any) -> Any:
    """`function` under numba, which is told here where its machine code is kept if it is."""
    if config.DISABLE_JIT:
        return function
    before = config.CACHE_DIR
    config.CACHE_DIR = str(cache_folder())
    try:
        dispatcher = njit(pipeline_class=compiler, **flags)(function)
    finally:
        config.CACHE_DIR = before
    take_literals_as_values(dispatcher)
    return dispatcher


class Door:
    """An entry point for calls whose arguments always have the same types.

    numba asks at every call which version of the machine code fits the arguments: 0.15 us an array, a tenth of the
    step of a small scene. Here it is asked at the first call only, and compiled then if need be.
    """

    __slots__ = ("_code", "_entry")

    def __init__(self, entry: Callable[..., Any]) -> None:
        self._entry = entry
        self._code: Callable[..., Any] | None = None

    def __call__(self, *arguments: Any) -> Any:
        if self._code is None:
            self._code = _machine_code(self._entry, arguments)
        return self._code(*arguments)


class Call:
    """An entry point with arguments for many calls, as by a `Door`."""

    __slots__ = ("_arguments", "_code", "_entry")

    def __init__(self, entry: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
        self._entry = entry
        self._arguments = arguments
        self._code: Callable[..., Any] | None = None

    def __call__(self) -> Any:
        if self._code is None:
            self._code = _machine_code(self._entry, self._arguments)
        return self._code(*self._arguments)

    def exchange(self, names: tuple[str, ...], others: Mapping[str, Any]) -> None:
        """Take other arguments of the same types from now on, for those of its parameters that `others` has."""
        arguments = list(self._arguments)
        for place, name in enumerate(names):
            if name in others:
                arguments[place] = others[name]
        self._arguments = tuple(arguments)


def _machine_code(entry: Any, arguments: tuple[Any, ...]) -> Callable[..., Any]:
    """The version of an entry point for arguments of these types."""
    if config.DISABLE_JIT:
        return cast(Callable[..., Any], entry)
    key = (entry, *map(_kind, arguments))
    if key not in _versions:
        _versions[key] = entry.compile(tuple(entry.typeof_pyval(argument) for argument in arguments))
    return _versions[key]


_versions: dict[tuple[Any, ...], Callable[..., Any]] = {}
# Every world asks for the same few versions. For numba to tell the types of all its tables takes longer than 30 steps.


def _kind(value: Any) -> Any:
    """Equal for values of which numba says that they have the same type."""
    if isinstance(value, np.ndarray):
        flags = value.flags
        return value.dtype, value.ndim, flags.c_contiguous, flags.f_contiguous, flags.writeable, flags.aligned
    return (type(value), *map(_kind, value)) if isinstance(value, tuple) else type(value)


def interpreted(function: F) -> F:
    """The Python body of a kernel, for callers in Python: calling the kernel itself would compile it for them alone.

    Only for kernels that call no other kernel.
    """
    return cast(F, getattr(function, "py_func", function))


def kernel_argument(value: Any) -> Any:
    """What to pass to an entry point for an array, or for a tuple, plain or named, of arrays and such tuples.

    Calls with a plain array are 20 times faster than with a recarray. Without the compiler, kernels need the recarray,
    for `row.field`.
    """
    if isinstance(value, np.recarray):
        return value if config.DISABLE_JIT else _base_of(value)
    if isinstance(value, tuple):
        return getattr(type(value), "_make", tuple)([kernel_argument(each) for each in value])
    return value


def jit_enabled() -> bool:
    """False when `NUMBA_DISABLE_JIT=1` runs kernels as Python."""
    return not config.DISABLE_JIT


def cache_is_cold() -> bool:
    """True when the next step has to compile the kernels first (20 to 40 seconds)."""
    return jit_enabled() and next(cache_folder().rglob("step.*.nbi"), None) is None


@cache
def cache_folder() -> Path:
    """Where compiled kernels are kept: in `cache_root()`, named by the sources."""
    base = cache_root() / "kernels"
    folder = base / f"{sources_hash()}-numba{numba.__version__}"
    folder.mkdir(parents=True, exist_ok=True)
    _forget_old_folders(base, folder)
    return folder


def cache_root() -> Path:
    """The folder for all that this package keeps: `SANDBOX_CACHE_DIR`, or the user's cache folder."""
    root = os.environ.get("SANDBOX_CACHE_DIR")
    return Path(root) if root else user_cache_path("sandbox2d")


def cache_key() -> str:
    """What machine code depends on: sources, numba, Python, the processor that it is for, and where it lies."""
    from numba.core.registry import cpu_target

    target = str(cpu_target.target_context.codegen().magic_tuple())  # what numba itself files machine code under
    processor = hashlib.blake2b(f"{target} {Path(__file__)}".encode(), digest_size=4).hexdigest()
    return f"{sources_hash()}-numba{numba.__version__}-py{platform.python_version()}-{processor}"


@cache
def sources_hash() -> str:
    """Hash of every file that holds kernels, 16 hex digits."""
    package = Path(__file__).parent
    digest = hashlib.blake2b(digest_size=8)
    for room in _ROOMS:
        path = package / room
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            digest.update(file.relative_to(package).as_posix().encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def _forget_old_folders(base: Path, current: Path) -> None:
    """Keep the cache small: folders of other sources go once they have not been used for two weeks."""
    os.utime(current)
    for folder in base.iterdir():
        if folder != current and time.time() - folder.stat().st_mtime > _STALE_SECONDS:
            shutil.rmtree(folder, ignore_errors=True)
