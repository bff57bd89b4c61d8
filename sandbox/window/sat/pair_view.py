"""Which pair is looked at: its two names, its shapes, and the pairs that the grid proposes to choose from."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.geometry.shape_box import box_of
from sandbox.render.camera import fit
from sandbox.render.overlays.look import Look
from sandbox.render.theme import Color
from sandbox.window.fitting import fitting
from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import packed_color
from sandbox.window.sat.candidates import Candidates, candidates_of
from sandbox.window.sat.colors import sat_colors
from sandbox.window.sat.inspection import Inspection, Inspector
from sandbox.window.sat.measure import scaled
from sandbox.window.widgets import button, choice, mark, wrapped
from sandbox.window.workspace import Workspace

SHOWN = ("all", "touching", "rejected")
LIST_ROWS = 7
"""Rows of the list that are seen at once."""
BUTTONS, NARROW = 74.0, 200.0
"""Width of the buttons, and width below which the names stand below each other: pixels at the usual size of text."""


class PairView:
    """Chooses the pair; keeps the list of candidates for as long as nothing moves."""

    def __init__(self, inspector: Inspector) -> None:
        self._inspector = inspector
        self._shown = SHOWN[0]
        self._key: object = None
        self._found: Candidates | None = None

    def draw(self, workspace: Workspace, seen: Inspection | None) -> None:
        """Names and shapes of the pair, or how to pick one; then the list."""
        if seen is not None:
            self._draw_names(workspace, seen)
            self._draw_shapes(seen)
        else:
            wrapped(self._inspector.trouble or "Take the tool Pair (K) and click two bodies, select two bodies with "
                    "Shift, or choose a pair from the list.")  # fmt: skip
        flags = imgui.TreeNodeFlags_.default_open if seen is None else imgui.TreeNodeFlags_.none
        opened = imgui.collapsing_header("Pairs the grid proposes", flags)
        mark("sat.pairs")
        if opened:
            self._draw_list(workspace, seen)

    def _draw_names(self, workspace: Workspace, seen: Inspection) -> None:
        """Beside each other, or below each other where there is no room for that; the buttons are in the first row."""
        left, wide = imgui.get_cursor_pos_x(), imgui.get_content_region_avail().x - scaled(BUTTONS)
        rows = 2 if wide < scaled(NARROW) else 1
        share = wide * rows / 2
        for side in (0, 1):
            self._draw_name(workspace, seen, side, left + (side * share if rows == 1 else 0.0), share)
            if side == rows % 2:
                imgui.same_line()
                imgui.set_cursor_pos_x(left + wide)
                self._draw_buttons(workspace, seen)
            elif rows == 1:
                imgui.same_line()

    @staticmethod
    def _draw_name(workspace: Workspace, seen: Inspection, side: int, left: float, wide: float) -> None:
        colors = sat_colors(workspace.theme)
        imgui.set_cursor_pos_x(left)
        corner = imgui.get_cursor_screen_pos()
        color = (colors.a, colors.b)[side]
        _chip(corner.x, corner.y + scaled(2.0), "ab"[side], color, palette_of(workspace.theme).panel)
        imgui.set_cursor_pos_x(left + scaled(25.0))
        imgui.align_text_to_frame_padding()
        imgui.text_unformatted(fitting(seen.names[side], wide - scaled(32.0)))
        mark(f"sat.name.{'ab'[side]}", seen.names[side])

    @staticmethod
    def _draw_buttons(workspace: Workspace, seen: Inspection) -> None:
        if button("sat.swap", icons.ICON_FA_RIGHT_LEFT, "Exchange the two: the edges of the other one come first."):
            first, second = seen.names
            workspace.selection.pair = second, first
        imgui.same_line(0.0, 4.0)
        if button("sat.look", icons.ICON_FA_CROSSHAIRS, "Look at the pair from near by."):
            look_at_pair(workspace, seen)

    def _draw_shapes(self, seen: Inspection) -> None:
        """Which shape of each body, where one has several."""
        if seen.counts == (1, 1):
            return
        numbers = list(seen.numbers)
        for side, (letter, count) in enumerate(zip("ab", seen.counts, strict=True)):
            if count == 1:
                continue
            options = [f"shape {k + 1} of {count}" for k in range(count)]
            imgui.set_next_item_width(scaled(140.0))
            chosen = choice(f"sat.shape.{letter}", letter, options[numbers[side]], options, "Which shape of the body.")
            numbers[side] = options.index(chosen)
            imgui.same_line()
        if (numbers[0], numbers[1]) != seen.numbers:
            self._inspector.numbers = numbers[0], numbers[1]
        automatic = self._inspector.numbers is None
        if button(
            "sat.shapes.deepest",
            "deepest",
            "The pair of shapes that overlaps deepest, or else the nearest.",
            on=automatic,
        ):
            self._inspector.numbers = None

    def _draw_list(self, workspace: Workspace, seen: Inspection | None) -> None:
        session, world = workspace.session, workspace.session.world
        running = not session.clock.paused
        key = (world, world.changes, running)
        if key != self._key or self._found is None:
            look = Look(world, session.frame(), workspace.viewport.camera, workspace.theme)
            self._key, self._found = key, candidates_of(look, running)
        only = workspace.selection.bodies[0] if len(workspace.selection.bodies) == 1 else None
        row = world.directory.body(only) if only in world.names and only is not None else None
        found = self._found.of(row)
        for number, word in enumerate(SHOWN):
            if number:
                imgui.same_line(0.0, 4.0)
            if button(f"sat.pairs.{word}", word, f"Show {word} pairs.", on=self._shown == word):
                self._shown = word
        if self._shown != "all":
            found = found.only(touching=self._shown == "touching")
        bodies, touching = found.bodies, found.touching
        imgui.same_line()
        imgui.text_disabled(f"{len(bodies):,}" + (f" of {only}" if row is not None else ""))
        high = imgui.get_text_line_height_with_spacing()
        rows = min(max(len(bodies), 1), LIST_ROWS)
        room = high * rows + 6.0 if seen is not None else max(imgui.get_content_region_avail().y - 4.0, high)
        imgui.begin_child("##sat pairs", imgui.ImVec2(0.0, room))
        clipper = imgui.ListClipper()
        clipper.begin(len(bodies))
        while clipper.step():
            for k in range(clipper.display_start, clipper.display_end):
                self._draw_candidate(workspace, (int(bodies[k, 0]), int(bodies[k, 1])), bool(touching[k]), k)
        clipper.end()
        if not len(bodies):
            imgui.text_disabled("none")
        imgui.end_child()

    @staticmethod
    def _draw_candidate(workspace: Workspace, rows: tuple[int, int], touching: bool, number: int) -> None:
        names, colors = workspace.session.world.names, sat_colors(workspace.theme)
        pair = names[rows[0]], names[rows[1]]
        chosen = workspace.selection.pair in (pair, pair[::-1])
        corner = imgui.get_cursor_screen_pos()
        clicked, _ = imgui.selectable(f"      {pair[0]}  {pair[1]}##{number}", chosen)
        mark(
            f"sat.pair.{pair[0]}.{pair[1]}",
            "They touch." if touching else "Proposed by the grid, rejected by the test.",
        )
        center = imgui.ImVec2(corner.x + scaled(9.0), corner.y + imgui.get_text_line_height() / 2)
        pen, color = imgui.get_window_draw_list(), packed_color(colors.out if touching else colors.gap, 1.0)
        (pen.add_circle_filled(center, 4.0, color, 16) if touching else pen.add_circle(center, 3.5, color, 16, 1.6))
        if clicked:
            workspace.selection.pair = pair


def look_at_pair(workspace: Workspace, seen: Inspection) -> None:
    """Move the camera so that the pair fills the view; of a pair of very different sizes, the smaller one."""
    boxes = sorted((box_of(seen.a), box_of(seen.b)), key=lambda box: max(box[2] - box[0], box[3] - box[1]))
    small, large = boxes
    size = max(small[2] - small[0], small[3] - small[1])
    if max(large[2] - large[0], large[3] - large[1]) <= 4.0 * size:
        both = min(small[0], large[0]), min(small[1], large[1]), max(small[2], large[2]), max(small[3], large[3])
    else:
        both = small[0] - 0.4 * size, small[1] - 0.4 * size, small[2] + 0.4 * size, small[3] + 0.4 * size
    view = workspace.viewport
    view.camera, view.touched = fit(both, view.camera.size, margin=0.24), True


def _chip(x: float, y: float, letter: str, color: Color, ink: Color) -> None:
    """A round sign with a letter."""
    pen = imgui.get_window_draw_list()
    middle = x + scaled(10.0), y + scaled(10.0)
    pen.add_circle_filled(imgui.ImVec2(*middle), scaled(9.0), packed_color(color, 1.0), 24)
    size = imgui.calc_text_size(letter)
    pen.add_text(
        imgui.ImVec2(round(middle[0] - size.x / 2), round(middle[1] - 1.0 - size.y / 2)), packed_color(ink, 1.0), letter
    )
