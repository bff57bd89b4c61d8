"""An expanded scene, and the way back from a mistake in it to the words of its author."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path as FilePath
from typing import Any

from sandbox.errors import Problem, SceneError
from sandbox.resources import part_file
from sandbox.scene.authoring.document import Document, Fault
from sandbox.scene.authoring.expression import is_expression
from sandbox.scene.authoring.include import SHIPPED
from sandbox.scene.authoring.library import PARTS, Library
from sandbox.scene.authoring.output import Origin
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.report import scene_error, sort_of

_TAKEN = re.compile(r"is taken by (bodies)\[(\d+)\]")


@dataclass(frozen=True)
class Expansion:
    """Plain `data` that a `main` document comes down to.

    `origins` say where values were written whose path is another one; the fields `lacking` would have more in them if
    all that is included could be read. `broken` are the places of numbers that could not be worked out. `faults` and
    `problems` (of files that are no JSON) were wrong already.
    """

    main: Document
    data: Any
    origins: Mapping[Path, Origin] = field(default_factory=dict)
    lacking: tuple[str, ...] = ()
    faults: tuple[Fault, ...] = ()
    broken: Collection[tuple[Document, Path]] = ()
    problems: tuple[Problem, ...] = ()
    library: Library = field(default_factory=Library)

    @property
    def files(self) -> tuple[FilePath, ...]:
        """The files that were included."""
        return self.library.files

    @property
    def sound(self) -> bool:
        """Whether nothing was wrong up to now."""
        return not self.faults and not self.problems and not self.main.repeats

    def written(self, moved: bool) -> dict[str, Any]:
        """The main document; if it is `moved` elsewhere, with what its includes bring instead of their names."""
        data = dict(self.main.data)
        if not moved or not self.library.files:
            return data
        ways = [name for name in data.pop("include") if name.startswith(SHIPPED)]
        if ways:
            data["include"] = ways
        for kind in PARTS:
            brought = {name: one.value for name, one in self.library.of(kind).items() if not _is_shipped(one.document)}
            if brought:
                data[kind] = brought
        return data

    def entry(self, path: Path) -> Path:
        """The path in the main document of what brought the value at a path of `data`."""
        origin, rest = self._origin(path)
        if origin is None:
            return path
        return origin.path + rest if origin.document is self.main else origin.entry

    def error(self, findings: Iterable[Finding]) -> SceneError:
        """The error about all faults, and about findings whose paths are those of `data`."""
        repeats = [Fault(self.main, finding) for finding in self.main.repeats]
        faults = self._unique([*self.faults, *repeats, *map(self._written, findings)])
        documents = list(dict.fromkeys([self.main, *(fault.document for fault in faults)]))
        problems: list[Problem] = []
        for document in documents:
            own = [fault.finding for fault in faults if fault.document is document]
            problems += _problems(document, own, document is self.main)
        return SceneError(self.main.source, [*problems, *self.problems])

    def _origin(self, path: Path) -> tuple[Origin | None, Path]:
        for length in range(len(path), 0, -1):
            origin = self.origins.get(path[:length])
            if origin is not None:
                return origin, path[length:]
        return None, path

    def _written(self, finding: Finding) -> Fault:
        """A finding where its author can mend it."""
        origin, rest = self._origin(finding.path)
        document = origin.document if origin else self.main
        path = origin.path + rest if origin else finding.path
        text = document.value(path)
        value = Document("", self.data).value(finding.path)
        if is_expression(text) and isinstance(value, (int, float)) and not (finding.hint or finding.on_key):
            finding = replace(finding, hint=f"{quoted(text)} is {value:.6g}")
        return Fault(document, replace(finding, path=path, message=_TAKEN.sub(self._taken, finding.message)))

    def _taken(self, match: re.Match[str]) -> str:
        """Bodies that copies of prefabs have are in no list that the author wrote."""
        made = (match[1], int(match[2])) in self.origins
        return "is taken by a copy of a prefab" if made else match[0]

    def _unique(self, faults: list[Fault]) -> list[Fault]:
        """Each mistake once, however many copies have it, and nothing more about what is wrong already."""
        wrong = {(id(fault.document), fault.finding.path) for fault in self.faults}
        wrong |= {(id(document), path) for document, whole in self.broken for path in (whole, _list_of(whole))}
        wrong_kinds = {(id(fault.document), fault.finding.path) for fault in faults if not fault.finding.lacks}
        seen: dict[Any, Fault] = {}
        for k, fault in enumerate(faults):
            place = (id(fault.document), fault.finding.path)
            if k < len(self.faults) or place not in (wrong_kinds if fault.finding.lacks else wrong):
                # Of a copy, the ids of several bodies and joints may be taken.
                seen.setdefault((*place, sort_of(fault.finding).partition(" is taken by ")[0]), fault)
        return list(seen.values())


def _list_of(path: Path) -> Path:
    """The path of the list that an entry is in; that of anything else."""
    return path[:-1] if isinstance(path[-1], int) else path


def _problems(document: Document, findings: list[Finding], is_main: bool) -> Iterator[Problem]:
    """Those of one document, in its order; what was set from outside first."""
    outside = {id(finding): words for finding in findings if (words := _changed(document, finding)) is not None}
    for finding in findings:
        if id(finding) in outside:
            yield replace(finding.problem(), pointer="", source=outside[id(finding)])
    inside = [finding for finding in findings if id(finding) not in outside]
    for problem in scene_error(document.source, inside, document.text).problems if inside else ():
        yield problem if is_main else replace(problem, source=document.source)


def _is_shipped(document: Document) -> bool:
    """Whether it is a part that comes with the package."""
    shipped = part_file("").parent.resolve()
    return document.file is not None and document.file.resolve().is_relative_to(shipped)


def _changed(document: Document, finding: Finding) -> str | None:
    """The words in which the value was set that a finding is about."""
    for length in range(len(finding.path), 0, -1):
        words = document.changed.get(finding.path[:length])
        if words is not None:
            return words
    return None
