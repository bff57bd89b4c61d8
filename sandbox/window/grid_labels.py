"""What the lines of the grid stand for, in metres, along the lower and the left edge of the scene."""

from __future__ import annotations

from sandbox.render.grid import grid_lines
from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay
from sandbox.window.workspace import Workspace

SIZE, EDGE, GAP = 12.0, 4.0, 14.0
"""Height of the numbers, their distance from the edge, and least room between two of them, in pixels."""
SMALLEST = 240, 160
"""A smaller scene has no room to spare."""


def draw_grid_labels(overlay: Overlay, workspace: Workspace, end: float) -> None:
    """Number the major lines; those below the scene only up to the pixel `end` of the window."""
    left, top, width, height = workspace.viewport.rect
    if width < SMALLEST[0] or height < SMALLEST[1]:
        return
    high = overlay.scale * SIZE
    bottom, free = top + height - EDGE - high, float(left)
    for line in sorted(grid_lines(workspace.viewport.camera), key=lambda line: line.pixel):
        if line.rank == 0:
            continue
        text = number_text(line.metres)
        wide = overlay.width(text, SIZE)
        if line.vertical:
            x = left + line.pixel + EDGE
            if x > free and x + wide + EDGE < end:
                _write(overlay, workspace, (x, bottom), text)
                free = x + wide + GAP
        elif 0.0 < line.pixel - high - 2.0 < height - 2.0 * high - 3.0 * EDGE:
            _write(overlay, workspace, (left + EDGE, top + line.pixel - high - 2.0), text)


def number_text(metres: float) -> str:
    """The shortest text of a number of metres that is a few digits times a power of ten."""
    return f"{metres + 0.0:.12g}".replace("-", "\N{MINUS SIGN}")


def _write(overlay: Overlay, workspace: Workspace, at: tuple[float, float], text: str) -> None:
    colors = palette_of(workspace.theme)
    right, low = at[0] + overlay.width(text, SIZE), at[1] + overlay.scale * SIZE
    overlay.panel((at[0] - 3.0, at[1], right + 3.0, low + 1.0), workspace.theme.background, 0.75, 3.0)
    overlay.text(*at, text, colors.faint, 1.0, SIZE)
