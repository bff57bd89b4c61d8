"""A whole state as bytes, and back. The layout hash keeps a snapshot from being read by another layout."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Callable, Iterator
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from sandbox.errors import SnapshotError
from sandbox.scene.flat import FlatBody, FlatJoint, FlatRegion, FlatScene
from sandbox.tables import Records, plain
from sandbox.world.census import Census
from sandbox.world.records import TABLES
from sandbox.world.roster import Roster
from sandbox.world.soundness import check_tables
from sandbox.world.state import ARRAYS, State

_MAGIC = b"SBX3"


def layout_hash() -> bytes:
    """Hash of every table's name and columns, 8 bytes."""
    text = ";".join(f"{table.name}:{table.dtype.descr}" for table in TABLES)
    return hashlib.blake2b(text.encode(), digest_size=8).digest()


_LAYOUT = layout_hash()
_VARYING = ("contact", "sensing", "edge")
"""Tables that have more or fewer rows whoever is there."""


def snapshot(state: State) -> bytes:
    """Bytes of all records: magic, layout hash, checksum, the world's origin, then for each table its row count and its
    rows, and the roster: its length and its text, which is empty while nothing has been spawned or deleted."""
    parts: list[Any] = []
    for rows in _in_use(state):
        parts += [struct.pack("<q", len(rows)), rows.view(np.uint8)]
    text = state.roster.text
    parts += [struct.pack("<q", len(text)), text]
    return b"".join([_MAGIC, _LAYOUT, checksum(*parts), state.origin, *parts])


def checksum(*parts: Any) -> bytes:
    """What tells a damaged snapshot, or one of another world: CRC-32, for it is quick; 4 bytes."""
    code = 0
    for part in parts:
        code = crc32(part, code)
    return struct.pack("<I", code)


def origin(scene: FlatScene, shapes: Records, vertices: Records) -> bytes:
    """What tells a world of this scene from others: who is in it, and the outlines of their shapes; 4 bytes."""
    everybody: tuple[FlatBody | FlatJoint | FlatRegion, ...] = (*scene.bodies, *scene.joints, *scene.regions)
    ids = "\n".join(each.id for each in everybody)
    columns = (np.ascontiguousarray(plain(shapes)[name]) for name in ("body", "radius"))
    return checksum(ids.encode(), *columns, plain(vertices).view(np.uint8))


def restore(state: State, data: bytes, read: Callable[[bytes], Roster]) -> None:
    """Put a snapshot back into a state that began with the same scene; `read` makes a roster of its text.

    Raises `SnapshotError`, and changes nothing, if it can't be done.
    """
    rows, text = _parts(_checked_body(state, data))
    roster = state.roster if text == state.roster.text else read(text)
    _check(state, roster, rows)
    # What the world has in its tables is sound: most of them are as they were when the snapshot was taken.
    kept = _kept(state, rows) if roster is state.roster else {}
    check_tables(rows, kept)
    if roster is not state.roster:
        state.census = Census(roster)
        state.layout += 1
    elif "shape" not in kept and not np.array_equal(rows["shape"]["density"], state.shapes.density):
        state.layout += 1  # centres of mass, from which vertices are measured, lie elsewhere
    if "body" not in kept:
        state.tiling = None  # tiles may be others, or lie elsewhere
    if "joint" not in kept:
        state.joined = None
    for table, name in zip(TABLES, ARRAYS, strict=True):
        if table.name in kept:
            continue
        array, values = getattr(state, name), rows[table.name]
        if len(values) > len(array) or (len(values) < len(array) and table.name != "contact"):
            array = table.zeros(len(values))
            setattr(state, name, array)
        # As bytes: numpy copies records field by field, which takes six times as long.
        plain(array)[: len(values)].view(np.uint8)[:] = values.view(np.uint8)


def _kept(state: State, rows: dict[str, Any]) -> set[str]:
    """The tables whose rows in a snapshot are those that a state has, bit for bit."""
    return {table.name for table, own in zip(TABLES, _in_use(state), strict=True) if _are_alike(rows[table.name], own)}


def _are_alike(rows: NDArray[Any], others: NDArray[Any]) -> bool:
    return len(rows) == len(others) and bool((rows.view(np.int64) == others.view(np.int64)).all())


def _in_use(state: State) -> Iterator[NDArray[Any]]:
    """The rows of every table, without the spare ones of contacts, which may tell of bodies that have gone."""
    for table, array in zip(TABLES, state.arrays, strict=True):
        rows = plain(array)
        yield rows[: int(plain(state.counters)["contact_count"][0])] if table.name == "contact" else rows


def _parts(body: memoryview) -> tuple[dict[str, Any], bytes]:
    """The rows of every table, and the text of the roster."""
    rows = {}
    offset = 0
    for table in TABLES:
        count = _count(body, offset, table.dtype.itemsize, f"{table.name} table")
        rows[table.name] = np.frombuffer(body, table.dtype, count, offset + 8)
        offset += 8 + count * table.dtype.itemsize
    length = _count(body, offset, 1, "roster")
    fits = len(rows["counters"]) == 1 and rows["counters"]["contact_count"][0] == len(rows["contact"])
    if offset + 8 + length != len(body) or not fits:
        raise SnapshotError("the snapshot is damaged: its tables do not fit together")
    return rows, bytes(body[offset + 8 :])


def _check(state: State, roster: Roster, rows: dict[str, Any]) -> None:
    """Whether the tables are as long as the world and the roster want them."""
    wanted = {table.name: len(array) for table, array in zip(TABLES, state.arrays, strict=True)}
    if roster is not state.roster:
        wanted |= _lengths(roster) | {name: len(rows[name]) for name in ("outline", "seam")}
    for name, count in wanted.items():
        if name not in _VARYING and len(rows[name]) != count:
            raise SnapshotError(f"the snapshot holds {len(rows[name])} {name} rows, this world {count}")


def _lengths(roster: Roster) -> dict[str, int]:
    bodies = roster.bodies.items
    shapes = [shape for body in bodies for shape in body.shapes]
    return {
        "body": len(bodies),
        "joint": len(roster.joints.items),
        "shape": len(shapes),
        "vertex": sum(len(shape.vertices) for shape in shapes),
        "region": len(roster.regions.items),
        "edge": sum(len(region.edges) for region in roster.regions.items),
        "path": sum(body.path is not None for body in bodies),
        "thruster": sum(len(body.thrusters) for body in bodies if body.type == "dynamic"),
    }


def _count(body: memoryview, offset: int, size: int, what: str) -> int:
    """How many rows of `size` bytes there are at `offset`, checked against the bytes that are there."""
    room = len(body) - offset - 8
    count = int(struct.unpack_from("<q", body, offset)[0]) if room >= 0 else -1
    if count < 0 or count * size > room:
        raise SnapshotError(f"the snapshot is damaged: its {what} is cut off")
    return count


def _checked_body(state: State, data: bytes) -> memoryview:
    header = len(_MAGIC) + 16
    if len(data) < header or data[:3] != _MAGIC[:3]:
        raise SnapshotError("this is not a snapshot of a sandbox world")
    if data[: len(_MAGIC)] != _MAGIC:
        raise SnapshotError("the snapshot was taken by a version with another snapshot format")
    if data[len(_MAGIC) : len(_MAGIC) + 8] != _LAYOUT:
        raise SnapshotError("the snapshot was taken by a version with another record layout")
    body = memoryview(data)[header:]
    if checksum(body) != data[header - 8 : header - 4]:
        raise SnapshotError("the snapshot is damaged: its checksum does not match")
    if data[header - 4 : header] != state.origin:
        raise SnapshotError("the snapshot is of a world of another scene: other bodies, joints, regions or shapes")
    return body
