"""The numbers, materials and prefabs that a scene has, its own and those of the files that it includes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sandbox.scene.authoring.document import Document, Written
from sandbox.scene.authoring.include import Reader
from sandbox.scene.constraints import describe
from sandbox.scene.finding import quoted
from sandbox.scene.near_names import did_you_mean

PARTS = ("vars", "materials", "prefabs")
"""What an included file brings."""
_BESIDE = ("$schema", "format", "title", "about", "include")


@dataclass
class Library:
    """Everything by kind and name, each where it was written; `files` are those that it was read from besides,
    and `brought` are the numbers that they name."""

    vars: dict[str, Written] = field(default_factory=dict)
    materials: dict[str, Written] = field(default_factory=dict)
    prefabs: dict[str, Written] = field(default_factory=dict)
    files: tuple[Path, ...] = ()
    brought: set[str] = field(default_factory=set)

    def of(self, kind: str) -> dict[str, Written]:
        """Those of one of `PARTS`."""
        found: dict[str, Written] = getattr(self, kind)
        return found


def gathered(main: Document, reader: Reader) -> Library:
    """The library of a scene: where a name is given twice, the scene's own holds. Mistakes go to the reader."""
    return _Gathering(reader).of(main, ())


@dataclass
class _Gathering:
    reader: Reader
    _done: dict[Path, Library] = field(default_factory=dict)

    def of(self, document: Document, way: tuple[Path, ...]) -> Library:
        library = Library()
        if not isinstance(document.data, dict):
            return library
        for entry in _entries(document):
            found = self.reader.document(entry, way)
            if found is None:
                continue
            path, other = found
            if path not in self._done:
                self._check(other)
                self._done[path] = self.of(other, (*way, path))
            self._take(library, self._done[path], entry)
            library.files = tuple(dict.fromkeys([*library.files, path, *self._done[path].files]))
            library.brought |= self._done[path].vars.keys()
        for kind in PARTS:
            own = Written(document, (kind,), document.data.get(kind))
            if isinstance(own.value, dict):
                library.of(kind).update((name, own.at(name)) for name in own.value if isinstance(name, str))
        return library

    def _take(self, library: Library, other: Library, entry: Written) -> None:
        """Add what an included file brings; what stands in the including file wins later on."""
        for kind in PARTS:
            ours, own = library.of(kind), entry.document.data.get(kind)
            for name, brought in other.of(kind).items():
                there = ours.setdefault(name, brought)
                clash = there.document is not brought.document
                if clash and not (isinstance(own, dict) and name in own):
                    files = f"{there.document.source} and {brought.document.source}"
                    text = f'two files bring "{kind}" {quoted(name)}: {files}'
                    self.reader.faults.append(entry.fault(text, "one of its own would decide"))

    def _check(self, document: Document) -> None:
        """What an included file has besides would be lost without a word."""
        top = Written(document, (), document.data)
        if not isinstance(document.data, dict):
            self.reader.faults.append(top.fault(f"a part must be an object {{...}}, not {describe(document.data)}"))
            return
        for key, value in document.data.items():
            known = (*PARTS, *_BESIDE)
            if key not in known:
                hint = did_you_mean(key, known) or "a part brings vars, materials and prefabs"
                text = f"an included file has no {quoted(key)}"
                self.reader.faults.append(top.at(key).fault(text, hint, on_key=True))
            elif key in PARTS and not isinstance(value, dict):
                text = f"{key} must be an object {{...}}, not {describe(value)}"
                self.reader.faults.append(top.at(key).fault(text))
            elif key == "include" and not _is_list_of_texts(value):
                self.reader.faults.append(top.at(key).fault('include must be a list ["FILE.json", ...]'))


def _entries(document: Document) -> Iterator[Written]:
    """The files that a document includes, if it says so as it should."""
    value = document.data.get("include")
    if _is_list_of_texts(value):
        yield from (Written(document, ("include", k), name) for k, name in enumerate(value))


def _is_list_of_texts(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and all(isinstance(entry, str) for entry in value)
