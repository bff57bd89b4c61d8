"""Whether an object file is all there. LLVM takes that on trust, and reads past the end of one that is not.

ELF as in the System V ABI, chapter 4; of the formats of other systems only the first bytes are looked at.
"""

from __future__ import annotations

import struct

_ELF = b"\x7fELF\x02\x01"  # 64 bits, little-endian
_OTHERS = (b"\xcf\xfa\xed\xfe", b"\x64\x86", b"\x64\xaa")  # Mach-O; COFF for x86-64 and arm64
_HEADER = struct.Struct("<16sHHIQQQIHHHHHH")
_SECTION = struct.Struct("<IIQQQQIIQQ")
_EMPTY_ON_DISK = 8  # SHT_NOBITS


def is_whole(code: bytes) -> bool:
    """Whether it begins like an object file, and all of its sections lie in it."""
    if not code.startswith(_ELF):
        return len(code) > _HEADER.size and code.startswith(_OTHERS)
    if len(code) < _HEADER.size:
        return False
    header = _HEADER.unpack_from(code)
    first, size, count = header[6], header[11], header[12]
    if size != _SECTION.size or count == 0 or first + count * size > len(code):
        return False
    return all(_lies_in(code, _SECTION.unpack_from(code, first + k * size)) for k in range(count))


def _lies_in(code: bytes, section: tuple[int, ...]) -> bool:
    kind, offset, size = section[1], section[4], section[5]
    return kind == _EMPTY_ON_DISK or offset + size <= len(code)
