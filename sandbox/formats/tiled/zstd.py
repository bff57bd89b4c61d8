"""Unpacks Zstandard: by Python itself from 3.14 on, by its backport before."""

from __future__ import annotations

import sys

if sys.version_info >= (3, 14):
    from compression.zstd import ZstdDecompressor, ZstdError
else:
    from backports.zstd import ZstdDecompressor, ZstdError

__all__ = ["ZstdError", "decompress"]


def decompress(data: bytes, most: int) -> bytes:
    """The bytes of all frames, `most` of them at most. Raises `ZstdError`."""
    found = bytearray()
    while data and len(found) < most:
        frame = ZstdDecompressor()
        found += frame.decompress(data, most - len(found))
        if not frame.eof and len(found) < most:
            raise ZstdError("the data end too early")
        data = frame.unused_data
    return bytes(found)
