"""What the colours of overlays mean, in a strip below the scene, so that it covers nothing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from imgui_bundle import imgui

from sandbox.render.marks import LegendEntry
from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay, packed_color, shorten
from sandbox.window.viewport import Rect
from sandbox.window.workspace import Workspace

SIZE, LINE, MARGIN, GAP, SPACE = 14.0, 22.0, 12.0, 20.0, 7.0
SWATCH, HEAD = 12.0, 7.0
MOST_SHARE = 0.3
"""Of the height that there is for scene and legend, what the legend takes at most."""
SETTLING = 3
"""Pictures after a switch in which lines may also go: the entries of the picture before are still the old ones."""


class LegendStrip:
    """Keeps its height while the same overlays are on: entries come and go from step to step."""

    def __init__(self) -> None:
        self._of: object = None
        self._lines = 0
        self._settling = 0

    def room_above(self, overlay: Overlay, workspace: Workspace, rect: Rect, entries: Sequence[LegendEntry]) -> Rect:
        """What is left of a rectangle for the scene."""
        left, top, width, height = rect
        of = tuple(workspace.overlays), workspace.color_by, width, height, overlay.scale
        if of != self._of:
            self._of, self._settling = of, SETTLING
        line = LINE * overlay.scale
        wanted = min(len(list(_lines(overlay, entries, width))), int(MOST_SHARE * height / line))
        self._lines = wanted if self._settling > 0 else max(self._lines, wanted)
        self._settling -= 1
        high = round(self._lines * line + (SPACE if self._lines else 0.0))
        return left, top, width, max(height - high, 1)

    def draw(self, overlay: Overlay, workspace: Workspace, entries: Sequence[LegendEntry]) -> None:
        """Below the viewport, as many lines as have room there."""
        if not self._lines:
            return
        colors, (left, top, width, height) = palette_of(workspace.theme), workspace.viewport.rect
        line, top = LINE * overlay.scale, top + height
        overlay.panel((left, top, left + width, top + self._lines * line + SPACE), colors.panel, 1.0, 0.0)
        overlay.panel((left, top, left + width, top + 1.0), colors.line, 1.0, 0.0)
        for number, placed in enumerate(list(_lines(overlay, entries, width))[: self._lines]):
            y = top + SPACE / 2 + (number + 0.5) * line
            for x, text, entry in placed:
                _sign(overlay, entry, left + x, y)
                room = width - x - _sign_width(overlay, entry) - SPACE - MARGIN
                shown = shorten(overlay, text, room, SIZE)
                after = left + x + _sign_width(overlay, entry) + SPACE
                overlay.text(after, y - 0.6 * overlay.scale * SIZE, shown, colors.text, size=SIZE)


def _lines(
    overlay: Overlay, entries: Sequence[LegendEntry], width: float
) -> Iterator[list[tuple[float, str, LegendEntry]]]:
    """The entries in lines, each as many as fit into `width` pixels, at least one, with where they begin."""
    line: list[tuple[float, str, LegendEntry]] = []
    x = MARGIN
    for entry in entries:
        wide = _sign_width(overlay, entry) + SPACE + overlay.width(entry.text, SIZE)
        if line and x + wide > width - MARGIN:
            yield line
            line, x = [], MARGIN
        line.append((x, entry.text, entry))
        x += wide + GAP * overlay.scale
    if line:
        yield line


def _sign_width(overlay: Overlay, entry: LegendEntry) -> float:
    return entry.length or SWATCH * overlay.scale


def _sign(overlay: Overlay, entry: LegendEntry, x: float, y: float) -> None:
    """A patch of the colour, or an arrow as long as the scale says."""
    scale, color = overlay.scale, packed_color(entry.color, 1.0)
    if not entry.length:
        half = 0.5 * SWATCH * scale
        overlay.panel((x, y - half, x + 2 * half, y + half), entry.color, 1.0, 3.0 * scale)
        return
    end, head = x + entry.length, HEAD * scale
    overlay.pen.add_line(imgui.ImVec2(x, y), imgui.ImVec2(end - 1.0, y), color, 2.0 * scale)
    for side in (-1.0, 1.0):
        tip, tail = imgui.ImVec2(end, y), imgui.ImVec2(end - head, y + 0.5 * side * head)
        overlay.pen.add_line(tip, tail, color, 2.0 * scale)
