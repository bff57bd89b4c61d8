"""Copies of bodies and of the joints among them, as entries that `Spawn` takes: to duplicate, to copy and to paste."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from sandbox.arguments import checked_list
from sandbox.errors import ArgumentError
from sandbox.geometry.checks import checked_point
from sandbox.scene.limits import MAX_NAME
from sandbox.scene.scene import Scene
from sandbox.world.checked_world import check_world
from sandbox.world.directory import Directory
from sandbox.world.export.body_words import body_words
from sandbox.world.export.joint_words import joint_words, lasting
from sandbox.world.export.numbers import pair
from sandbox.world.export.present import AnyWorld, Present
from sandbox.world.state import State

Vec = tuple[float, float]
Words = dict[str, Any]
Entries = tuple[list[Words], list[Words]]
"""Entries of `bodies` and of `joints`."""

_COPY = re.compile(r"-copy(-\d+)?$")
_POINTS = ("anchor", "target")
_PAIRS = ("anchors", "wheels")


class NamedWorld(AnyWorld, Protocol):
    """A world that finds its bodies by their ids."""

    @property
    def directory(self) -> Directory:
        """From ids to rows."""


def copy_of(
    world: NamedWorld, bodies: str | Sequence[str], offset: Vec = (0.0, 0.0), scene: Scene | None = None
) -> Entries:
    """Entries for `Spawn` that make copies of bodies as they are now, `offset` (m) away, under ids that are free.

    The joints that hold nothing but these bodies and the world come with them, and so do gears on such joints. `scene`
    is the one that the world was made of, if it does not know it. Raises `UnknownBodyError`, `ShapeError` for an offset
    that is none, and `ArgumentError` if the world was not made of a `Scene`, and for what is no world or no list.
    """
    present = Present("copy_of", world, scene)
    offset = checked_point("copy_of", "the offset", offset)
    names = [bodies] if isinstance(bodies, str) else checked_list("copy_of", "an id, or a list of ids", bodies)
    rows = list(dict.fromkeys(world.directory.body(name) for name in names))
    inner = _inner(present, rows)
    entries = [body_words(present, row) for row in rows], [joint_words(present, row) for row in inner]
    return paste_of(world, *entries, offset)


def paste_of(world: NamedWorld, bodies: Sequence[Words], joints: Sequence[Words], offset: Vec = (0.0, 0.0)) -> Entries:
    """The same entries, such as `copy_of` gave before, `offset` (m) away and under ids that are free in `world` now.

    Raises `ShapeError` for an offset that is none, and `ArgumentError` for other entries, and what is no world.
    """
    check_world("paste_of", world)
    offset = checked_point("paste_of", "the offset", offset)
    bodies, joints = (
        checked_list("paste_of", "entries as copy_of gives them", entries) for entries in (bodies, joints)
    )
    try:
        return _pasted(world.state, bodies, joints, offset)
    except (LookupError, TypeError, AttributeError):
        raise ArgumentError(
            "paste_of: takes entries as copy_of gives them: joints hold only what comes along"
        ) from None


def _pasted(state: State, bodies: Sequence[Words], joints: Sequence[Words], offset: Vec) -> Entries:
    body_ids = _free([entry["id"] for entry in bodies], state.names)
    joint_ids = _free([entry["id"] for entry in joints], state.joint_names)
    placed = [
        {**entry, "id": body_ids[entry["id"]], "position": _shifted(entry.get("position", (0.0, 0.0)), offset)}
        for entry in bodies
    ]
    return placed, [_placed_joint(entry, body_ids, joint_ids, offset) for entry in joints]


def _inner(present: Present, rows: Sequence[int]) -> list[int]:
    """The joints that hold nothing but some bodies and the world, and gears on such joints."""
    joints: Any = present.state.joints
    chosen = np.zeros(len(present.state.bodies) + 1, np.bool_)
    chosen[[*rows, -1]] = True
    held = [row for row in lasting(present) if chosen[joints.body_a[row]] and chosen[joints.body_b[row]]]
    inside = {row for row in held if joints.joint_1[row] < 0}
    coupled = {row for row in held if {int(joints.joint_1[row]), int(joints.joint_2[row])} <= inside}
    return sorted(inside | coupled)


def _free(names: Sequence[str], taken: Collection[str]) -> dict[str, str]:
    """For each id one that nobody has: `crate-copy`, then `crate-copy-2`."""
    used, found = set(taken), {}
    for name in names:
        stem, number = _COPY.sub("", name), 1
        while (fresh := _numbered(stem, number)) in used:
            number += 1
        used.add(fresh)
        found[name] = fresh
    return found


def _numbered(stem: str, number: int) -> str:
    end = "-copy" if number == 1 else f"-copy-{number}"
    return stem[: MAX_NAME - len(end)] + end


def _placed_joint(entry: Words, bodies: Mapping[str, str], joints: Mapping[str, str], offset: Vec) -> Words:
    """A joint between the copies, whose places in the world are shifted."""
    found = {**entry, "id": joints[entry["id"]]}
    if "joints" in entry:
        return {**found, "joints": [joints[name] for name in entry["joints"]]}
    found["bodies"] = [name if name is None else bodies[name] for name in entry["bodies"]]
    for name in _POINTS:
        if name in entry:
            found[name] = _shifted(entry[name], offset)
    for name in _PAIRS:
        if name in entry:
            found[name] = [_shifted(point, offset) for point in entry[name]]
    return found


def _shifted(point: Sequence[float], offset: Vec) -> list[float]:
    return pair(point[0] + offset[0], point[1] + offset[1])
