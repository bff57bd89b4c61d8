"""Snapshots: complete, exact, and refused whenever anything about them is wrong."""

from __future__ import annotations

import json
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import Delete, Spawn
from sandbox.engine.world import World
from sandbox.errors import SandboxError, SnapshotError
from sandbox.world.build import build_state
from sandbox.world.digest import digest
from sandbox.world.snapshot import checksum, layout_hash, restore, snapshot
from tests.flat import body, box, circle, ground, scene


def small():
    """A ball and a box about to touch the ground."""
    return scene(
        ground(), body("ball", circle(0.5), position=(0.0, 0.5)), body("box", box(1.0, 1.0), position=(2.0, 0.5))
    )


@pytest.fixture(scope="module")
def world() -> World:
    """A world with contacts."""
    world = World(small())
    world.step(7)
    assert len(world.contacts) == 2
    return world


def test_a_snapshot_restores_every_byte(world):
    saved, before = world.snapshot(), world.digest()
    world.step(5)
    assert world.digest() != before
    world.restore(saved)
    assert world.digest() == before
    assert world.snapshot() == saved


def test_a_snapshot_does_not_change_as_the_world_goes_on(world):
    saved = world.snapshot()
    copy = bytes(saved)
    world.step(3)
    assert saved == copy


def refused(world: World, data: bytes) -> None:
    """The snapshot is refused with a clear error, and the world stays as it was."""
    before, contacts = world.digest(), len(world.state.contacts)
    with pytest.raises(SnapshotError) as caught:
        world.restore(data)
    assert isinstance(caught.value, SandboxError)
    assert len(str(caught.value)) > 10
    assert world.digest() == before
    assert len(world.state.contacts) == contacts


@given(st.data())
def test_any_flipped_bit_is_refused(world, data):
    saved = bytearray(world.snapshot())
    for place in data.draw(st.sets(st.integers(0, len(saved) - 1), min_size=1, max_size=8)):
        saved[place] ^= data.draw(st.integers(1, 255))
    refused(world, bytes(saved))


@given(st.data())
def test_any_truncation_or_addition_is_refused(world, data):
    saved = world.snapshot()
    cut = data.draw(st.integers(0, len(saved) - 1))
    refused(world, saved[:cut])
    refused(world, saved + data.draw(st.binary(min_size=1, max_size=20)))


@given(st.binary(max_size=300))
def test_foreign_bytes_are_refused(world, junk):
    refused(world, junk)


def signed(world: World, payload: bytes) -> bytes:
    """A payload with the header of an honest snapshot: what a checksum alone cannot catch."""
    return b"SBX3" + layout_hash() + checksum(payload) + world.state.origin + payload


@given(st.binary(max_size=200))
def test_well_signed_nonsense_is_refused(world, payload):
    refused(world, signed(world, payload))


@pytest.mark.parametrize("count", [-1, -(2**40), 2**40, 2**62, 10**6])
def test_a_well_signed_wrong_row_count_is_refused(world, count):
    payload = world.snapshot()[20:]
    refused(world, signed(world, struct.pack("<q", count) + payload[8:]))


def test_a_well_signed_wrong_number_of_contacts_is_refused(world):
    """The contact table may have any length, so its count must agree with the counters and with the bytes."""
    honest = world.snapshot()[20:]
    state = world.state
    before = state.bodies, state.shapes, state.vertices, state.outlines, state.seams
    offset = sum(8 + table.nbytes for table in before)
    assert struct.unpack_from("<q", honest, offset) == (2,)
    for count in (-1, 0, 1, 3, 2**40):
        refused(world, signed(world, honest[:offset] + struct.pack("<q", count) + honest[offset + 8 :]))


OTHERS = {
    "fewer bodies": (ground(), body("ball", circle(0.5))),
    "another size": (ground(), body("ball", circle(0.6)), body("crate", box(1.0, 1.0))),
    "another name": (ground(), body("ball", circle(0.5)), body("chest", box(1.0, 1.0))),
}


@pytest.mark.parametrize("other", OTHERS.values(), ids=list(OTHERS))
def test_a_snapshot_of_another_scene_is_refused(other):
    here = World(scene(ground(), body("ball", circle(0.5)), body("crate", box(1.0, 1.0))))
    refused(here, World(scene(*other)).snapshot())


def test_a_snapshot_of_another_layout_is_refused(world):
    saved = world.snapshot()
    refused(world, saved[:4] + bytes(8) + saved[12:])


def test_restoring_more_contacts_than_there_is_room_for():
    boxes = [body(f"{i}", box(1.0, 1.0), position=(0.9 * (i % 6), 0.45 + 0.9 * (i // 6))) for i in range(36)]
    crowded = World(scene(ground(), *boxes))
    crowded.step(3)
    assert len(crowded.contacts) > 60
    state = build_state(scene(ground(), *boxes))
    state.contacts = state.contacts[:16]
    restore(state, crowded.snapshot(), lambda text: state.roster)
    assert digest(state) == crowded.digest()
    assert snapshot(state) == crowded.snapshot()


def test_equal_states_have_equal_digests_and_spare_rows_do_not_count(world):
    state = build_state(small())
    first = digest(state)
    state.contacts[5].normal_x = 3.0
    assert digest(state) == first
    assert digest(build_state(small())) == first
    assert len(first) == 16
    assert int(first, 16) >= 0


BALL = {"id": "late", "shapes": [{"circle": 0.5}], "position": [5, 0.5]}


def changed() -> World:
    """The small world without its box and with a ball more."""
    world = World(small())
    world.apply(Delete("box"))
    world.apply(Spawn(BALL))
    world.step(7)
    return world


def with_roster(world: World, text: bytes) -> bytes:
    """A well-signed snapshot whose roster says something else."""
    payload = world.snapshot()[20:]
    own = world.state.roster.text
    return signed(world, payload[: -8 - len(own)] + struct.pack("<q", len(text)) + text)


def test_a_roster_goes_with_the_snapshot():
    world, fresh = changed(), World(small())
    fresh.restore(with_roster(world, world.state.roster.text))
    assert fresh.names == ("ground", "ball", "late")
    assert fresh.snapshot() == world.snapshot()
    fresh.restore(World(small()).snapshot())
    assert fresh.names == ("ground", "ball", "box")


def says(left: object, spawned: object, following: object) -> str:
    """The text of a roster of bodies without joints."""
    bodies = {"left": left, "spawned": spawned, "next": following}
    return json.dumps({"bodies": bodies, "joints": {"left": [], "spawned": [], "next": 0}})


DISC = [{"circle": 0.5}]


@pytest.mark.parametrize(
    "text",
    [
        *("", "{", "[]", "3", "null", "{}", "\xff", "[" * 100_000, '{"bodies": 3, "joints": 4}'),
        says([[0, 9]], [], 3),
        says([[1, 2], [0, 1]], [], 3),
        says([[-1, 2]], [], 3),
        says([["a", "b"]], [], 3),
        says([[0, 2]], [[3, {"id": "late"}]], 4),
        says([[0, 2]], [[3, {"id": "ball", "shapes": DISC}]], 4),
        says([[0, 2]], [[2, {"id": "late", "shapes": DISC}]], 4),
        says([[0, 2]], [[3, {"id": "late", "shapes": DISC}]], 3),
        says([[0, 2]], [[True, {"id": "late", "shapes": DISC}]], 9),
        says([[0, 2]], [[3, {"id": "late", "shapes": [{"box": [1, 1]}]}]], 4),
    ],
    ids=range(19),
)
def test_a_well_signed_wrong_roster_is_refused(text):
    source, world = changed(), World(small())
    layout = world.layout
    data = with_roster(source, text.encode("latin-1"))
    with pytest.raises(SnapshotError):
        source.restore(data)
    if text:
        refused(world, data)
        assert world.layout == layout
        assert world.names == ("ground", "ball", "box")


@given(st.binary(max_size=60))
def test_a_well_signed_roster_of_junk_is_refused(junk):
    source = changed()
    if junk:
        refused(source, with_roster(source, junk))
