"""A fingerprint of a state after a step, in four groups, so that it says not only that but where two runs part.

Each group is 16 bits of a CRC-32 over the bits of its columns, taken by name and in alphabetical order, in words of
eight bytes: where a column lies in its record does not matter, but for whole numbers of four bytes, of which the word
has two. Sixteen bits miss one difference in 65,536; but what differs once differs in
thousands of steps, and a recording ends with a full digest.
"""

from __future__ import annotations

from typing import Any
from zlib import crc32

import numpy as np

from sandbox.tables import Integers, Records, Table, plain
from sandbox.world.joint_records import JOINT
from sandbox.world.records import BODY, CONTACT, DRAG
from sandbox.world.state import State

GROUPS = ("pairs", "manifolds", "impulses", "poses")
"""In the order of the step: which shapes are near, how they touch, what they exert, where bodies are."""

_PAIRS = ("body_a", "body_b", "shape_a", "shape_b")


def group_of(table: Table, field: str) -> str:
    """The group that a hashed column belongs to; "rest" for what only the full digest covers (settings, regions)."""
    if table is CONTACT:
        return "pairs" if field in _PAIRS else "impulses" if "impulse" in field else "manifolds"
    return {BODY.name: "poses", JOINT.name: "impulses", DRAG.name: "impulses"}.get(table.name, "rest")


def columns(table: Table, group: str) -> list[str]:
    """The names of a table's columns in a group, in alphabetical order."""
    return sorted(name for name in table.hashed_fields if group_of(table, name) == group)


def fingerprint(state: State) -> str:
    """Four times four hex digits, in the order of `GROUPS`: `1a2b 3c4d 5e6f 7081`."""
    contacts = _words(state.contacts)[: int(plain(state.counters)["contact_count"][0])]
    joints_and_drags = _crc(_words(state.drags), _DRAGS, _crc(_words(state.joints), _JOINTS))
    codes = (
        _crc(contacts, _CONTACT_PAIRS),
        _crc(contacts, _MANIFOLDS),
        _crc(contacts, _IMPULSES, joints_and_drags),
        _crc(_words(state.bodies), _POSES),
    )
    return " ".join([f"{(code ^ code >> 16) & 0xFFFF:04x}" for code in codes])


def first_difference(expected: str, got: str) -> tuple[str, str, str] | None:
    """(group, expected, got) of the first group in which two fingerprints differ; None if they are equal."""
    if expected == got:
        return None
    rows = zip(GROUPS, expected.split(" "), got.split(" "), strict=True)
    return next(row for row in rows if row[1] != row[2])


def _places(table: Table, group: str) -> Integers:
    return np.array(table.places(columns(table, group), 8), np.int64)


def _words(rows: Records) -> Any:
    """The bits of a table as whole numbers, a row a record."""
    return np.ndarray((len(rows), rows.itemsize // 8), np.int64, rows)


def _crc(words: Any, places: Integers, start: int = 0) -> int:
    """CRC-32 of some columns, continued from `start`."""
    if not len(words):
        return start
    return crc32(words.take(places, 1).astype("<i8", copy=False), start)


_CONTACT_PAIRS, _MANIFOLDS, _IMPULSES = (_places(CONTACT, group) for group in GROUPS[:3])
_JOINTS, _DRAGS, _POSES = _places(JOINT, "impulses"), _places(DRAG, "impulses"), _places(BODY, "poses")
