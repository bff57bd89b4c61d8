"""The ids of all bodies of a scene: each once, and not more than the limit."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

from pydantic import ConfigDict, TypeAdapter, ValidationError

from sandbox.scene.finding import COPIES, Finding, Path, quoted
from sandbox.scene.generators import AnyGenerator, Generator, body_count, body_names, kind_of
from sandbox.scene.known import NOTHING, Known
from sandbox.scene.limits import MAX_BODIES
from sandbox.scene.plain import OCCASIONS, actions, children, mapping, spawns
from sandbox.scene.union import UNIONS

_GENERATOR: TypeAdapter[Generator] = TypeAdapter(AnyGenerator, config=ConfigDict(defer_build=True))


@dataclass
class BodyNames:
    """The path of the body or generator behind each id.

    `unread` begin the ids that may come from generators with mistakes of their own; `counted` is False
    where the scene is too large to name its bodies. `known` are the ids that a world has besides; `spawned` begin the
    ids of what rules and controls bring.
    """

    origins: dict[str, Path] = field(default_factory=dict)
    unread: Collection[str] = ()
    counted: bool = True
    findings: list[Finding] = field(default_factory=list)
    known: Collection[str] = ()
    spawned: Collection[str] = ()

    def is_spawned(self, name: str) -> bool:
        """Whether it is an id that rules or controls may give: that of an entry, and a number."""
        head, _, number = name.rpartition("-")
        return head in self.spawned and number.isascii() and number.isdigit() and number[0] != "0"

    def is_unread(self, name: str) -> bool:
        """Whether it may be an id of what a generator makes that cannot be read, or of a joint of that."""
        heads = (name[:end] for end in range(len(name) + 1) if name[end : end + 1] in ("", "-", "."))
        return "" in self.unread or any(head in self.unread for head in heads)

    def spawned_ids(self) -> list[str]:
        """The first ids that rules or controls may give."""
        return [f"{name}-1" for name in self.spawned]

    def __contains__(self, name: str) -> bool:
        return name in self.origins or name in self.known

    def __iter__(self) -> Iterator[str]:
        return chain(self.origins, self.known)

    def __len__(self) -> int:
        return len(self.origins) + len(self.known)

    def add(self, name: str, path: Path, place: Path) -> None:
        """Note an id, or the mistake that it is taken. `place` is where to point."""
        if name in self.known:
            self.findings.append(Finding(place, f"the id {quoted(name)} is taken by a body of the world"))
        elif name in self.origins:
            first = "".join(f"[{part}]" if isinstance(part, int) else part for part in self.origins[name])
            self.findings.append(Finding(place, f"the id {quoted(name)} is taken by {first}", lacks=(COPIES,)))
        else:
            self.origins[name] = path


def body_ids(data: dict[str, Any], known: Known = NOTHING) -> BodyNames:
    """All ids of the bodies of a scene's plain data and of `known`, or the mistakes that stand against them."""
    generators = list(_generators(data))
    found = BodyNames(unread=_unread(data, generators), known=known.types, spawned=_spawned(data))
    bodies = data.get("bodies")
    written = len(bodies) if isinstance(bodies, (list, tuple)) else 0
    total = len(known.types) + written + sum(body_count(generator) for _, generator in generators if generator)
    if total > MAX_BODIES:
        text = f"the scene has {total} bodies; {MAX_BODIES} is the limit"
        # A list of bodies that is too long by itself is told by its own model.
        place = "generate" if generators else "bodies"
        told = [Finding((place,), text)] if written <= MAX_BODIES else []
        return BodyNames(counted=False, findings=told)
    for path, body in children(bodies, ("bodies",)):
        if isinstance(body.get("id"), str):
            found.add(body["id"], path, (*path, "id"))
    for path, generator in generators:
        for name in body_names(generator) if generator else ():
            found.add(name, path, (*path, "id"))
    return found


def _spawned(data: dict[str, Any]) -> tuple[str, ...]:
    found = (entry.get("id") for _, entry in spawns(data))
    return tuple(dict.fromkeys(name for name in found if isinstance(name, str)))


def _unread(data: dict[str, Any], generators: list[tuple[Path, Generator | None]]) -> Collection[str]:
    raw = dict(children(data.get("generate"), ("generate",)))
    ids = [raw[path].get("id") for path, generator in generators if generator is None]
    heads = {name if isinstance(name, str) else "" for name in ids}
    return heads if _all_brought_are_read(data) else heads | {""}


def _all_brought_are_read(data: dict[str, Any]) -> bool:
    """Whether every action of rules and controls can be read as far as it may bring bodies."""
    rules, controls = data.get("rules", ()), data.get("controls", ())
    listed: list[Any] = [rules, controls]
    listed += [rule.get("do", ()) for _, rule in children(rules, ())]
    listed += [control.get(occasion, ()) for _, control in children(controls, ()) for occasion in OCCASIONS]
    if not all(isinstance(each, (list, tuple)) and all(isinstance(one, dict) for one in each) for each in listed):
        return False
    return all(_is_read(action) for _, action in actions(data))


def _is_read(action: dict[str, Any]) -> bool:
    if "spawn" in action:
        return isinstance(mapping(action["spawn"]).get("id"), str)
    return any(kind in action for kind in UNIONS["action"])


def _generators(data: dict[str, Any]) -> Iterator[tuple[Path, Generator | None]]:
    """Each generator with its path; None where it has mistakes of its own, or repeats what is not there."""
    prefabs = mapping(data.get("prefabs"))
    for path, generator in children(data.get("generate"), ("generate",)):
        try:
            found = _GENERATOR.validate_python(generator)
        except ValidationError:
            found = None
        yield path, found if found is not None and generator[kind_of(found)] in prefabs else None
