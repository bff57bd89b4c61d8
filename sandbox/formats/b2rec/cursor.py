"""Values out of bytes, none past their end: what is missing or no number is told with its offset."""

from __future__ import annotations

import math
import struct
from typing import Any

from sandbox.formats.b2rec.layouts import LAYOUTS, PRIMITIVES, Fields
from sandbox.formats.reading import MisreadError

_FORMATS = {tag: struct.Struct(f"<{code}") for tag, code in PRIMITIVES.items()}
_NO_NAME = 0xFFFF


class Cursor:
    """Reads from `at` up to, and not including, the byte `end`. `double`: positions have 64 bits."""

    def __init__(self, data: bytes, at: int, end: int, double: bool = False) -> None:
        self.data, self.at, self.end = data, at, end
        self._position = "F64" if double else "F32"

    def fault(self, message: str) -> MisreadError:
        """The mistake, at this byte."""
        return MisreadError((), f"{message} (at byte {self.at})", "the recording is damaged: record it again")

    def bytes(self, count: int) -> bytes:
        """The next bytes. Raises `MisreadError` where there are fewer."""
        if not 0 <= count <= self.end - self.at:
            raise self.fault(f"{count} bytes should follow, and {self.end - self.at} are there")
        self.at += count
        return self.data[self.at - count : self.at]

    def value(self, tag: str) -> Any:
        """A number, a tuple of them, a text, a list, or a structure as a dict. Raises `MisreadError`."""
        if tag in _FORMATS:
            return self._primitive(tag)
        if tag == "POSITION":
            return self._primitive(self._position), self._primitive(self._position)
        if tag == "STR":
            return self._text()
        if tag.startswith("LIST-"):
            return self._listed(tag.removeprefix("LIST-"))
        return self.structure(LAYOUTS[tag])

    def structure(self, fields: Fields) -> dict[str, Any]:
        """All fields by their names. Raises `MisreadError`."""
        return {name: self.value(tag) for name, tag in fields}

    def _primitive(self, tag: str) -> Any:
        shape = _FORMATS[tag]
        found = shape.unpack(self.bytes(shape.size))
        # Corners that a polygon does not have are whatever was in memory.
        if tag != "POLYPOINTS" and not all(map(math.isfinite, found)):
            self.at -= shape.size
            raise self.fault("a number is not finite")
        return found[0] if len(found) == 1 else found

    def _text(self) -> str:
        length = self.value("U16")
        return "" if length == _NO_NAME else self.bytes(length).decode("utf-8", "replace")

    def _listed(self, tag: str) -> list[Any]:
        count = self.value("I32")
        # Each is a byte at least: no list is longer than what is left.
        if not 0 <= count <= self.end - self.at:
            self.at -= 4
            raise self.fault(f"a list cannot have {count} entries here")
        return [self.value(tag) for _ in range(count)]
