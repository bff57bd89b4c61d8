"""The calls of a recording, one after the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from sandbox.formats.b2rec.cursor import Cursor
from sandbox.formats.b2rec.header import Head
from sandbox.formats.b2rec.ops import OPS

_NO_CHANGE = ("Step", "StateHash", "RecordingBounds", "DestroyWorld", "ShapeTestPoint", "ShapeRayCast")


class Call(NamedTuple):
    """A call: its name in Box2D, its arguments if they were read, and the byte that it begins at."""

    name: str
    arguments: dict[str, Any]
    at: int

    @property
    def changes(self) -> bool:
        """Whether it does anything to the world."""
        return self.name not in _NO_CHANGE and not self.name.startswith("Query")


def calls(data: bytes, head: Head) -> Iterator[Call]:
    """All calls; arguments up to the first step, and of that. Raises `MisreadError` for damage."""
    cursor = Cursor(data, head.calls, len(data), head.double)
    stepped = False
    while cursor.at < len(data):
        start, cursor.end = cursor.at, len(data)
        code = cursor.value("U8")
        size = int.from_bytes(cursor.bytes(3), "little")
        if code not in OPS:
            cursor.at = start
            raise cursor.fault(f"a call of the unknown kind 0x{code:02X}")
        if size > len(data) - cursor.at:
            raise cursor.fault(f"a call of {size} bytes should follow, and the file ends before")
        cursor.end = cursor.at + size
        call = Call(OPS[code].name, {}, start)
        if not stepped and (call.changes or call.name == "Step"):
            call = call._replace(arguments=cursor.structure(OPS[code].fields))
            if cursor.at != cursor.end:
                raise cursor.fault(f"{call.name} is {cursor.end - cursor.at} bytes longer than it should be")
        cursor.at = cursor.end
        stepped = stepped or call.name == "Step"
        yield call
