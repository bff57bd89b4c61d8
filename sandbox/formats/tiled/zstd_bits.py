"""Bits and codes of Zstandard: streams read forwards and backwards, tables of finite state entropy and of Huffman.

Source: RFC 8878, section 4 "Entropy Encoding".
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class ZstdError(Exception):
    """The data are damaged, or use what is not known."""


class Backwards:
    """Bits from the end of some bytes to their beginning; the highest one only marks where they start."""

    def __init__(self, data: bytes) -> None:
        if not data or not data[-1]:
            raise ZstdError("a stream of bits has no end")
        self._data = data
        self.left = 8 * len(data) - 9 + data[-1].bit_length()

    def peek(self, count: int) -> int:
        """The next bits; 0 for those past the beginning."""
        at, missing = self.left - count, 0
        if at < 0:
            at, missing, count = 0, -at, max(count + at, 0)
        first = at >> 3
        word = int.from_bytes(self._data[first : first + 8], "little") >> (at & 7)
        return (word & ((1 << count) - 1)) << missing

    def read(self, count: int) -> int:
        """Take the next bits."""
        value = self.peek(count)
        self.left -= count
        return value


class Fse(NamedTuple):
    """By state: the symbol, how many bits lead to the next state, and what is added to them."""

    bits: int
    symbols: list[int]
    widths: list[int]
    bases: list[int]


def fse_table(shares: Sequence[int], bits: int) -> Fse:
    """The table of symbols with these shares of 2^bits states; -1 is less than one."""
    size = 1 << bits
    symbols, high = [0] * size, size - 1
    counts = [abs(share) for share in shares]
    for symbol, share in enumerate(shares):
        if share == -1:
            symbols[high] = symbol
            high -= 1
    at, stride = 0, (size >> 1) + (size >> 3) + 3
    for symbol, share in enumerate(shares):
        for _ in range(max(share, 0)):
            symbols[at] = symbol
            at = (at + stride) & (size - 1)
            while at > high:
                at = (at + stride) & (size - 1)
    widths, bases = [], []
    for symbol in symbols:
        width = bits + 1 - counts[symbol].bit_length()
        widths.append(width)
        bases.append((counts[symbol] << width) - size)
        counts[symbol] += 1
    return Fse(bits, symbols, widths, bases)


def read_fse(data: bytes, most_bits: int) -> tuple[Fse, int]:
    """A table that stands in front of data, and how many bytes it takes."""
    word, at = int.from_bytes(data[:512], "little"), 4
    bits = (word & 15) + 5
    if bits > most_bits:
        raise ZstdError("a table is too large")
    shares: list[int] = []
    left = 1 << bits
    while left > 0:
        width = (left + 1).bit_length()
        value, low = (word >> at) & ((1 << width) - 1), (1 << (width - 1)) - 1
        spare = (1 << width) - 2 - left
        at += width
        if value & low < spare:
            value, at = value & low, at - 1
        elif value > low:
            value -= spare
        shares.append(value - 1)
        left -= abs(value - 1)
        zeros = 3 if value == 1 else 0
        while zeros == 3:
            zeros, at = (word >> at) & 3, at + 2
            shares += [0] * zeros
        if at > 8 * len(data) or len(shares) > 256 or left < 0:
            raise ZstdError("a table is damaged")
    return fse_table(shares, bits), (at + 7) // 8


class Huffman(NamedTuple):
    """By the next `bits` bits: the symbol, and how many of them it is."""

    bits: int
    symbols: list[int]
    widths: list[int]

    def decoded(self, data: bytes, count: int) -> bytes:
        """So many symbols from a stream."""
        stream, found = Backwards(data), bytearray()
        for _ in range(count):
            code = stream.peek(self.bits)
            found.append(self.symbols[code])
            stream.left -= self.widths[code]
        if stream.left != 0:
            raise ZstdError("a stream of literals is damaged")
        return bytes(found)


def read_huffman(data: bytes) -> tuple[Huffman, int]:
    """A tree that stands in front of literals, and how many bytes it takes."""
    if not data:
        raise ZstdError("a tree is missing")
    head = data[0]
    if head < 128:
        table, start = read_fse(data[1 : 1 + head], 6)
        return _huffman(_weights(table, data[1 + start : 1 + head])), 1 + head
    count, size = head - 127, (head - 126) // 2
    pairs = [nibble for byte in data[1 : 1 + size] for nibble in (byte >> 4, byte & 15)]
    if len(pairs) < count:
        raise ZstdError("a tree is damaged")
    return _huffman(pairs[:count]), 1 + size


def _weights(table: Fse, data: bytes) -> list[int]:
    """Two states take turns until the bits are used up."""
    stream = Backwards(data)
    found: list[int] = []
    states = [stream.read(table.bits), stream.read(table.bits)]
    while len(found) < 256:
        for k in (0, 1):
            state = states[k]
            found.append(table.symbols[state])
            states[k] = table.bases[state] + stream.read(table.widths[state])
            if stream.left < 0:
                return [*found, table.symbols[states[1 - k]]]
    raise ZstdError("a tree is damaged")


def _huffman(weights: list[int]) -> Huffman:
    total = sum(1 << (weight - 1) for weight in weights if weight)
    bits = total.bit_length()
    left = (1 << bits) - total
    if not total or bits > 11 or left & (left - 1):
        raise ZstdError("a tree is damaged")
    weights = [*weights, left.bit_length()]
    symbols: list[int] = []
    widths: list[int] = []
    for weight in range(1, bits + 1):
        for symbol, own in enumerate(weights):
            if own == weight:
                symbols += [symbol] * (1 << (weight - 1))
                widths += [bits + 1 - weight] * (1 << (weight - 1))
    return Huffman(bits, symbols, widths)
