"""Every number in which two states differ, by the ids that people know."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, TypeAlias

from sandbox.engine.world import World
from sandbox.replay.golden.divergence import Difference, ulps_between
from sandbox.replay.recording.fingerprint import GROUPS, group_of
from sandbox.tables import Records, Table
from sandbox.world.field_records import REGION, THRUSTER
from sandbox.world.joint_records import JOINT
from sandbox.world.records import BODY, CONTACT, DRAG, DYNAMIC, SETTINGS, SHAPE

Row: TypeAlias = tuple[str, Any]
"""The body that a record is about, and the record."""

INDICES = {"body", "body_a", "body_b", "shape_a", "shape_b", "vertex_start", "joint_1", "joint_2", "first_edge"}
"""Columns that hold row numbers: bodies added before would change them, though nothing else did."""


def differences(group: str, expected: World, got: World) -> Iterator[Difference]:
    """What differs in a group, or in what no group covers ("rest"), in the order of the records."""
    if group == "pairs":
        yield from _pairs(expected, got)
        return
    for table in _TABLES:
        names = [name for name in table.hashed_fields if group_of(table, name) == group]
        if names:
            yield from _columns(table, names, _keyed(table, expected), _keyed(table, got))


def first_group(expected: World, got: World) -> str | None:
    """The first group, in the order of the step, with a difference; then "rest"; None if nothing differs."""
    groups = (*GROUPS, "rest")
    return next((group for group in groups if next(differences(group, expected, got), None) is not None), None)


def _pairs(expected: World, got: World) -> Iterator[Difference]:
    old, new = _keyed(CONTACT, expected), _keyed(CONTACT, got)
    for key in dict.fromkeys([*old, *new]):
        if (key in old) != (key in new):
            body, row = old.get(key) or new[key]
            depth = float(row.separation1)
            was, now = (depth, None) if key in old else (None, depth)
            yield Difference("contact", _title(key), body, "separation1", "m", was, now, None)


def _columns(table: Table, names: list[str], old: dict[Any, Row], new: dict[Any, Row]) -> Iterator[Difference]:
    units = {field.name: field.unit for field in table.fields}
    for key, (body, row) in old.items():
        other = new.get(key)
        if other is None:
            yield Difference(table.name, _title(key), body, "", "", 1, None, None)
            continue
        for name in names:
            a, b = row[name].item(), other[1][name].item()
            ulps = 0 if name in INDICES else _distance(a, b)
            if ulps:
                yield Difference(table.name, _title(key), body, name, units[name], a, b, ulps)
    for key in new:
        if key not in old:
            yield Difference(table.name, _title(key), new[key][0], "", "", None, 1, None)


def _distance(a: float | int, b: float | int) -> int:
    return ulps_between(a, b) if isinstance(a, float) and isinstance(b, float) else int(abs(a - b))


def _keyed(table: Table, world: World) -> dict[Any, Row]:
    """The records of a table by what they are called; of equal names the later ones get a number."""
    rows: dict[Any, Row] = {}
    for key, body, row in _named(table, world):
        count = 1
        while (*key, count) in rows:
            count += 1
        rows[*key, count] = (body, row)
    return rows


def _named(table: Table, world: World) -> Iterator[tuple[tuple[Any, ...], str, Any]]:
    state, names = world.state, world.names
    if table is BODY:
        yield from (((name,), name, row) for name, row in zip(names, state.bodies, strict=True))
    elif table is CONTACT:
        yield from _contacts(world)
    elif table is JOINT:
        for name, row in zip(world.joint_names, state.joints, strict=True):
            body = int(max(row.body_a, row.body_b))  # a gear has none of its own
            yield (name,), names[body] if body >= 0 else "", row
    elif table in (SHAPE, DRAG, THRUSTER):
        rows: Records = {SHAPE: state.shapes, DRAG: state.drags, THRUSTER: state.thrusters}[table]
        yield from (((names[row.body],), names[row.body], row) for row in rows if row.body >= 0)
    else:
        rows = state.settings if table is SETTINGS else state.regions
        yield from (((table.name,), "", row) for row in rows)


def _contacts(world: World) -> Iterator[tuple[tuple[Any, ...], str, Any]]:
    names, shapes, kinds = world.names, world.state.shapes, world.state.bodies.type
    first: dict[int, int] = {}
    for number, body in enumerate(shapes.body.tolist()):
        first.setdefault(body, number)
    for row in world.contacts:
        a, b = int(row.body_a), int(row.body_b)
        parts = (int(row.shape_a) - first[a], int(row.shape_b) - first[b])
        yield (f"{names[a]}, {names[b]}", *parts), names[a if kinds[a] == DYNAMIC else b], row


def _title(key: tuple[Any, ...]) -> str:
    return str(key[0])


_TABLES = (CONTACT, JOINT, DRAG, BODY, SHAPE, THRUSTER, REGION, SETTINGS)
