"""What a scene comes down to, as hashes: equal for files that differ only in layout, wording or colour."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, fields, is_dataclass
from functools import cache
from typing import Any

from sandbox.scene.flat import FlatScene

_SILENT = {"pointer", "color", "clockwise", "words", "title", "keys", "minus", "pad", "mouse"}
"""What a flat scene remembers for messages and pictures, beside what does not even count for its equality."""


@dataclass(frozen=True)
class Meaning:
    """A hash of the whole (16 hex digits), and a short one (4) of the settings, the regions and each body and joint.

    Values at their defaults are left out, so that a later version with more of them finds the same hashes.
    """

    whole: str
    world: str
    bodies: Mapping[str, str]
    joints: Mapping[str, str]

    def changes(self, now: Meaning) -> list[str]:
        """What is otherwise in `now`, in words; empty if nothing is."""
        found = ["settings, gravity or regions were edited"] if self.world != now.world else []
        for what, old, new in (("body", self.bodies, now.bodies), ("joint", self.joints, now.joints)):
            found += [f"{what} {name} was taken away" for name in old if name not in new]
            found += [f"{what} {name} was added" for name in new if name not in old]
            found += [f"{what} {name} was edited" for name in old if name in new and old[name] != new[name]]
        in_both = [name for name in self.bodies if name in now.bodies]
        if not found and in_both != [name for name in now.bodies if name in self.bodies]:
            found.append("the order of the bodies was changed")
        return found or (["the scene was edited"] if self.whole != now.whole else [])


def meaning_of(flat: FlatScene) -> Meaning:
    """The hashes of a flattened scene."""
    shapes: dict[int, str] = {}
    world = _text(flat, shapes, leave={"bodies", "joints"})
    bodies = {body.id: _text(body, shapes) for body in flat.bodies}
    joints = {joint.id: _text(joint, shapes) for joint in flat.joints}
    whole = "\n".join([world, *bodies.values(), *joints.values()])
    return Meaning(
        _hash(whole, 8),
        _hash(world, 2),
        {name: _hash(text, 2) for name, text in bodies.items()},
        {name: _hash(text, 2) for name, text in joints.items()},
    )


def _hash(text: str, size: int) -> str:
    return hashlib.blake2b(text.encode(), digest_size=size).hexdigest()


def _text(value: Any, known: dict[int, str], leave: frozenset[str] | set[str] = frozenset()) -> str:
    """A value in words that are the same in every run; shapes that bodies share are put into words once."""
    if isinstance(value, tuple):
        if id(value) not in known:
            known[id(value)] = f"({','.join(_text(entry, known) for entry in value)})"
        return known[id(value)]
    if not is_dataclass(value):
        return repr(value)
    kind: Any = type(value)
    said = [(name, getattr(value, name), default) for name, default in _fields(kind) if name not in leave]
    words = [f"{name}={_text(entry, known)}" for name, entry, default in said if entry != default]
    return f"{kind.__name__}({','.join(words)})"


@cache
def _fields(kind: type[Any]) -> tuple[tuple[str, Any], ...]:
    """Names and defaults of what counts."""
    rows = [(item.name, _default(item)) for item in fields(kind) if item.compare]
    return tuple(row for row in rows if row[0] not in _SILENT)


def _default(item: Any) -> Any:
    return item.default_factory() if item.default_factory is not MISSING else item.default
