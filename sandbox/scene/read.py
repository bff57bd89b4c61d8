"""Reads a scene file as text, whatever is found under the path."""

from __future__ import annotations

import os
from pathlib import Path

from sandbox._bounded_read import read_bytes
from sandbox.errors import Problem, SceneError
from sandbox.resources import benchmark_scenes, find_scene, scene_name, shipped_scenes
from sandbox.scene.limits import MAX_BYTES
from sandbox.scene.near_names import nearest
from sandbox.scene.report import syntax_error


def read_text(path: Path, what: str = "scene", limit: int = MAX_BYTES) -> str:
    """The text of a UTF-8 file of at most `limit` bytes; `what` it should hold. Raises `SceneError`."""
    return as_text(path, read_data(path, what, limit))


def read_data(path: Path, what: str = "scene", limit: int = MAX_BYTES) -> bytes:
    """The contents of a file of at most `limit` bytes; `what` it should hold. Raises `SceneError`."""
    data = _read_bytes(path, what, limit)
    if len(data) > limit:
        raise _error(path, f"the file is larger than {limit // 2**20} MiB, the limit of a {what}")
    return data


def as_text(path: Path, data: bytes) -> str:
    """Contents of the file `path` as UTF-8. Raises `SceneError`."""
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise _not_utf8(path, data, error.start) from None


def check_readable(path: Path, what: str = "scene") -> None:
    """Raises `SceneError` where no file can be read that holds `what`; opens it, and reads nothing."""
    _read_bytes(path, what, -1)


def _read_bytes(path: Path, what: str, limit: int) -> bytes:
    try:
        return read_bytes(path, limit + 1)
    except FileNotFoundError:
        raise _error(path, "there is no such file", _nearest_file(path)) from None
    except IsADirectoryError:
        raise _error(path, f"this is a folder, not a {what} file") from None
    except (OSError, ValueError) as error:
        if path.is_dir():  # some systems answer "permission denied" for a folder
            raise _error(path, f"this is a folder, not a {what} file") from None
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise _error(path, f"the file cannot be read: {reason}") from None


def _shipped_names() -> list[str]:
    return [scene_name(file) for file in (*shipped_scenes(), *benchmark_scenes())]


def _nearest_file(path: Path) -> str:
    if path.is_symlink():
        return "it is a link to what is not there"
    if str(path) == "-":
        return "what a pipe brings is /dev/stdin"
    shipped = _shipped_names() if path.parent == Path() and not path.suffix else []
    if path.name in shipped:
        return f"a scene of that name comes with the package, as {find_scene(path).as_posix()}"
    if name := nearest(path.name, shipped):
        return f'did you mean "{name}", which comes with the package?'
    try:
        # What all names end in would make all of them look alike.
        stems = {name.split(".")[0]: name for name in os.listdir(path.parent) if name.endswith(".json")}
    except (OSError, ValueError):
        return ""
    near = nearest(path.name.split(".")[0], stems)
    return f'did you mean "{stems[near]}"?' if near else ""


def _not_utf8(path: Path, data: bytes, start: int) -> SceneError:
    text = data[:start].decode("utf-8")
    head = data[:100]
    zeros = max(head[::2].count(0), head[1::2].count(0))  # of letters in UTF-16, every other byte is one
    if data.startswith((b"\xff\xfe", b"\xfe\xff")) or 4 * zeros > len(head):
        return _error(path, "the file is not UTF-8; it looks like UTF-16", "save it as UTF-8")
    if b"\0" in head:
        return _error(path, "this is no text, but a picture, an archive or the like", "scenes and recordings are JSON")
    shown = text + data[start : start + 100].decode("utf-8", "replace")
    message = f"the byte 0x{data[start]:02x} is not UTF-8"
    return syntax_error(str(path), shown, (len(text), len(text) + 1), message, "save the file as UTF-8")


def _error(path: Path, message: str, hint: str = "") -> SceneError:
    return SceneError(str(path), [Problem(message, hint=hint)])
