"""Where the machine code of kernels is kept on disk, and under which names.

The folder is named by all that machine code depends on: a hash of every kernel source, the versions of numba and
Python, and the processor. A change in any of them starts a new folder and never runs stale code. What is not there may
have come with the package (`_shipped_code.py`).
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
import platform
import shutil
import sys
import time
from contextlib import suppress
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

from sandbox._atomic_write import write_bytes
from sandbox._bounded_read import read_bytes
from sandbox._shipped_code import shipped_folder

_ROOMS = (
    "_argument_words.py",
    "_jit.py",
    "_linking.py",
    "_llvm_aliasing.py",
    "_llvm_atomics.py",
    "_llvm_bundles.py",
    "_llvm_calls.py",
    "_llvm_prefetch.py",
    "_llvm_rows.py",
    "_llvm_vectors.py",
    "_llvm_words.py",
    "_machine_code.py",
    "_plain_vectors.py",
    "_atomics.py",
    "_calls.py",
    "_instruction.py",
    "_prefetch.py",
    "_vectors.py",
    "_way_in.py",
    "tables.py",
    "geometry",
    "world/records.py",
    "world/joint_records.py",
    "world/field_records.py",
    "engine",
)
WITHOUT_KERNELS = ("engine/commands/", "engine/rules/", "engine/views/")
"""Folders in these that have no kernels, nor anything that kernels read: whoever works on them compiles nothing."""
_SETTINGS = (
    *(f"NUMBA_{name}" for name in ("CPU_NAME", "CPU_FEATURES", "ENABLE_AVX", "OPT", "LOOP_VECTORIZE", "SLP_VECTORIZE")),
    "SANDBOX_CHECK_ROWS",
)
"""Environment variables that change machine code."""
_STALE_SECONDS = 14 * 24 * 3600
_SUFFIX = ".code"
_LARGEST = 1 << 28
"""Bytes of a file of machine code; the largest has a megabyte."""
_told: list[OSError] = []
_STEP = "sandbox.engine.step"
"""The module of the entry points that every world needs."""


def is_filled() -> bool:
    """Whether the machine code of the step is there: compiled here, or shipped."""
    shipped = shipped_folder(sources_hash())
    return is_compiled() or (shipped is not None and _has_step(shipped))


def is_compiled() -> bool:
    """Whether the machine code of the step has been compiled for this processor."""
    return _has_step(cache_folder())


def _has_step(folder: Path) -> bool:
    try:
        return any(folder.glob(f"{_STEP}.*{_SUFFIX}"))
    except OSError:
        return False


@cache
def cache_folder() -> Path:
    """Where machine code is kept: in `cache_root()`, named by `cache_key()`. It is made if it can be."""
    base = cache_root() / "kernels"
    folder = base / cache_key()
    with suppress(OSError):  # then nothing is kept, which `write` tells
        folder.mkdir(parents=True, exist_ok=True)
        _forget_old_folders(base, folder)
    return folder


def can_keep() -> bool:
    """Whether machine code can be kept, as far as can be told before: a disk may be full."""
    return os.access(cache_folder(), os.W_OK | os.X_OK)


def cache_root() -> Path:
    """The folder for all that this package keeps: `SANDBOX_CACHE_DIR`, or the user's cache folder."""
    root = os.environ.get("SANDBOX_CACHE_DIR")
    if root:
        return Path(root)
    from platformdirs import user_cache_path  # not there yet where a wheel is built

    return user_cache_path("sandbox2d")


def cache_key() -> str:
    """What machine code depends on: sources, numba, Python, and the processor that it is for."""
    processor = hashlib.blake2b(repr(_target()).encode(), digest_size=4).hexdigest()
    return f"{sources_hash()}-numba{importlib.metadata.version('numba')}-py{platform.python_version()}-{processor}"


@cache
def sources_hash() -> str:
    """Hash of every file that holds kernels, 16 hex digits."""
    package = Path(__file__).parent
    digest = hashlib.blake2b(digest_size=8)
    for room in _ROOMS:
        path = package / room
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            name = file.relative_to(package).as_posix()
            if not name.startswith(WITHOUT_KERNELS):
                digest.update(name.encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def kept_file(function: FunctionType, kinds: tuple[Any, ...]) -> Path | None:
    """Where the machine code of a function for arguments of these kinds is kept; None if it cannot be.

    That is a function within a function, which may be another one at every call of the outer one.
    """
    if function.__closure__ or "<" in function.__qualname__:
        return None
    digest = hashlib.blake2b(f"{_source(function)} {kinds!r}".encode(), digest_size=8).hexdigest()
    return cache_folder() / f"{function.__module__}.{function.__qualname__}-{digest}{_SUFFIX}"


def read(file: Path | None) -> tuple[Any, bytes] | None:
    """What `write` has written: (about it, machine code). None if it is not there or not whole.

    What was compiled for this very processor comes before what was shipped for all of its level.
    """
    if file is None:
        return None
    shipped = shipped_folder(sources_hash())
    return _read(file) or (_read(shipped / file.name) if shipped is not None else None)


def _read(file: Path) -> tuple[Any, bytes] | None:
    try:
        head, _, code = read_bytes(file, _LARGEST).partition(b"\n")
        digest, _, about = head.decode(errors="replace").partition(" ")
        return (json.loads(about), code) if digest == _signature(file, about.encode(), code) else None
    except (OSError, ValueError):
        return None


def write(file: Path | None, about: Any, code: bytes) -> None:
    """Keep machine code and what is to be known about it, a JSON value. Other processes see all of it or nothing.

    Where it cannot be kept, this process says so once and goes on with what is in memory.
    """
    if file is None:
        return
    head = json.dumps(about).encode()
    try:
        _make_way(file)
        write_bytes(file, _signature(file, head, code).encode() + b" " + head + b"\n" + code, durable=False)
    except OSError as error:
        _tell(error)


def _make_way(file: Path) -> None:
    """Take away what is no file: it would be written into, or stay for ever."""
    if file.is_dir() and not file.is_symlink():
        shutil.rmtree(file)
    elif os.path.lexists(file) and not file.is_file():
        file.unlink()


def _tell(error: OSError) -> None:
    """Say it once. Processes of a pool leave that to the one that has begun them."""
    from multiprocessing import parent_process  # not needed where all is well

    if _told or parent_process() is not None or sys.stderr is None:
        return
    _told.append(error)
    reason = str(error.strerror).removeprefix("it cannot be written: ")
    words = f"machine code cannot be kept in {cache_root()}: {reason}"
    mend = "it is compiled anew by every process until SANDBOX_CACHE_DIR names a folder that can be written to"
    print(f"sandbox: {words}; {mend}", file=sys.stderr, flush=True)


def _signature(file: Path, about: bytes, code: bytes) -> str:
    """Of a whole file under its own name: under another kernel's its code would be called with wrong arguments."""
    return _digest(file.name.encode(), about, code)


def _digest(*parts: bytes) -> str:
    return hashlib.blake2b(b"\0".join(parts), digest_size=16).hexdigest()


def _target() -> tuple[Any, ...]:
    """The processor, as LLVM sees it, and what else changes the machine code that is made for it."""
    import llvmlite
    from llvmlite import binding as llvm

    try:
        features = llvm.get_host_cpu_features().flatten()
    except RuntimeError:  # not known for this platform
        features = ""
    settings = tuple(map(os.environ.get, _SETTINGS))
    return llvm.get_process_triple(), llvm.get_host_cpu_name(), features, llvmlite.__version__, settings


@cache
def _source(function: FunctionType) -> str:
    """A hash of the file of a function that is not in the rooms that `sources_hash` knows."""
    package, file = Path(__file__).parent, Path(function.__code__.co_filename)
    if any(file.is_relative_to(package / room) for room in _ROOMS):
        return ""
    return _digest(file.read_bytes())


def _forget_old_folders(base: Path, current: Path) -> None:
    """Keep the cache small: folders of other sources go once they have not been used for two weeks."""
    os.utime(current)
    for folder in base.iterdir():
        if folder != current and time.time() - folder.stat().st_mtime > _STALE_SECONDS:
            shutil.rmtree(folder, ignore_errors=True)
