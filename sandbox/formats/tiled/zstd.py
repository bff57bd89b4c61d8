"""Unpacks Zstandard, which Python itself knows from 3.14 on only.

Source: RFC 8878, section 3. Frames with a dictionary are refused; checksums are not looked at.
"""

from __future__ import annotations

from sandbox.formats.tiled.zstd_bits import (
    Backwards,
    Fse,
    Huffman,
    ZstdError,
    fse_table,
    read_fse,
    read_huffman,
)

_FRAME, _SKIPPED = 0xFD2FB528, 0x184D2A5
_LENGTHS = ([4, 3] + [2] * 11 + [1] * 3 + [2] * 9 + [3, 2] + [1] * 5 + [-1] * 4, 6)
_OFFSETS = ([1] * 6 + [2] * 3 + [1] * 15 + [-1] * 5, 5)
_MATCHES = ([1, 4, 3] + [2] * 6 + [1] * 37 + [-1] * 7, 6)
_LENGTH_WIDTHS = [0] * 16 + [1, 1, 1, 1, 2, 2, 3, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]
_MATCH_WIDTHS = [0] * 32 + [1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]
_MOST = 128 * 1024
"""Bytes of a block."""


def decompress(data: bytes, most: int) -> bytes:
    """The bytes; it ends after `most` of them or a block more. Raises `ZstdError`."""
    found, at = bytearray(), 0
    while at < len(data) and len(found) <= most:
        magic = int.from_bytes(data[at : at + 4], "little")
        if magic >> 4 == _SKIPPED:
            at += 8 + int.from_bytes(data[at + 4 : at + 8], "little")
        elif magic == _FRAME:
            at = _Frame(data, at + 4, found, most).end()
        else:
            raise ZstdError("no frame begins where one should")
    return bytes(found)


class _Frame:
    def __init__(self, data: bytes, at: int, out: bytearray, most: int) -> None:
        head = data[at : at + 1]
        if not head or head[0] & 3 or head[0] & 8:
            raise ZstdError("a frame needs a dictionary, or is damaged")
        single, flag = bool(head[0] & 32), head[0] >> 6
        self._at = at + 1 + (not single) + (1, 2, 4, 8)[flag] * (flag > 0 or single)
        self._data, self._out, self._most, self._checked = data, out, most, bool(head[0] & 4)
        self._start = len(out)
        self._tree: Huffman | None = None
        self._tables: list[Fse | None] = [None, None, None]
        self._recent = [1, 4, 8]

    def end(self) -> int:
        """Unpack all blocks; where the frame ends."""
        last = False
        while not last and len(self._out) <= self._most:
            head = int.from_bytes(self._taken(3), "little")
            last, kind, size = bool(head & 1), (head >> 1) & 3, head >> 3
            if size > _MOST or kind == 3:
                raise ZstdError("a block is damaged")
            if kind == 0:
                self._out += self._taken(size)
            elif kind == 1:
                self._out += self._taken(1) * size
            else:
                self._block(self._taken(size))
        return self._at + 4 * self._checked

    def _taken(self, count: int) -> bytes:
        part = self._data[self._at : self._at + count]
        if len(part) < count:
            raise ZstdError("the data end too early")
        self._at += count
        return part

    def _block(self, block: bytes) -> None:
        literals, at = self._literals(block)
        rest = block[at:]
        if not rest:
            raise ZstdError("a block has no sequences")
        count, at = rest[0], 1
        if count >= 128:
            count, at = ((count - 128) << 8) + int.from_bytes(rest[1:2], "little"), 2
            if rest[0] == 255:
                count, at = int.from_bytes(rest[1:3], "little") + 0x7F00, 3
        if count:
            literals = self._sequences(rest[at:], count, literals)
        self._out += literals

    def _literals(self, block: bytes) -> tuple[bytes, int]:
        """The literals of a block, and how many bytes they take."""
        if not block:
            raise ZstdError("a block is empty")
        kind, form = block[0] & 3, (block[0] >> 2) & 3
        if kind < 2:
            size, shift = (1, 3) if form in (0, 2) else ((2, 4) if form == 1 else (3, 4))
            count = int.from_bytes(block[:size], "little") >> shift
            taken = count if kind == 0 else 1
            part = block[size : size + taken]
            if len(part) < taken or count > _MOST:
                raise ZstdError("literals are damaged")
            return (part if kind == 0 else part * count), size + taken
        size, width = ((3, 10), (3, 10), (4, 14), (5, 18))[form]
        head = int.from_bytes(block[:size], "little") >> 4
        count, packed = head & ((1 << width) - 1), head >> width
        part = block[size : size + packed]
        if len(part) < packed or count > _MOST:
            raise ZstdError("literals are damaged")
        if kind == 2:
            self._tree, start = read_huffman(part)
            part = part[start:]
        if self._tree is None:
            raise ZstdError("literals have no tree")
        return _streams(self._tree, part, count, form > 0), size + packed

    def _sequences(self, data: bytes, count: int, literals: bytes) -> bytes:
        """Put out sequences of literals and matches; the literals that are left."""
        lengths, offsets, matches, at = self._read_tables(data)
        stream, used = Backwards(data[at:]), 0
        length, offset, match = (stream.read(table.bits) for table in (lengths, offsets, matches))
        for k in range(count):
            code = offsets.symbols[offset]
            if code > 31:
                raise ZstdError("an offset is damaged")
            distance = (1 << code) + stream.read(code)
            many = _value(matches.symbols[match], _MATCH_WIDTHS, 3, stream)
            plain = _value(lengths.symbols[length], _LENGTH_WIDTHS, 0, stream)
            if used + plain > len(literals) or stream.left < 0:
                raise ZstdError("a sequence is damaged")
            self._out += literals[used : used + plain]
            used += plain
            self._copy(self._distance(distance, plain), many)
            if k + 1 < count:
                length = lengths.bases[length] + stream.read(lengths.widths[length])
                match = matches.bases[match] + stream.read(matches.widths[match])
                offset = offsets.bases[offset] + stream.read(offsets.widths[offset])
        if stream.left != 0:
            raise ZstdError("sequences are damaged")
        return literals[used:]

    def _read_tables(self, data: bytes) -> tuple[Fse, Fse, Fse, int]:
        """For lengths of literals, offsets and lengths of matches; and how many bytes they take."""
        if not data:
            raise ZstdError("tables are missing")
        modes, at = data[0], 1
        for k, (usual, most_bits) in enumerate(((_LENGTHS, 9), (_OFFSETS, 8), (_MATCHES, 9))):
            mode = (modes >> (6 - 2 * k)) & 3
            if mode == 0:
                self._tables[k] = fse_table(*usual)
            elif mode == 1:
                self._tables[k] = Fse(0, list(data[at : at + 1]) or [0], [0], [0])
                at += 1
            elif mode == 2:
                self._tables[k], size = read_fse(data[at:], most_bits)
                at += size
        lengths, offsets, matches = self._tables
        if lengths is None or offsets is None or matches is None:
            raise ZstdError("a table is missing")
        return lengths, offsets, matches, at

    def _distance(self, value: int, plain: int) -> int:
        """How far back a match lies: one of the last three, or another one."""
        recent = self._recent
        if value > 3:
            found = value - 3
            self._recent = [found, *recent[:2]]
            return found
        k = value - 1 + (plain == 0)
        if k == 3:
            found = recent[0] - 1
            self._recent = [found, *recent[:2]]
            return found
        self._recent = [recent[k], *(each for n, each in enumerate(recent) if n != k)]
        return recent[k]

    def _copy(self, distance: int, count: int) -> None:
        out = self._out
        start = len(out) - distance
        if distance < 1 or start < self._start or len(out) - self._start > self._most + 2 * _MOST:
            raise ZstdError("a match lies before the data")
        while count > 0:
            part = out[start : start + count]
            out += part
            count -= len(part)


def _value(code: int, widths: list[int], first: int, stream: Backwards) -> int:
    """A length: codes stand for one each, then for ever more, told by the bits that follow."""
    if code >= len(widths):
        raise ZstdError("a length is damaged")
    return first + _STARTS[first][code] + stream.read(widths[code])


def _starts(widths: list[int]) -> list[int]:
    found = [0]
    for width in widths[:-1]:
        found.append(found[-1] + (1 << width))
    return found


_STARTS = {0: _starts(_LENGTH_WIDTHS), 3: _starts(_MATCH_WIDTHS)}


def _streams(tree: Huffman, data: bytes, count: int, four: bool) -> bytes:
    if not four:
        return tree.decoded(data, count)
    sizes = [int.from_bytes(data[k : k + 2], "little") for k in (0, 2, 4)]
    each, at, found = (count + 3) // 4, 6, b""
    for k in range(4):
        size = sizes[k] if k < 3 else len(data) - at
        found += tree.decoded(data[at : at + max(size, 0)], each if k < 3 else count - 3 * each)
        at += size
    return found
