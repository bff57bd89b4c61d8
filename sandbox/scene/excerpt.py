"""Line, column and the picture of a line with a caret under the mistake."""

from __future__ import annotations

from sandbox._printable import printable

_WIDTH = 100


def line_column(text: str, offset: int) -> tuple[int, int]:
    """Line and column, both from 1, of a character counted from 0."""
    start = text.rfind("\n", 0, offset) + 1
    return text.count("\n", 0, offset) + 1, offset - start + 1


def excerpt(text: str, start: int, end: int) -> str:
    """The line that holds `start`, numbered, and below it carets from `start` to `end` or the line's end."""
    line, column = line_column(text, start)
    line_start = start - column + 1
    line_end = text.find("\n", line_start)
    content = text[line_start : line_end if line_end >= 0 else len(text)].rstrip("\r")
    cut = max(0, column - 1 - _WIDTH * 2 // 3) if len(content) > _WIDTH else 0
    shown = content[cut : cut + _WIDTH].replace("\t", " ")
    before = column - 1 - cut
    carets = max(1, min(end - start, len(shown) - before))
    number = f"{line:>5} | "
    return f"{number}{printable(shown)}\n{' ' * (len(number) - 2)}| {' ' * before}{'^' * carets}"
