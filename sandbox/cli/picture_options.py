"""Options about pictures that several commands share."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from pathlib import Path

from sandbox._atomic_write import check_writable
from sandbox._printable import told
from sandbox.cli.output import check_not_source
from sandbox.errors import SandboxError

LARGEST = 8192
SMALLEST = 16


def parse_size(text: str) -> tuple[int, int]:
    """`"1280x800"` -> (1280, 800). Raises `SandboxError` for anything else and for impossible sizes."""
    match = re.fullmatch(r"\s*(\d{1,6})\s*[xX×*]\s*(\d{1,6})\s*", text)
    if match is None:
        raise SandboxError(f"--size {text!r} is not a size; write width and height in pixels, such as 1280x800")
    width, height = int(match[1]), int(match[2])
    if not (SMALLEST <= width <= LARGEST and SMALLEST <= height <= LARGEST):
        raise SandboxError(f"--size {text}: each side must be {SMALLEST} to {LARGEST} pixels")
    return width, height


def writable_picture(path: Path, suffixes: Collection[str], sources: Iterable[Path]) -> str:
    """The lower-case suffix of a picture to write. Raises `SandboxError` or `OSError` if it cannot be, or if it would
    take the place of one of the `sources` that it is made of: a drawing may be a scene too."""
    suffix = path.suffix.lower()
    if suffix not in suffixes:
        *others, last = sorted(suffixes)
        known = " or ".join([", ".join(others), last] if others else [last])
        raise SandboxError(f"{told(path)}: the name of a picture must end in {known}")
    check_not_source(path, sources)
    check_writable(path)
    return suffix
