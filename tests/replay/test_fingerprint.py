"""Fingerprints: they see every bit of what moves, in the right group, and nothing of how records are laid out."""

from __future__ import annotations

import numpy as np
import pytest

import sandbox
from sandbox.replay.recording.fingerprint import GROUPS, columns, fingerprint, first_difference, group_of
from sandbox.tables import Table
from sandbox.world.joint_records import JOINT
from sandbox.world.records import BODY, CONTACT, DRAG, TABLES
from tests.replay.played import COMMANDS, scene


@pytest.fixture(scope="module")
def world() -> sandbox.World:
    world = sandbox.World(scene())
    for step in range(25):
        for at, command in COMMANDS:
            if at == step:
                world.apply(command)
        world.step()
    assert len(world.contacts) > 1
    assert (world.state.drags.body >= 0).any()
    return world


@pytest.mark.parametrize(
    ("table", "rows"), [(BODY, "bodies"), (CONTACT, "contacts"), (JOINT, "joints"), (DRAG, "drags")]
)
def test_the_last_bit_of_every_hashed_column_changes_its_group_and_no_other(
    world: sandbox.World, table: Table, rows: str
) -> None:
    before = fingerprint(world.state).split(" ")
    records = getattr(world.state, rows)
    for name in table.hashed_fields:
        value = records[name][0]
        records[name][0] = np.nextafter(value, 0.0 if value else 1.0) if records[name].dtype.kind == "f" else value + 1
        changed = [
            group for group, a, b in zip(GROUPS, before, fingerprint(world.state).split(" "), strict=True) if a != b
        ]
        records[name][0] = value
        assert changed == [group_of(table, name)], name


def test_every_hashed_column_has_a_group() -> None:
    in_rest = {table.name for table in TABLES for name in table.hashed_fields if group_of(table, name) == "rest"}
    assert not in_rest & {"body", "contact", "joint", "drag"}
    assert {group_of(CONTACT, name) for name in CONTACT.hashed_fields} == {"pairs", "manifolds", "impulses"}
    assert "normal_impulse1" in columns(CONTACT, "impulses")
    assert "separation2" in columns(CONTACT, "manifolds")


def test_the_order_of_columns_in_a_record_does_not_matter(
    monkeypatch: pytest.MonkeyPatch, world: sandbox.World
) -> None:
    from sandbox.replay.recording import fingerprint as room

    before = fingerprint(world.state)
    turned = Table("body", tuple(reversed(BODY.fields)))
    bodies = turned.zeros(len(world.state.bodies))
    for name in BODY.dtype.names or ():
        bodies[name] = world.state.bodies[name]
    monkeypatch.setattr(room, "_POSES", room._places(turned, "poses"))
    monkeypatch.setattr(world.state, "bodies", bodies)
    assert fingerprint(world.state) == before


def test_flips_of_signs_in_pairs_do_not_cancel(world: sandbox.World) -> None:
    before = fingerprint(world.state)
    column = world.state.bodies["force_x"]
    assert not column.any()
    for pair in ((0, 1), (1, 2), (0, 4)):
        column[list(pair)] = -0.0
        assert fingerprint(world.state) != before
        column[:] = 0.0
    assert fingerprint(world.state) == before


def test_spare_contact_rows_do_not_count(world: sandbox.World) -> None:
    before = fingerprint(world.state)
    spare = world.state.contacts[len(world.contacts) :]
    assert len(spare)
    spare.normal_x = 7.0
    assert fingerprint(world.state) == before


def test_first_difference_names_the_first_group_in_the_order_of_the_step() -> None:
    assert first_difference("0000 1111 2222 3333", "0000 1111 2222 3333") is None
    assert first_difference("0000 1111 2222 3333", "0000 1111 222a 333a") == ("impulses", "2222", "222a")
    assert first_difference("0000 1111 2222 3333", "000a 1111 2222 333a") == ("pairs", "0000", "000a")
