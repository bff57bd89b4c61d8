"""What is written about a running scene where panels are hidden, above it, and notes over it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sandbox.window.gui import TEXT_SIZE
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import Overlay, shorten, split_line
from sandbox.window.viewport import Rect

PANEL_OPACITY = 0.9
MARGIN, PAD_X, PAD_Y, GAP = 14.0, 14.0, 8.0, 22.0
NOTE_LINES, LEADING = 4, 1.35
"""Lines of a note at most, and from one to the next in heights of the text."""
LEAST_ABOUT = 160.0
"""Pixels from which on what is to be watched for says something."""


@dataclass(frozen=True)
class Figures:
    """The numbers of the line; `step_cost` in seconds."""

    fps: float
    step_cost: float
    bodies: int
    contacts: int
    step: int
    time: float
    frozen: int = 0
    asleep: str = ""
    """As `at_rest.asleep` says it."""

    def items(self) -> list[tuple[str, str, str]]:
        """(label, value, widest value expected), so that the columns do not jump while numbers change."""
        rows = [
            ("time", f"{self.time:.2f} s", "00.00 s"),
            ("step", f"{self.step:,}", "0,000"),
            ("contacts", f"{self.contacts:,}", "000"),
            ("bodies", f"{self.bodies:,}", ""),
            ("ms/step", f"{1000 * self.step_cost:.2f}", "00.00"),
            ("fps", f"{self.fps:.0f}", "000"),
        ]
        told = (("frozen", f"{self.frozen}" if self.frozen else ""), ("asleep", self.asleep))
        return [*((name, value, "") for name, value in told if value), *rows]


def below_line(overlay: Overlay, rect: Rect, there: bool = True) -> Rect:
    """What is left of a rectangle for the scene where a line, if it is there, stands above it."""
    high = _line_height(overlay) if there else 0
    return rect[0], rect[1] + high, rect[2], max(rect[3] - high, 1)


def _draw_line(overlay: Overlay, rect: Rect, colors: Palette) -> float:
    """A line above a rectangle; gives where its text has its upper edge."""
    left, bottom, width, _ = rect
    overlay.panel((left, bottom - _line_height(overlay), left + width, bottom), colors.panel, 1.0, 0.0)
    overlay.panel((left, bottom - 1.0, left + width, bottom), colors.line, 1.0, 0.0)
    return bottom - PAD_Y - overlay.scale * TEXT_SIZE - 1.0


def _line_height(overlay: Overlay) -> int:
    return round(overlay.scale * TEXT_SIZE + 2 * PAD_Y)


def draw_caption(overlay: Overlay, rect: Rect, colors: Palette, words: tuple[str, str, str], figures: Figures) -> None:
    """Above a rectangle: title, what to watch for and the state of time, all in `words`, at the left, and as many
    figures as there is room for at the right.
    """
    title, about, state = words
    y = _draw_line(overlay, rect, colors)
    x, right = rect[0] + MARGIN, rect[0] + rect[2] - MARGIN
    for text, color in ((state, colors.accent), (title, colors.text)):
        shown = shorten(overlay, text, right - x)
        overlay.text(x, y, shown, color)
        x += overlay.width(shown) + GAP if text else 0.0
    for label, value, wide in _columns(overlay, figures, right - x):
        overlay.text(right - wide, y, label, colors.faint)
        color = colors.accent if label == "frozen" else colors.text
        overlay.text(right - wide + overlay.width(label) + 6.0, y, value, color)
        right -= wide + GAP
    if right - x > LEAST_ABOUT * overlay.scale:
        overlay.text(x, y, shorten(overlay, about, right - x), colors.faint)


def _columns(overlay: Overlay, figures: Figures, room: float) -> Iterator[tuple[str, str, float]]:
    """Label, value and width of the figures that have room, from the right."""
    for label, value, widest in figures.items():
        wide = overlay.width(label) + 6.0 + max(overlay.width(value), overlay.width(widest))
        room -= wide + GAP
        if room < 0.0:
            return
        yield label, value, wide


def time_state(paused: bool, speed: float) -> str:
    """What is to be said while time does not run as usual; empty while it does."""
    return "  ·  ".join([*(["paused"] if paused else []), *([] if speed == 1.0 else [f"speed {speed_text(speed)}"])])


def speed_text(speed: float) -> str:
    """`1/4` for 0.25, `2` for 2."""
    return f"×{speed:.0f}" if speed >= 1.0 else f"×1/{1.0 / speed:.0f}"


def draw_note(overlay: Overlay, rect: Rect, colors: Palette, text: str, opacity: float) -> None:
    """What just happened, in the upper part of a rectangle (left, top, width, height in pixels)."""
    lines = note_lines(overlay, text, rect[2] - 2 * (MARGIN + PAD_X))
    width, line = max(map(overlay.width, lines)), overlay.scale * TEXT_SIZE * LEADING
    x, y = rect[0] + (rect[2] - width) / 2, rect[1] + MARGIN + PAD_Y
    low = y + (len(lines) - 1) * line + overlay.scale * TEXT_SIZE
    box = x - PAD_X, y - PAD_Y, x + width + PAD_X, low + PAD_Y + 2.0
    overlay.panel(box, colors.panel, PANEL_OPACITY * opacity, 10.0)
    for k, words in enumerate(lines):
        overlay.text(rect[0] + (rect[2] - overlay.width(words)) / 2, y + k * line, words, colors.accent, opacity)


def note_lines(overlay: Overlay, text: str, room: float) -> list[str]:
    """A note in lines of `room` pixels at most: why something failed, and where, stands at its end."""
    lines: list[str] = []
    rest = text
    while rest and len(lines) < NOTE_LINES - 1:
        line, rest = split_line(overlay, rest, room)
        lines.append(line)
    return [shorten(overlay, line, room) for line in [*lines, *([rest] if rest else [])]] or [""]
