"""The scene as it comes out: what prefabs made, where each part was written, and how much may still be made."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sandbox.scene.authoring.document import Document, Fault, Written
from sandbox.scene.finding import Path
from sandbox.scene.limits import MAX_BODIES, MAX_JOINTS, MAX_NAME, MAX_VALUES
from sandbox.scene.quantities import is_name


class TooMuchError(Exception):
    """The copies of prefabs are more than a scene may have; nothing more is made."""


@dataclass(frozen=True)
class Origin:
    """Where a value was written; `entry` is the path in the scene's own file that brought it."""

    document: Document
    path: Path
    entry: Path


@dataclass
class Output:
    """What is made of the `main` document; `origins` by the path in the scene made, where it is another one.

    It `is_whole` unless there is a generator of which nobody knows what it would make.
    """

    main: Document
    bodies: list[Any] = field(default_factory=list)
    joints: list[Any] = field(default_factory=list)
    prefabs: dict[str, Any] = field(default_factory=dict)
    generate: list[Any] = field(default_factory=list)
    origins: dict[Path, Origin] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    is_whole: bool = True
    _values: int = 0
    _numbers: dict[str, int] = field(default_factory=dict)

    def spend(self, values: int, asked: Written) -> None:
        """Take so many more values, before they are made. Raises `TooMuchError`, which is told at `asked`."""
        self.ask_values(values, asked)
        self._values += values

    def ask_values(self, values: int, asked: Written) -> None:
        """Ask whether so many more values may be made. Raises `TooMuchError`, which is told at `asked`."""
        if self._values + values > MAX_VALUES:
            text = f"the copies of prefabs have more than {MAX_VALUES:,} values together, which is the limit"
            self.faults.append(asked.fault(text))
            raise TooMuchError

    def ask_room(self, bodies: int, asked: Written) -> None:
        """Ask for so many more bodies before they are made. Raises `TooMuchError`, which is told at `asked`."""
        self._check(len(self.bodies) + bodies - 1, MAX_BODIES, "bodies", asked)

    def add_body(self, body: Mapping[str, Any], part: Written, asked: Written) -> None:
        """A body made after `part`, as `asked` for."""
        self._check(len(self.bodies), MAX_BODIES, "bodies", asked)
        path = ("bodies", len(self.bodies))
        self.origins[path] = Origin(part.document, part.path, asked.path)
        self._note_id(path, part, asked)
        self.bodies.append(body)

    def add_joint(self, joint: Mapping[str, Any], part: Written, asked: Written) -> None:
        """A joint made after `part`, as `asked` for."""
        self._check(len(self.joints), MAX_JOINTS, "joints", asked)
        path = ("joints", len(self.joints))
        self.origins[path] = Origin(part.document, part.path, asked.path)
        self._note_id(path, part, asked)
        self.joints.append(joint)

    def _note_id(self, path: Path, part: Written, asked: Written) -> None:
        """An id is that of the copy and its own; where its own is no name, that is what is wrong with it."""
        own = part.at("id").value
        if isinstance(own, str) and is_name(own):
            self.origins[(*path, "id")] = Origin(asked.document, (*asked.path, "id"), asked.path)

    def add_prefab(self, name: str, prefab: Any, part: Written) -> None:
        """A prefab under a name that none has."""
        self.prefabs[name] = prefab
        self._note(("prefabs", name), part, ("include",))

    def add_generator(self, generator: Any, written: Written) -> None:
        """A generator that makes its bodies later on."""
        self._note(("generate", len(self.generate)), written, written.path)
        self.generate.append(generator)

    def _note(self, path: Path, written: Written, entry: Path) -> None:
        if (written.document, written.path) != (self.main, path):
            self.origins[path] = Origin(written.document, written.path, entry)

    def free_name(self, name: str) -> str:
        """A name for a prefab that is not taken yet."""
        name = name[: MAX_NAME - 8] if is_name(name[:MAX_NAME]) else "prefab"
        free = name
        while free in self.prefabs:
            self._numbers[name] = self._numbers.get(name, 1) + 1
            free = f"{name}:{self._numbers[name]}"
        return free

    def _check(self, count: int, limit: int, what: str, asked: Written) -> None:
        if count >= limit:
            self.faults.append(asked.fault(f"the scene has more than {limit} {what}, which is the limit"))
            raise TooMuchError


def size_of(value: Any) -> int:
    """How many values there are in plain data."""
    total, left = 0, [value]
    while left:
        node = left.pop()
        total += 1
        if isinstance(node, dict):
            left += node.values()
        elif isinstance(node, (list, tuple)):
            left += node
    return total
