"""Finds and reads the files that a scene includes.

An include is the way from the file that asks for it to another one, or `sandbox:NAME` for a part that comes with the
package. It leads to nothing outside of the folder above that of the scene, not by a symbolic link either, so that
scenes can share a folder `../parts`, and a scene from somewhere else can read nothing far from it.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path, PureWindowsPath

from sandbox.errors import Problem, SceneError
from sandbox.resources import part_file, shipped_parts
from sandbox.scene.authoring.document import Document, Fault, Written
from sandbox.scene.finding import quoted
from sandbox.scene.limits import MAX_BYTES, MAX_INCLUDES, MAX_NESTING
from sandbox.scene.near_names import did_you_mean, nearest
from sandbox.scene.parse import parse
from sandbox.scene.read import read_text

SHIPPED = "sandbox:"
"""Begins the name of a part that comes with the package."""


class IncludeError(Exception):
    """An include cannot be followed: why, and the mend."""

    def __init__(self, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.message, self.hint = message, hint


@dataclass
class Reader:
    """Reads each file once; `faults` and `problems` (of files that are no JSON) collect what is wrong."""

    main: Document
    faults: list[Fault] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    _known: dict[Path, Document | None] = field(default_factory=dict)
    _size: int = 0

    def document(self, entry: Written, way: tuple[Path, ...]) -> tuple[Path, Document] | None:
        """The file that an entry of `include` means; `way` are those that led to it. None if it is wrong."""
        try:
            path = self._path(entry, way)
        except IncludeError as mistake:
            self.faults.append(entry.fault(mistake.message, mistake.hint))
            return None
        if path not in self._known:
            self._known[path] = self._read(path, entry)
        found = self._known[path]
        return None if found is None else (path, found)

    def _path(self, entry: Written, way: tuple[Path, ...]) -> Path:
        name: str = entry.value
        if len(way) >= MAX_NESTING:
            raise IncludeError(f"files include each other deeper than {MAX_NESTING} levels")
        path = _shipped(name) if name.startswith(SHIPPED) else self._beside(name, entry.document)
        if path in way or path == self._home():
            told = " > ".join(one.name for one in (*way, path))
            raise IncludeError(f"these files include each other: {told}")
        if path not in self._known and len(self._known) >= MAX_INCLUDES:
            raise IncludeError(f"a scene includes at most {MAX_INCLUDES} files")
        return path

    def _home(self) -> Path | None:
        return self.main.file.resolve() if self.main.file is not None else None

    def _beside(self, name: str, document: Document) -> Path:
        if document.file is None:
            text = "a scene that is in no file includes only what comes with the package"
            raise IncludeError(text, f'such as "{SHIPPED}materials"')
        if not name.endswith(".json") or "\\" in name or name.startswith("/") or not name.isprintable():
            raise IncludeError(f'an include is the way to a .json file from here, or "{SHIPPED}NAME"')
        if PureWindowsPath(name).drive:
            raise IncludeError("an include is the way to a .json file from here, with / between folders")
        try:
            path = (document.file.parent / name).resolve()
            root = self._root(document)
        except (OSError, ValueError, RuntimeError):
            raise IncludeError(f"there is no file {quoted(name)}") from None
        if not path.is_relative_to(root):
            text = "an include must stay within the folder above that of the scene"
            raise IncludeError(f"{text}, and {quoted(name)} leads out of it", "copy the file there")
        if not path.is_file():
            raise IncludeError(f"there is no file {quoted(name)}", _near_file(path, name))
        return path

    def _root(self, document: Document) -> Path:
        shipped = part_file("").parent.resolve()
        here = document.file.resolve() if document.file else Path()
        if here.is_relative_to(shipped):
            return shipped
        home = self._home()
        assert home is not None
        return home.parent.parent

    def _read(self, path: Path, entry: Written) -> Document | None:
        source = _told(path)
        try:
            text = read_text(path, "part").removeprefix("\ufeff")
            self._size += len(text)
            if self._size > MAX_BYTES:
                self.faults.append(entry.fault(f"included files are larger than {MAX_BYTES // 2**20} MiB together"))
                return None
            read = parse(text, source)
        except SceneError as error:
            self.problems += [
                Problem(one.message, one.pointer, one.line, one.column, one.hint, one.excerpt, source)
                for one in error.problems
            ]
            return None
        document = Document(source, read.data, text, path, repeats=read.repeats)
        self.faults += [Fault(document, finding) for finding in read.repeats]
        return document


def _shipped(name: str) -> Path:
    wanted = name.removeprefix(SHIPPED)
    known = shipped_parts()
    if wanted not in known:
        near = nearest(wanted, known)
        hint = f'did you mean "{SHIPPED}{near}"?' if near else f"there are {', '.join(SHIPPED + one for one in known)}"
        raise IncludeError(f"no part is named {quoted(wanted)}", hint)
    return part_file(wanted).resolve()


def _near_file(path: Path, name: str) -> str:
    try:
        others = [one for one in os.listdir(path.parent) if one.endswith(".json")]
    except OSError:
        return ""
    near = nearest(path.name, others)
    return did_you_mean(name, [name.removesuffix(path.name) + near]) if near else ""


def _told(path: Path) -> str:
    """A path as messages name it: from the working folder if it is below."""
    try:
        return path.relative_to(Path.cwd()).as_posix()
    except (ValueError, OSError):
        return str(path)
