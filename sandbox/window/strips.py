"""What is written around the scene, so that none of it covers what happens there: above it the caption, counters and
keys of a game, below it the legend.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sandbox.render.marks import LegendEntry
from sandbox.window import hud
from sandbox.window.gui_style import palette_of
from sandbox.window.hint import Key
from sandbox.window.keys_strip import KeysStrip
from sandbox.window.legend_strip import LegendStrip
from sandbox.window.overlay import Overlay
from sandbox.window.scoreboard import below_counters, draw_counters
from sandbox.window.viewport import Rect
from sandbox.window.workspace import Workspace


@dataclass(frozen=True)
class Told:
    """What there is to say: a caption with figures where panels are hidden, the keys of a game, the legend."""

    caption: tuple[hud.Figures, str] | None
    """With the state of time."""
    keys: tuple[Key, ...]
    legend: Sequence[LegendEntry]


class Strips:
    """`place` says what they leave to the scene, `draw` draws them around it."""

    def __init__(self) -> None:
        self._legend = LegendStrip()
        self._keys: KeysStrip | None = None
        self._ends: tuple[Rect, Rect, Rect] = ((0, 0, 0, 0),) * 3
        """What lies below the caption, below the counters, and below the keys."""

    def place(self, overlay: Overlay, workspace: Workspace, rect: Rect, told: Told) -> Rect:
        """What is left of a rectangle."""
        first = hud.below_line(overlay, rect, told.caption is not None)
        second = below_counters(overlay, workspace.session.world, first)
        self._keys = KeysStrip(overlay, told.keys, palette_of(workspace.theme))
        third = self._keys.below(second)
        self._ends = first, second, third
        return self._legend.room_above(overlay, workspace, third, told.legend)

    def draw(self, overlay: Overlay, workspace: Workspace, told: Told) -> None:
        """All of them, where `place` has put them last."""
        colors, scene, (first, second, third) = palette_of(workspace.theme), workspace.session.scene, self._ends
        if told.caption is not None:
            figures, state = told.caption
            hud.draw_caption(overlay, first, colors, (workspace.session.title, scene.about, state), figures)
        draw_counters(overlay, workspace, second)
        if self._keys is not None:
            self._keys.draw(third)
        self._legend.draw(overlay, workspace, told.legend)
