"""Streams that a shell lends a process, `<(command)` and `/dev/stdin`: they can be read once, and are in no folder.

A command looks into what it is given more than once, and so may the processes that it starts: with `keep_streams`,
what has been read of a stream is kept for whoever reads it next.
"""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Mapping
from pathlib import Path

_LENT = re.compile(r"/dev/stdin|(?:/dev|/proc/(self|\d+))/fd/(\d+)")
_AT_ONCE = 1 << 20


class _Stream:
    """What has been read of a stream, and the stream for the rest of it, if this process has that."""

    def __init__(self, data: bytes = b"", number: int | None = None) -> None:
        self.data = data
        self._file = None if number is None else os.fdopen(number, "rb")

    def read(self, limit: int) -> bytes:
        """The first `limit` bytes, however much was asked for before."""
        while self._file is not None and len(self.data) < limit:
            part = self._file.read(min(limit - len(self.data), _AT_ONCE))
            if not part:
                break
            self.data += part
        return self.data[:limit]


_kept: dict[str, _Stream] | None = None


def is_lent(path: Path) -> bool:
    """Whether it is named as a shell names what it lends."""
    return _LENT.fullmatch(str(path)) is not None


def lent_number(path: Path) -> int | None:
    """The number under which this process has a file open that a shell lends it."""
    match = _LENT.fullmatch(str(path))
    if match is None or match[1] not in (None, "self", str(os.getpid())):
        return None
    return int(match[2] or 0)


def home_of(path: Path) -> Path:
    """The folder in which what a file names is looked for: its own, or for what is lent the current one."""
    return Path() if is_lent(path) else path.parent


def keep_streams(known: Mapping[str, bytes] | None = None) -> None:
    """From now on, keep what is read of lent streams; `known` is what another process has read of them."""
    global _kept
    _kept = {name: _Stream(data) for name, data in (known or {}).items()}


def kept_streams() -> dict[str, bytes]:
    """What has been read of lent streams, by their paths."""
    return {name: stream.data for name, stream in (_kept or {}).items()}


def read_kept(path: Path, limit: int) -> bytes | None:
    """The first `limit` bytes of a lent stream that is kept; None for anything else. Raises `OSError`."""
    if _kept is None or not is_lent(path):
        return None
    name = str(path)
    if name not in _kept:
        if stat.S_ISREG(os.stat(path).st_mode):  # can be read again
            return None
        _kept[name] = _Stream(number=os.open(path, os.O_RDONLY | getattr(os, "O_CLOEXEC", 0)))
    return _kept[name].read(limit)
