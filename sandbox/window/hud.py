"""What is written over a running scene: the line of figures, the state of time, and the help line."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.render.camera import Size
from sandbox.render.theme import hex_color
from sandbox.window.gui import TEXT_SIZE
from sandbox.window.keys import help_items
from sandbox.window.overlay import Overlay, shorten

TEXT, FAINT, WARM = hex_color("#e6eaf1"), hex_color("#8e99aa"), hex_color("#ffd479")
PANEL = hex_color("#1b2029")
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


def draw_figures(overlay: Overlay, figures: Figures) -> None:
    """The line of figures in the top left corner."""
    columns = [
        (label, value, overlay.width(label), max(overlay.width(value), overlay.width(widest)))
        for label, value, widest in figures.items()
    ]
    width = sum(a + 6.0 + b for _, _, a, b in columns) + GAP * (len(columns) - 1)
    _panel(overlay, MARGIN, MARGIN, width)
    x = MARGIN + PAD_X
    for label, value, label_width, value_width in columns:
        overlay.text(x, MARGIN + PAD_Y, label, FAINT)
        overlay.text(x + label_width + 6.0, MARGIN + PAD_Y, value, WARM if label == "frozen" else TEXT)
        x += label_width + 6.0 + value_width + GAP


def draw_time_state(overlay: Overlay, size: Size, paused: bool, speed: float) -> None:
    """A badge in the top right corner while time does not run as usual."""
    words = [*(["paused"] if paused else []), *([] if speed == 1.0 else [f"speed {speed_text(speed)}"])]
    if words:
        text = "  ·  ".join(words)
        width = overlay.width(text)
        x = size[0] - MARGIN - 2 * PAD_X - width
        _panel(overlay, x, MARGIN, width)
        overlay.text(x + PAD_X, MARGIN + PAD_Y, text, WARM)


def speed_text(speed: float) -> str:
    """`1/4` for 0.25, `2` for 2."""
    return f"×{speed:.0f}" if speed >= 1.0 else f"×1/{1.0 / speed:.0f}"


def draw_help(overlay: Overlay, size: Size, opacity: float) -> None:
    """The keys along the bottom, in as many lines as the window's width asks for."""
    lines = _wrap(overlay, size[0] - 2 * (MARGIN + PAD_X))
    line_height = TEXT_SIZE + 8.0
    top = size[1] - MARGIN - 2 * PAD_Y - line_height * len(lines) + 8.0
    widths = [sum(w for _, _, w in line) + GAP * (len(line) - 1) for line in lines]
    left = (size[0] - max(widths)) / 2
    box = (left - PAD_X, top, left + max(widths) + PAD_X, size[1] - MARGIN)
    overlay.panel(box, PANEL, PANEL_OPACITY * opacity, 10.0)
    for row, line in enumerate(lines):
        x, y = (size[0] - widths[row]) / 2, top + PAD_Y + row * line_height
        for key, text, width in line:
            overlay.text(x, y, key, TEXT, opacity)
            overlay.text(x + overlay.width(key) + 6.0, y, text, FAINT, opacity)
            x += width + GAP


def draw_note(overlay: Overlay, size: Size, text: str, opacity: float) -> None:
    """A line in the middle of the picture's upper half, for what just happened."""
    shown = shorten(overlay, text, size[0] - 2 * (MARGIN + PAD_X))
    width = overlay.width(shown)
    x, y = (size[0] - width) / 2, size[1] / 4
    overlay.panel(
        (x - PAD_X, y - PAD_Y, x + width + PAD_X, y + TEXT_SIZE + PAD_Y + 2.0), PANEL, PANEL_OPACITY * opacity, 10.0
    )
    overlay.text(x, y, shown, WARM, opacity)


def draw_title(overlay: Overlay, size: Size, title: str, about: str, opacity: float) -> None:
    """The scene's title and what to watch for, below the figures."""
    top = MARGIN + 2 * PAD_Y + TEXT_SIZE + 10.0
    room = size[0] - 2 * (MARGIN + PAD_X)
    lines = [
        (shorten(overlay, title, room, 22.0), TEXT, 22.0, 30.0),
        (shorten(overlay, about, room), FAINT, TEXT_SIZE, 20.0),
    ]
    shown = [line for line in lines if line[0]]
    if not shown:
        return
    width = max(overlay.width(text, points) for text, _, points, _ in shown)
    height = sum(down for *_, down in shown) + 2 * PAD_Y
    overlay.panel((MARGIN, top, MARGIN + width + 2 * PAD_X, top + height), PANEL, PANEL_OPACITY * opacity, 10.0)
    y = top + PAD_Y
    for text, color, points, down in shown:
        overlay.text(MARGIN + PAD_X, y, text, color, opacity, points)
        y += down


def _wrap(overlay: Overlay, room: float) -> list[list[tuple[str, str, float]]]:
    lines: list[list[tuple[str, str, float]]] = [[]]
    used = 0.0
    for key, text in help_items():
        width = overlay.width(key) + 6.0 + overlay.width(text)
        if lines[-1] and used + GAP + width > room:
            lines.append([])
            used = 0.0
        used += width + (GAP if lines[-1] else 0.0)
        lines[-1].append((key, text, width))
    return lines


def _panel(overlay: Overlay, x: float, y: float, width: float) -> None:
    box = (x, y, x + width + 2 * PAD_X, y + TEXT_SIZE + 2 * PAD_Y + 2.0)
    overlay.panel(box, PANEL, PANEL_OPACITY, 10.0)
