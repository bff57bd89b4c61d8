"""Reads files that may be anything: what is no regular file could be waited for, or read, for ever."""

from __future__ import annotations

import errno
import os
import stat
from contextlib import suppress
from pathlib import Path

from sandbox._lent import is_lent, read_kept

_AT_ONCE = 1 << 20


def read_bytes(path: Path, limit: int) -> bytes:
    """The first `limit` bytes of a regular file, or of a stream that a shell lends. Raises `OSError`."""
    kept = read_kept(path, limit)
    if kept is not None:
        return kept
    _check(path, os.stat(path).st_mode)  # before it is opened: opening a device may do something
    flags = os.O_RDONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
    # Whoever puts a pipe there meanwhile does not make this wait.
    with os.fdopen(os.open(path, flags | (0 if is_lent(path) else getattr(os, "O_NONBLOCK", 0))), "rb") as file:
        _check(path, os.fstat(file.fileno()).st_mode)
        parts = []
        while limit > 0 and (part := file.read(min(limit, _AT_ONCE))):
            parts.append(part)
            limit -= len(part)
    return b"".join(parts)


def read_ahead(path: Path, limit: int) -> None:
    """Read what a shell lends, as far as `limit`, before other processes are to know of it, which cannot read it."""
    with suppress(OSError):  # whoever uses it is told
        read_kept(path, limit + 1)


def is_regular(path: Path) -> bool:
    """Whether it is a file that can be read to its end; False if there is none."""
    try:
        return stat.S_ISREG(os.stat(path).st_mode)
    except (OSError, ValueError):
        return False


def _check(path: Path, mode: int) -> None:
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if not stat.S_ISREG(mode) and not is_lent(path):
        raise OSError(errno.EINVAL, f"it is {_kind(mode)}, not a regular file", str(path))


def _kind(mode: int) -> str:
    kinds = {
        stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket", stat.S_IFCHR: "a device", stat.S_IFBLK: "a device"
    }  # fmt: skip
    return kinds.get(stat.S_IFMT(mode), "something else")
