"""A whole state as bytes, and back. The layout hash keeps a snapshot from being read by another layout."""

from __future__ import annotations

import hashlib
import struct

import numpy as np

from sandbox.errors import SnapshotError
from sandbox.tables import Table
from sandbox.world.records import TABLES
from sandbox.world.state import State

_MAGIC = b"SBX1"


def layout_hash() -> bytes:
    """Hash of every table's name and columns, 8 bytes."""
    text = ";".join(f"{table.name}:{table.dtype.descr}" for table in TABLES)
    return hashlib.blake2b(text.encode(), digest_size=8).digest()


def snapshot(state: State) -> bytes:
    """Bytes of all records: magic, layout hash, checksum, then for each table its row count and its rows."""
    parts: list[bytes] = []
    for table, array in zip(TABLES, state.arrays, strict=True):
        rows = array[: int(state.counters[0].contact_count)] if table.name == "contact" else array
        parts += [struct.pack("<q", len(rows)), rows.tobytes()]
    body = b"".join(parts)
    return _MAGIC + layout_hash() + hashlib.blake2b(body, digest_size=8).digest() + body


def restore(state: State, data: bytes) -> None:
    """Put a snapshot back into a state of the same scene. Raises `SnapshotError` and changes nothing if it can't."""
    body = _checked_body(data)
    rows = []
    offset = 0
    for table, array in zip(TABLES, state.arrays, strict=True):
        count = _row_count(body, offset, table)
        if table.name != "contact" and count != len(array):
            raise SnapshotError(f"the snapshot holds {count} {table.name} rows, this world {len(array)}")
        rows.append(np.frombuffer(body, table.dtype, count, offset + 8))
        offset += 8 + count * table.dtype.itemsize
    names = [table.name for table in TABLES]
    contact_count = rows[names.index("counters")]["contact_count"][0]
    if offset != len(body) or contact_count != len(rows[names.index("contact")]):
        raise SnapshotError("the snapshot is damaged: its tables do not fit together")
    for table, array, values in zip(TABLES, state.arrays, rows, strict=True):
        if len(values) > len(array):
            state.contacts = array = table.zeros(len(values))
        array[: len(values)] = values


def _row_count(body: bytes, offset: int, table: Table) -> int:
    """Number of rows of the table at `offset`, checked against the bytes that are there."""
    room = len(body) - offset - 8
    count = int(struct.unpack_from("<q", body, offset)[0]) if room >= 0 else -1
    if count < 0 or count * table.dtype.itemsize > room:
        raise SnapshotError(f"the snapshot is damaged: its {table.name} table is cut off")
    return count


def _checked_body(data: bytes) -> bytes:
    header = len(_MAGIC) + 16
    if len(data) < header or data[: len(_MAGIC)] != _MAGIC:
        raise SnapshotError("this is not a snapshot of a sandbox world")
    if data[len(_MAGIC) : len(_MAGIC) + 8] != layout_hash():
        raise SnapshotError("the snapshot was taken by a version with another record layout")
    body = data[header:]
    if hashlib.blake2b(body, digest_size=8).digest() != data[header - 8 : header]:
        raise SnapshotError("the snapshot is damaged: its checksum does not match")
    return body
