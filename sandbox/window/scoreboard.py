"""Counters of a game, and how it ended, over the scene."""

from __future__ import annotations

from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay
from sandbox.window.workspace import Workspace

MARGIN, PAD, GAP = 14.0, 12.0, 22.0
SIZE, LARGE = 18.0, 34.0


def draw_scoreboard(overlay: Overlay, workspace: Workspace) -> None:
    """Counters at the upper left of the viewport; a banner in the middle once the game is won or lost."""
    world = workspace.session.world
    if world.counters:
        _draw_counters(overlay, workspace, world.counters)
    if world.outcome is not None:
        _draw_ending(overlay, workspace, world.outcome.result, world.outcome.text)


def _draw_counters(overlay: Overlay, workspace: Workspace, counters: dict[str, float]) -> None:
    colors, (left, top, width, _) = palette_of(workspace.theme), workspace.viewport.rect
    words = [(name.replace("-", " ").replace("_", " "), f"{value:g}") for name, value in counters.items()]
    sizes = [(overlay.width(name, SIZE), overlay.width(value, SIZE, bold=True)) for name, value in words]
    wide = sum(a + 7.0 + b for a, b in sizes) + GAP * (len(words) - 1) + 2 * PAD
    if wide > width - 2 * MARGIN:
        return
    x, y = left + MARGIN, top + MARGIN
    overlay.panel((x, y, x + wide, y + SIZE + 2 * 7.0), colors.panel, 0.85, 9.0)
    x += PAD
    for (name, value), (a, b) in zip(words, sizes, strict=True):
        overlay.text(x, y + 6.0, name, colors.faint, size=SIZE)
        overlay.text(x + a + 7.0, y + 6.0, value, colors.text, size=SIZE, bold=True)
        x += a + 7.0 + b + GAP


def _draw_ending(overlay: Overlay, workspace: Workspace, result: str, text: str) -> None:
    colors, (left, top, width, height) = palette_of(workspace.theme), workspace.viewport.rect
    head = "Won" if result == "won" else "Lost"
    lines = [(head, LARGE, colors.accent if result == "won" else colors.text)]
    lines += [(text, SIZE, colors.text)] if text else []
    lines += [("R plays again, Backspace goes back in time", 15.0, colors.faint)]
    wide = max(overlay.width(words, size, bold=size == LARGE) for words, size, _ in lines) + 4 * PAD
    high = sum(size + 10.0 for _, size, _ in lines) + 2 * PAD
    x, y = left + (width - wide) / 2, top + height * 0.38 - high / 2
    overlay.panel((x, y, x + wide, y + high), colors.panel, 0.92, 12.0)
    y += PAD
    for words, size, color in lines:
        inner = overlay.width(words, size, bold=size == LARGE)
        overlay.text(left + (width - inner) / 2, y, words, color, size=size, bold=size == LARGE)
        y += size + 10.0
