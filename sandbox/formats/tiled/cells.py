"""The cells of a tile layer, whichever way they are packed."""

from __future__ import annotations

import base64
import binascii
import zlib
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.tiled.zstd import ZstdError, decompress

MAX_CELLS = 4_000_000
"""Cells of a layer, empty ones included."""
FLIPPED_X, FLIPPED_Y, SWAPPED = 1 << 31, 1 << 30, 1 << 29
"""The upper bits of a cell: mirrored left to right, top to bottom, and along the diagonal, which comes first."""
TURNED = 1 << 28
"""On hexagonal maps: turned by 120 degrees; there `SWAPPED` is a turn by 60."""
NUMBER = (1 << 28) - 1
"""The lower bits of a cell: the number of its tile."""


class Cell(NamedTuple):
    """A cell that holds a tile: where, the tile's number over all tilesets, and its three flip bits."""

    column: int
    row: int
    tile: int
    flips: int


def cells_of(layer: Node) -> Iterator[Cell]:
    """Every cell with a tile, in the order of the file. Raises `MisreadError`."""
    chunks = list(layer.nodes("chunks"))
    for part in chunks or [layer]:
        left, top = (part.whole("x"), part.whole("y")) if chunks else (0, 0)
        width, height = part.whole("width"), part.whole("height")
        if not (0 <= width * height <= MAX_CELLS and width >= 0):
            raise MisreadError((*part.path, "width"), f"has {width} x {height} cells; {MAX_CELLS} is the limit")
        numbers = _numbers(part, layer, width * height)
        for index in np.flatnonzero(numbers).tolist():
            row, column = divmod(index, width)
            value = int(numbers[index])
            yield Cell(left + column, top + row, value & NUMBER, value & ~NUMBER)


def _numbers(part: Node, layer: Node, count: int) -> np.ndarray[tuple[int], np.dtype[np.uint32]]:
    data, path = part.value("data"), (*part.path, "data")
    if data is None:
        return np.zeros(0, np.uint32)
    if isinstance(data, str):
        packing = layer.text("compression")
        raw = _unpacked(data, packing, 4 * count, path)
        found = np.frombuffer(raw, "<u4")
    elif isinstance(data, list):
        if not all(isinstance(value, int) and 0 <= value < 1 << 32 for value in data):
            raise MisreadError(path, "must be whole numbers of 32 bits")
        found = np.array(data, np.uint32)
    else:
        raise MisreadError(path, "must be a list of numbers, or text")
    if len(found) != count:
        raise MisreadError(path, f"has {len(found)} cells; its width and height say {count}")
    return found


def _unpacked(text: str, packing: str, size: int, path: tuple[str | int, ...]) -> bytes:
    """At most one byte more than `size`, whatever it would unpack to."""
    try:
        raw = base64.b64decode("".join(text.split()), validate=True)
    except (binascii.Error, ValueError):
        raise MisreadError(path, "is not base64") from None
    if packing in ("zlib", "gzip"):
        try:
            raw = zlib.decompressobj(zlib.MAX_WBITS | 32).decompress(raw, size + 1)
        except zlib.error as error:
            raise MisreadError(path, f"cannot be unpacked: {error}") from None
    elif packing == "zstd":
        try:
            raw = decompress(raw, size + 1)
        except ZstdError as error:
            raise MisreadError(path, f"cannot be unpacked: {error}") from None
    elif packing:
        raise MisreadError(path, f'is packed in a way that is not known: "{packing[:20]}"')
    if len(raw) != size:
        raise MisreadError(path, f"has {len(raw)} bytes or more; its width and height say {size}")
    return raw
