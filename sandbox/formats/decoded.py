"""Bytes of a foreign file as text: packed by gzip or not, in the encoding that it names, and out of its wrapping."""

from __future__ import annotations

import codecs
import re
import zlib
from pathlib import Path

from sandbox.errors import Problem, SceneError
from sandbox.scene.limits import MAX_BYTES
from sandbox.scene.read import as_text

_GZIP = b"\x1f\x8b"
_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
_NAMED = re.compile(rb"""\s*<\?xml[^>]*?\sencoding\s*=\s*["']([\w.:-]{1,40})["']""")
_KNOWN = re.compile(r"utf_?\d+|ascii|iso8859_\d+|latin_?1|cp\d+|koi8_[ru]|mac_roman|shift_jis|euc_\w+|gb\w+|big5")
_WRAPPING = re.compile(  # what has been matched is never looked at again: *+
    r"""(?:\s++|/\*(?:(?!\*/).)*+\*/|//[^\n]*+\n)*+(?:
        (?:export\s+default|(?:(?:var|let|const)\s+)?[\w$.]++(?:\[["'][^"'\n]*+["']\])?\s*=)
        |\(function\(name,\s*data\)\s*\{(?:(?!\}\)\().)*+\}\)\(\s*"[^"\n]*+"\s*,  # as Tiled exports it
    )\s*(?=[\[{])""",
    re.VERBOSE | re.DOTALL,
)
_CLOSING = re.compile(r"[\s;)]*")


def decoded(path: Path, data: bytes) -> str:
    """The text. Raises `SceneError` where its encoding is not known or does not hold, or it unpacks to too much."""
    if data.startswith(_GZIP):
        data = _unpacked(path, data)
    encoding = next((name for mark, name in _MARKS if data.startswith(mark)), "") or _named(data)
    if not encoding:
        return as_text(path, data)
    try:
        return data.decode(encoding)
    except (UnicodeDecodeError, LookupError):
        raise SceneError(str(path), [Problem(f"the file is not {encoding}, as it says it is")]) from None


def unwrapped(text: str) -> str:
    """JSON that a script assigns to something, as JSON in its place; any other text as it is."""
    match = _WRAPPING.match(text[:4000])
    if match is None:
        return text
    before = re.sub(r"[^\n]", " ", match.group())
    end = max(text.rfind("}"), text.rfind("]")) + 1
    return before + text[match.end() : end] if _CLOSING.fullmatch(text[end:]) else text


def _named(data: bytes) -> str:
    """The encoding that XML names, if it is another one than UTF-8 and Python knows it as one of text."""
    match = _NAMED.match(data[:200])
    if match is None:
        return ""
    try:
        name = codecs.lookup(match[1].decode("ascii")).name
    except LookupError:
        return ""
    return name if name != "utf-8" and _KNOWN.fullmatch(name.replace("-", "_")) else ""


def _unpacked(path: Path, data: bytes) -> bytes:
    try:
        raw = zlib.decompressobj(zlib.MAX_WBITS | 16).decompress(data, MAX_BYTES + 1)
    except zlib.error as error:
        raise SceneError(str(path), [Problem(f"the file is packed by gzip and cannot be unpacked: {error}")]) from None
    if len(raw) > MAX_BYTES:
        raise SceneError(str(path), [Problem(f"the file unpacks to more than {MAX_BYTES // 2**20} MiB, the limit")])
    return raw
