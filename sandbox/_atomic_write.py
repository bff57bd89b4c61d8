"""Writes files whole or not at all: nobody finds half a file, and what stood there survives a full disk.

What is written goes into a new file in the same folder, which takes the old one's place by a rename (POSIX `rename`,
Windows `MoveFileEx`). Links are followed, and the permissions of a file that was there are kept. What is no regular
file (`/dev/stdout`, a pipe) is written as it is.
"""

from __future__ import annotations

import errno
import os
import secrets
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from sandbox._lent import lent_number
from sandbox._printable import printable

_NO_SYNC = (errno.EINVAL, errno.ENOSYS, errno.ENOTSUP)
"""What file systems answer that cannot be asked to sync."""
_STREAMS = (1, 2)
"""What this process has open for output."""


def write_text(path: Path, text: str, over: bool = True) -> None:
    """Write a text as UTF-8, with `\\n` at the ends of lines on every system; `over` as in `write_bytes`.

    Raises `OSError` that names `path`.
    """
    write_bytes(path, utf8(text), over=over)


def utf8(text: str) -> bytes:
    """The bytes of a text. Half a character (a lone surrogate), as names of files may have, has none, and becomes what
    it is called in JSON and in programs: `\\ud800`."""
    return text.encode(errors="backslashreplace")


def write_bytes(path: Path, data: bytes, durable: bool = True, over: bool = True) -> None:
    """Write `data`. `durable`: it is on the disk before it takes the place of what was there.

    Without `over`, a file that is there, also one that somebody else has just written, is left alone, and
    `FileExistsError` raised. Raises `OSError` that names `path`; what was there is there still then, and nothing else.
    """
    with _naming(path):
        _write(Path(path), data, durable, over)


def check_writable(path: Path) -> None:
    """Whether `path` can be written, as far as can be told before. Raises `OSError` as `write_bytes` would."""
    with _naming(path):
        there = _status(Path(path))
        _check_there(path, there)
        if there is None or stat.S_ISREG(there.st_mode):
            _check_folder(_target(path).parent)


def _write(path: Path, data: bytes, durable: bool, over: bool) -> None:
    there = _status(path)
    _check_there(path, there)
    stream = next((number for number in _STREAMS if there and _is_open_as(there, number)), None)
    if stream is not None:
        sys.stdout.flush()
        _write_to(os.dup(stream), data)
        return
    if there is not None and not stat.S_ISREG(there.st_mode):
        _write_to(os.open(path, os.O_WRONLY | getattr(os, "O_BINARY", 0)), data)
        return
    target = _target(path)
    _check_folder(target.parent)
    with _partial(target, there, data, durable) as partial:
        (os.replace if over else _put)(partial, target)


@contextmanager
def _partial(target: Path, there: os.stat_result | None, data: bytes, durable: bool) -> Iterator[Path]:
    """A file beside `target` that has all of it, for a while."""
    partial = target.with_name(f".sandbox-{secrets.token_hex(6)}.part")
    try:
        number = os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
        if there is not None:
            _keep_permissions(partial, there)
        _write_to(number, data, durable)
        yield partial
    finally:
        with suppress(OSError):
            partial.unlink(missing_ok=True)


def _put(partial: Path, target: Path) -> None:
    """Give a file its name unless another has it: of several who do so at once, one does. Raises `OSError`."""
    try:
        os.link(partial, target)
    except FileExistsError:
        raise FileExistsError(errno.EEXIST, "there is a file of that name already") from None
    except OSError:  # a file system without links
        os.close(os.open(target, os.O_CREAT | os.O_EXCL))
        os.replace(partial, target)


def _write_to(number: int, data: bytes, durable: bool = False) -> None:
    """Write to an open file and close it."""
    with os.fdopen(number, "wb") as file:
        file.write(data)
        file.flush()
        if durable:
            try:
                os.fsync(number)
            except OSError as error:
                if error.errno not in _NO_SYNC:
                    raise


def _keep_permissions(partial: Path, there: os.stat_result) -> None:
    """Those of the file that was there, and its owner where that is allowed, before anything is written to it."""
    with suppress(OSError):  # only the administrator gives files away
        if hasattr(os, "chown"):
            os.chown(partial, there.st_uid, there.st_gid)
    with suppress(OSError):  # not every file system has permissions
        os.chmod(partial, stat.S_IMODE(there.st_mode))


def _check_there(path: Path, there: os.stat_result | None) -> None:
    """Raises `OSError` for what is not to be written to; a rename would not ask."""
    if there is not None and stat.S_ISDIR(there.st_mode):
        raise IsADirectoryError(errno.EISDIR, "it is a folder")
    if there is not None and not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    _check_lent(path)


def _check_lent(path: Path) -> None:
    """Raises `OSError` for what a shell lends to be read, `<(command)`: what is written there is lost."""
    number = lent_number(path)
    if number is None:
        return
    import fcntl  # is there where shells lend streams

    if fcntl.fcntl(number, fcntl.F_GETFL) & os.O_ACCMODE == os.O_RDONLY:
        raise PermissionError(errno.EACCES, "it is lent to be read only; name the file itself")


def _check_folder(folder: Path) -> None:
    if not folder.is_dir():
        raise FileNotFoundError(errno.ENOENT, f"the folder {printable(str(folder))} does not exist")
    if not os.access(folder, os.W_OK):
        raise PermissionError(errno.EACCES, f"the folder {printable(str(folder))} cannot be written to")


def _status(path: Path) -> os.stat_result | None:
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _target(path: Path) -> Path:
    """Where links lead."""
    return Path(os.path.realpath(path))


def _is_open_as(there: os.stat_result, number: int) -> bool:
    try:
        return os.path.samestat(there, os.fstat(number))
    except OSError:  # closed
        return False


@contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Let errors tell of the file that was asked for, and not of another one on the way."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"it cannot be written: {error.strerror or error}", str(path)) from error
