"""Many small pictures on one, each with its title below, to be read where the sheet is shown at half its size."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sandbox.render.camera import Size
from sandbox.render.theme import DARK, Color

GAP, EDGE, LINE = 10, 16, 54
"""Pixels between pictures, about all of them, and of the title below each."""
LETTERS, LEADING = 21, 24
"""Height of titles, and from one line of them to the next, in pixels."""
MOST_LINES = 2


def contact_sheet(pictures: Sequence[tuple[str, Any]], columns: int) -> Any:
    """A `PIL.Image.Image` of (title, `PIL.Image.Image`) pairs, all pictures of one size, row by row."""
    from PIL import Image, ImageDraw

    size: Size = pictures[0][1].size
    across, down = size[0] + GAP, size[1] + LINE + GAP
    rows = -(-len(pictures) // columns)
    whole = columns * across - GAP + 2 * EDGE, rows * down - GAP + 2 * EDGE
    sheet = Image.new("RGB", whole, _pixel(DARK.ink))
    pen = ImageDraw.Draw(sheet)
    for number, (title, picture) in enumerate(pictures):
        left, top = EDGE + number % columns * across, EDGE + number // columns * down
        sheet.paste(picture, (left, top))
        middle, y = left + size[0] / 2, top + size[1] + LEADING / 2 + 3
        for line in title_lines(pen, title, size[0]):
            pen.text((middle, y), line, _pixel(DARK.joint), _font(), anchor="mm")
            y += LEADING
    return sheet


def title_lines(pen: Any, title: str, room: int) -> list[str]:
    """A title in as few lines as it needs, words whole as far as that goes; the last is cut."""
    lines: list[str] = []
    for word in title.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and (len(lines) == MOST_LINES or pen.textlength(longer, _font()) <= room):
            lines[-1] = longer
        else:
            lines.append(word)
    return [_shortened(pen, line, room) for line in lines]


def _font() -> Any:
    from PIL import ImageFont

    return ImageFont.load_default(LETTERS)


def _shortened(pen: Any, title: str, room: int) -> str:
    """As much of a title as there is room for."""
    shown = title
    while shown and pen.textlength(shown + "…" * (shown != title), _font()) > room:
        shown = shown[:-1].rstrip()
    return shown if shown == title else shown + "…"


def _pixel(color: Color) -> tuple[int, int, int]:
    red, green, blue = (round(255 * part) for part in color)
    return red, green, blue
