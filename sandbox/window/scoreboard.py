"""Counters of a game above the scene, and how it ended, over it."""

from __future__ import annotations

from collections.abc import Mapping

from sandbox.engine.world import World
from sandbox.render.scoreboard import ENDINGS, Counter, counter_lines
from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay
from sandbox.window.viewport import Rect
from sandbox.window.workspace import Workspace

MARGIN, PAD, ABOVE = 14.0, 12.0, 7.0
SIZE, LARGE = 18.0, 34.0


def below_counters(overlay: Overlay, world: World, rect: Rect) -> Rect:
    """What is left of a rectangle for the scene: the counters, if there are any, stand above it and cover nothing."""
    high = round(len(_lines(overlay, world.counters, rect[2])) * _line_height(overlay))
    return rect[0], rect[1] + high, rect[2], max(rect[3] - high, 1)


def draw_ending(overlay: Overlay, workspace: Workspace) -> None:
    """A banner in the middle of the viewport once the game is won or lost."""
    outcome = workspace.session.world.outcome
    if outcome is not None:
        _draw_ending(overlay, workspace, outcome.result, outcome.text)


def draw_counters(overlay: Overlay, workspace: Workspace, rect: Rect) -> None:
    """The counters, if there are any, above a rectangle."""
    counters = workspace.session.world.counters
    if not counters:
        return
    colors, (left, bottom, width, _) = palette_of(workspace.theme), rect
    lines, high = _lines(overlay, counters, width), _line_height(overlay)
    top = bottom - round(len(lines) * high)
    overlay.panel((left, top, left + width, bottom), colors.panel, 1.0, 0.0)
    overlay.panel((left, bottom - 1.0, left + width, bottom), colors.line, 1.0, 0.0)
    for number, line in enumerate(lines):
        y = top + number * high + ABOVE - 2.0
        for x, name, after, value in line:
            overlay.text(left + MARGIN + x, y, name, colors.faint, size=SIZE)
            overlay.text(left + MARGIN + after, y, value, colors.text, size=SIZE, bold=True)


def _lines(overlay: Overlay, counters: Mapping[str, float], width: float) -> list[list[Counter]]:
    """The counters in lines that `width` pixels hold."""
    return list(counter_lines(counters, width - 2 * MARGIN, lambda text, value: overlay.width(text, SIZE, bold=value)))


def _line_height(overlay: Overlay) -> float:
    return overlay.scale * SIZE + 2 * ABOVE


def _draw_ending(overlay: Overlay, workspace: Workspace, result: str, text: str) -> None:
    colors, (left, top, width, height) = palette_of(workspace.theme), workspace.viewport.rect
    head, scale = ENDINGS[result], overlay.scale
    lines = [(head, LARGE, colors.accent if result == "won" else colors.text)]
    lines += [(text, SIZE, colors.text)] if text else []
    lines += [("R plays again, Backspace goes back in time", 15.0, colors.faint)]
    wide = max(overlay.width(words, size, bold=size == LARGE) for words, size, _ in lines) + 4 * PAD
    high = sum(scale * size + 10.0 for _, size, _ in lines) + 2 * PAD
    x, y = left + (width - wide) / 2, top + height * 0.38 - high / 2
    overlay.panel((x, y, x + wide, y + high), colors.panel, 0.92, 12.0)
    y += PAD
    for words, size, color in lines:
        inner = overlay.width(words, size, bold=size == LARGE)
        overlay.text(left + (width - inner) / 2, y, words, color, size=size, bold=size == LARGE)
        y += scale * size + 10.0
