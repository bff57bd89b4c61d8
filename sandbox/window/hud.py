"""What is written over a running scene: the line of figures, the state of time, and notes."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.window.gui import TEXT_SIZE
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import Overlay, shorten
from sandbox.window.viewport import Rect

PANEL_OPACITY = 0.9
MARGIN, PAD_X, PAD_Y, GAP = 14.0, 14.0, 8.0, 22.0


@dataclass(frozen=True)
class Figures:
    """The numbers of the HUD line; `step_cost` in seconds."""

    fps: float
    step_cost: float
    bodies: int
    contacts: int
    step: int
    time: float
    frozen: int = 0

    def items(self) -> list[tuple[str, str, str]]:
        """(label, value, widest value expected), so that the columns do not jump while numbers change."""
        rows = [
            ("fps", f"{self.fps:.0f}", "000"),
            ("ms/step", f"{1000 * self.step_cost:.2f}", "00.00"),
            ("bodies", f"{self.bodies:,}", ""),
            ("contacts", f"{self.contacts:,}", "000"),
            ("step", f"{self.step:,}", "0,000"),
            ("time", f"{self.time:.2f} s", "00.00 s"),
        ]
        return [*rows, ("frozen", f"{self.frozen}", "")] if self.frozen else rows


def draw_figures(overlay: Overlay, rect: Rect, colors: Palette, figures: Figures) -> None:
    """The line of figures in the top left corner, as many as there is room for."""
    columns = [
        (label, value, overlay.width(label), max(overlay.width(value), overlay.width(widest)))
        for label, value, widest in figures.items()
    ]
    room = rect[2] - 2 * (MARGIN + PAD_X)
    while columns and (width := sum(a + 6.0 + b + GAP for _, _, a, b in columns) - GAP) > room:
        columns.pop()
    if not columns:
        return
    x, y = rect[0] + MARGIN, rect[1] + MARGIN
    _panel(overlay, colors, x, y, width)
    x += PAD_X
    for label, value, label_width, value_width in columns:
        overlay.text(x, y + PAD_Y, label, colors.faint)
        overlay.text(x + label_width + 6.0, y + PAD_Y, value, colors.accent if label == "frozen" else colors.text)
        x += label_width + 6.0 + value_width + GAP


def draw_time_state(overlay: Overlay, rect: Rect, colors: Palette, paused: bool, speed: float) -> None:
    """A badge in the top right corner while time does not run as usual."""
    words = [*(["paused"] if paused else []), *([] if speed == 1.0 else [f"speed {speed_text(speed)}"])]
    if words:
        text = "  ·  ".join(words)
        width = overlay.width(text)
        x, y = rect[0] + rect[2] - MARGIN - 2 * PAD_X - width, rect[1] + MARGIN
        _panel(overlay, colors, x, y, width)
        overlay.text(x + PAD_X, y + PAD_Y, text, colors.accent)


def speed_text(speed: float) -> str:
    """`1/4` for 0.25, `2` for 2."""
    return f"×{speed:.0f}" if speed >= 1.0 else f"×1/{1.0 / speed:.0f}"


def draw_note(overlay: Overlay, rect: Rect, colors: Palette, text: str, opacity: float) -> None:
    """A line in the upper part of a rectangle (left, top, width, height in pixels), for what just happened."""
    shown = shorten(overlay, text, rect[2] - 2 * (MARGIN + PAD_X))
    width = overlay.width(shown)
    x, y = rect[0] + (rect[2] - width) / 2, rect[1] + MARGIN + PAD_Y
    box = x - PAD_X, y - PAD_Y, x + width + PAD_X, y + overlay.scale * TEXT_SIZE + PAD_Y + 2.0
    overlay.panel(box, colors.panel, PANEL_OPACITY * opacity, 10.0)
    overlay.text(x, y, shown, colors.accent, opacity)


def draw_title(overlay: Overlay, rect: Rect, colors: Palette, words: tuple[str, str], opacity: float) -> None:
    """The scene's title and what to watch for, both in `words`, below the figures."""
    title, about = words
    left, top = rect[0] + MARGIN, rect[1] + MARGIN + 2 * PAD_Y + overlay.scale * TEXT_SIZE + 10.0
    room = rect[2] - 2 * (MARGIN + PAD_X)
    lines = [
        (shorten(overlay, title, room, 22.0), colors.text, 22.0, 30.0),
        (shorten(overlay, about, room), colors.faint, TEXT_SIZE, 20.0),
    ]
    shown = [line for line in lines if line[0]]
    if not shown:
        return
    width = max(overlay.width(text, points) for text, _, points, _ in shown)
    height = overlay.scale * sum(down for *_, down in shown) + 2 * PAD_Y
    overlay.panel((left, top, left + width + 2 * PAD_X, top + height), colors.panel, PANEL_OPACITY * opacity, 10.0)
    y = top + PAD_Y
    for text, color, points, down in shown:
        overlay.text(left + PAD_X, y, text, color, opacity, points)
        y += overlay.scale * down


def _panel(overlay: Overlay, colors: Palette, x: float, y: float, width: float) -> None:
    box = (x, y, x + width + 2 * PAD_X, y + overlay.scale * TEXT_SIZE + 2 * PAD_Y + 2.0)
    overlay.panel(box, colors.panel, PANEL_OPACITY, 10.0)
