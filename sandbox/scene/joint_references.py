"""What joints refer to: bodies and other joints; and that no two joints have the same id."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import chain, islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.body_check import unknown_body
from sandbox.scene.finding import COPIES, TAKEN, Finding, Path, quoted
from sandbox.scene.limits import MAX_FINDINGS, MAX_JOINTS, MAX_NAME
from sandbox.scene.names import BodyNames
from sandbox.scene.near_names import did_you_mean

_DECLARING = ("joints", "generate")
"""The fields that bring joints."""


def joint_references(data: dict[str, Any], ids: BodyNames, others: Collection[str] = ()) -> Iterator[Finding]:
    """A finding for every name in a joint that refers to nothing, and for every id that is taken.

    `others` are ids of joints that a world has besides.
    """
    joints = list(islice(plain.children(data.get("joints"), ("joints",)), MAX_JOINTS))
    known = _chain_ids(data) if ids.counted else {}
    for path, joint in joints:
        name = joint.get("id")
        if isinstance(name, str):
            if name in known or name in others:
                yield Finding((*path, "id"), f"the id {quoted(name)} is taken by another joint", lacks=(COPIES,))
            known.setdefault(name, path)
    for path, joint in joints:
        yield from _bodies(path, joint, ids)
        for place, name in plain.texts(joint.get("joints"), (*path, "joints")):
            if ids.counted and name not in known and name not in others and not ids.is_unread(name):
                near = did_you_mean(name, chain(known, others))
                yield Finding(place, f"no joint has the id {quoted(name)}", near, lacks=(*_DECLARING, TAKEN))


def joint_ids(data: dict[str, Any]) -> dict[str, Path]:
    """The ids of all joints, as far as they can be read, and where they are from."""
    joints = islice(plain.children(data.get("joints"), ("joints",)), MAX_JOINTS)
    return {**_chain_ids(data), **{str(joint.get("id")): path for path, joint in joints}}


def _chain_ids(data: dict[str, Any]) -> dict[str, Path]:
    """The ids of the hinges that chains make, as far as they can be read."""
    known: dict[str, Path] = {}
    for path, generator in plain.children(data.get("generate"), ("generate",)):
        name, count = generator.get("id"), generator.get("count")
        if "chain" not in generator or not isinstance(name, str) or not isinstance(count, int):
            continue
        if len(name) <= MAX_NAME and 0 < count <= MAX_JOINTS - len(known):
            pin = generator.get("pin", "none")
            first = 0 if pin in ("start", "both") else 1
            last = count if pin in ("end", "both") else count - 1
            known.update((f"{name}-joint-{k}", path) for k in range(first, last + 1))
    return known


def _bodies(path: Path, joint: dict[str, Any], ids: BodyNames) -> Iterator[Finding]:
    names = list(plain.texts(joint.get("bodies"), (*path, "bodies")))
    for place, name in names:
        if ids.counted and name not in ids and not ids.is_unread(name):
            yield unknown_body(name, place, ids)
    listed = joint.get("bodies")
    if isinstance(listed, (list, tuple)) and len(names) == 2 == len(listed) and names[0][1] == names[1][1]:
        yield Finding(names[1][0], f"{quoted(names[1][1])} cannot be joined to itself")
    if isinstance(listed, (list, tuple)) and listed and all(entry is None for entry in islice(listed, MAX_FINDINGS)):
        yield Finding((*path, "bodies"), "a joint needs at least one body")
    if joint.get("type") == "target" and isinstance(listed, (list, tuple)) and len(listed) == 2:
        yield Finding((*path, "bodies"), 'a target joint pulls one body: "bodies": ["id"]')
    yield from _ranges(path, joint)


def _ranges(path: Path, joint: dict[str, Any]) -> Iterator[Finding]:
    for low, high in (("lower", "upper"), ("min", "max")):
        least, most = joint.get(low), joint.get(high)
        if plain.is_number(least) and plain.is_number(most) and least > most:
            yield Finding((*path, low), f'"{low}" must not be greater than "{high}"')
