"""Snapshots whose checksum is right and whose numbers are not: refused with table, row and field; nothing changes."""

from __future__ import annotations

import struct
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.errors import SnapshotError
from sandbox.tables import FINITE, UNLIMITED, plain
from sandbox.world.records import TABLES
from sandbox.world.row_relations import _RELATIONS
from sandbox.world.snapshot import checksum
from tests.shipped import shipped

TABLE = {table.name: table for table in TABLES}


def test_every_whole_number_says_what_it_may_be() -> None:
    bare = [
        f"{t.name}.{f.name}" for t in TABLES for f in t.fields if f.kind != "f8" and f.values in (FINITE, UNLIMITED)
    ]
    assert bare == []


def test_every_row_points_into_a_table_that_there_is() -> None:
    for table in TABLES:
        names = {field.name for field in table.fields}
        for values in (field.values for field in table.fields if field.values.row_of):
            assert values.row_of in TABLE
            assert not values.count or values.count in names


@pytest.fixture(scope="module")
def worlds() -> dict[str, World]:
    """Worlds with contacts and sleepers, with gears, with regions and with seams."""
    found = {}
    for name, steps in (("pyramid-10", 90), ("gears-and-pulley", 5), ("harbour", 30), ("rolling-hills", 30)):
        found[name] = World(shipped(name))
        found[name].step(steps)
    return found


def changed(world: World, table: str, row: int, field: str, number: float) -> bytes:
    """A snapshot in which one number is another, with a checksum that fits."""
    saved = world.snapshot()
    payload, offset = bytearray(saved[20:]), 0
    for each in TABLES:
        (count,) = struct.unpack_from("<q", payload, offset)
        if each.name == table:
            kind, start = each.dtype.fields[field][:2]
            place = offset + 8 + (row % count) * each.dtype.itemsize + start
            payload[place : place + kind.itemsize] = np.array(number, kind).tobytes()
        offset += 8 + count * each.dtype.itemsize
    return saved[:12] + checksum(payload) + saved[16:20] + bytes(payload)


CASES = [
    ("pyramid-10", "shape", 3, "body", 56, "body is 56 in row 3 of its shape table, not 0 to 55"),
    ("pyramid-10", "shape", 3, "body", 1, "shapes are in the order of their bodies"),
    ("pyramid-10", "shape", 3, "vertex_count", 65, "vertex_count is 65 in row 3 of its shape table, not 1 to 64"),
    ("pyramid-10", "shape", 3, "vertex_count", 3, "cores lie one after the other"),
    ("pyramid-10", "shape", -1, "vertex_count", 9, "but there are 224 vertex rows"),
    ("pyramid-10", "body", 2, "island", 57, "island is 57 in row 2"),
    ("pyramid-10", "body", 2, "awake", -1, "awake is -1 in row 2"),
    (
        "pyramid-10",
        "body",
        2,
        "mass",
        float("nan"),
        "mass is nan in row 2 of its body table, which is no",
    ),
    (
        "pyramid-10",
        "body",
        4,
        "center_x",
        -1e308,
        "center_x is -1e+308 in row 4 of its body table, not -2000000000.0 to",
    ),
    ("pyramid-10", "vertex", 7, "x", float("inf"), "x is inf in row 7 of its vertex table"),
    ("pyramid-10", "contact", 4, "shape_b", 56, "shape_b is 56 in row 4 of its contact table, not 0 to 55"),
    ("pyramid-10", "contact", 4, "shape_b", 0, "contacts are in the order of their shapes"),
    ("pyramid-10", "contact", 4, "body_a", 40, "shape_a is of another one"),
    ("pyramid-10", "contact", 4, "point_count", 3, "point_count is 3 in row 4"),
    ("pyramid-10", "settings", 0, "substeps", 1 << 40, "substeps is 1099511627776 in row 0"),
    ("pyramid-10", "counters", 0, "asleep_count", 0, "more bodies are asleep"),
    ("gears-and-pulley", "joint", 0, "kind", 10, "kind is 10 in row 0 of its joint table, not 0 to 9"),
    ("gears-and-pulley", "joint", 0, "body_b", 99, "body_b is 99 in row 0"),
    ("gears-and-pulley", "joint", 0, "joint_1", 1, "a gear couples two joints"),
    ("gears-and-pulley", "joint", 0, "upper", float("nan"), "upper is nan in row 0 of its joint table"),
    ("harbour", "shape", 2, "seam_start", 21, "the seam table has too few rows"),
    ("harbour", "region", 0, "first_edge", 4, "but there are 5 edge rows"),
    ("harbour", "region", 0, "edge_count", -1, "edge_count is -1"),
    ("harbour", "region", 0, "edge_count", 3, "the half-planes of regions lie one after the other"),
    ("rolling-hills", "shape", 5, "seam_start", 1 << 40, "seam_start is 1099511627776 in row 5"),
    ("rolling-hills", "drag", 0, "body", 4, "body is 4 in row 0 of its drag table, not -1 to 3"),
]


@pytest.mark.parametrize(("name", "table", "row", "field", "number", "said"), CASES)
def test_a_number_that_cannot_be_is_refused(
    worlds: dict[str, World], name: str, table: str, row: int, field: str, number: float, said: str
) -> None:
    world = worlds[name]
    before = world.snapshot()
    with pytest.raises(SnapshotError) as caught:
        world.restore(changed(world, table, row, field, number))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert world.snapshot() == before


def test_any_number_that_may_be_there_comes_back(worlds: dict[str, World]) -> None:
    """What is huge is not taken for what is no number, though a sum of it is none."""
    world = worlds["pyramid-10"]
    saved = world.snapshot()
    forces = world.state.bodies.force_x.copy()
    world.state.bodies.force_x[1:3] = 1.7e308
    huge = world.snapshot()
    world.restore(saved)
    assert np.array_equal(world.state.bodies.force_x, forces)
    world.restore(huge)
    assert world.state.bodies.force_x[2] == 1.7e308
    world.restore(saved)


class _Watched(dict[str, Any]):
    """Tables that note who was asked for."""

    def __init__(self, rows: dict[str, Any]) -> None:
        super().__init__(rows)
        self.asked: set[str] = set()

    def __getitem__(self, name: str) -> Any:
        self.asked.add(name)
        return super().__getitem__(name)


def test_rules_look_into_no_other_tables_than_they_say(worlds: dict[str, World]) -> None:
    """Else a rule would be left out although a table that it looks into has changed."""
    for world in worlds.values():
        for table, others, _, fits, _ in _RELATIONS:
            rows = _Watched({t.name: plain(array) for t, array in zip(TABLES, world.state.arrays, strict=True)})
            if len(rows[table]):
                fits(rows)
                assert rows.asked <= {table, *others}


def test_spare_rows_of_contacts_are_not_taken_for_sound(worlds: dict[str, World]) -> None:
    """They may tell of bodies that have gone."""
    world = worlds["pyramid-10"]
    before, count = world.snapshot(), len(world.contacts)
    contacts, counters = plain(world.state.contacts), plain(world.state.counters)
    assert len(contacts) > count
    contacts[count] = contacts[count - 1]
    contacts["shape_b"][count] = 99
    counters["contact_count"] = count + 1
    unsound = world.snapshot()
    counters["contact_count"] = count
    with pytest.raises(SnapshotError, match="shape_b is 99"):
        world.restore(unsound)
    assert world.snapshot() == before


@pytest.mark.parametrize("name", ["pyramid-10", "gears-and-pulley", "harbour", "rolling-hills"])
def test_a_world_elsewhere_refuses_what_the_same_world_does(worlds: dict[str, World], name: str) -> None:
    """Tables that are as the world's own are not looked at again; those of another moment are."""
    elsewhere = World(shipped(name))
    elsewhere.step(3)
    for scene, table, row, field, number, said in CASES:
        if scene == name:
            with pytest.raises(SnapshotError) as caught:
                elsewhere.restore(changed(worlds[name], table, row, field, number))
            assert said in str(caught.value)
