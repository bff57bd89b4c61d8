"""The lessons inside the window: their words section by section, and buttons that show what they speak of."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.resources import find_scene, scene_name, scenes_dir
from sandbox.window.lessons.lesson import LESSONS, Section, Showing, lesson
from sandbox.window.lessons.words import draw_words
from sandbox.window.panels.panel import Panel
from sandbox.window.sat.measure import scaled
from sandbox.window.widgets import button, choice
from sandbox.window.workspace import Wish, Workspace

WIDE, WIDEST_CHOICE = 620.0, 420.0
"""Pixels from which all that chooses stands in one line, and the most that a title takes of it."""

STEPS_WIDTH = 104.0
"""Pixels of the two buttons between, with the gaps."""


@dataclass
class Bookmark:
    """Where the reader is, and what is to be shown once its scene is open. Kept while the program runs."""

    lesson: str = LESSONS[0]
    section: int = 0
    wanted: Showing | None = None


class LessonsPanel(Panel):
    """The lessons on the separating-axis test and on contact solvers."""

    name = "lessons"
    title = "Lessons"
    icon = icons.ICON_FA_GRADUATION_CAP
    help = "The lessons on the separating-axis test and on contact solvers, with their scenes at hand."
    key = "U"
    side = "bottom"

    bookmark: ClassVar[Bookmark] = Bookmark()

    def draw(self, workspace: Workspace) -> None:
        """Which lesson, which section, what can be shown, and the words."""
        self._show_wanted(workspace)
        place = self.bookmark
        try:
            titles = [lesson(name)[0].title for name in LESSONS]
            sections = lesson(place.lesson)
        except OSError as error:
            imgui.text_wrapped(f"The lessons cannot be read: {error}")
            return
        room = imgui.get_content_region_avail().x
        wide = room >= scaled(WIDE)
        title_width = min((room - scaled(STEPS_WIDTH)) / 2, scaled(WIDEST_CHOICE)) if wide else -1.0
        imgui.set_next_item_width(title_width)
        chosen = choice("lessons.which", "", titles[LESSONS.index(place.lesson)], titles, "Which lesson.")
        if chosen != titles[LESSONS.index(place.lesson)]:
            place.lesson, place.section = LESSONS[titles.index(chosen)], 0
            sections = lesson(place.lesson)
        if wide:
            imgui.same_line()
        place.section = min(place.section, len(sections) - 1)
        self._draw_steps(sections, title_width)
        section = sections[place.section]
        for number, showing in enumerate(section.showings):
            self._draw_showing(workspace, showing, number)
        draw_words(section, f"{place.lesson} {place.section}", workspace)

    def _draw_steps(self, sections: tuple[Section, ...], title_width: float) -> None:
        at, last = self.bookmark.section, len(sections) - 1
        if button("lessons.back", icons.ICON_FA_ARROW_LEFT, "The section before", enabled=at > 0):
            self.bookmark.section = at - 1
        imgui.same_line()
        if button("lessons.next", icons.ICON_FA_ARROW_RIGHT, "The next section", enabled=at < last):
            self.bookmark.section = at + 1
        imgui.same_line()
        imgui.set_next_item_width(title_width)
        titles = [section.title for section in sections]
        chosen = choice("lessons.section", "", titles[at], titles, "Which section.")
        if chosen != titles[at]:
            self.bookmark.section = titles.index(chosen)

    def _draw_showing(self, workspace: Workspace, showing: Showing, number: int) -> None:
        tip, words = "Opens the scene, and what the section speaks of in it.", f"{icons.ICON_FA_PLAY}  {showing.label}"
        if number:  # beside the one before, if it has room there
            style, window = imgui.get_style(), imgui.get_window_pos().x
            end = imgui.get_item_rect_max().x + style.item_spacing.x + 2 * style.frame_padding.x
            if end + imgui.calc_text_size(words).x < window + imgui.get_window_width() - style.window_padding.x:
                imgui.same_line()
        if button(f"lessons.show.{number}", words, tip):
            self.bookmark.wanted = showing
            if _name(workspace) != showing.scene:
                workspace.wish = Wish("open", find_scene(scenes_dir() / showing.scene))

    def _show_wanted(self, workspace: Workspace) -> None:
        """Once the scene is open: the pair, and what of its test."""
        wanted = self.bookmark.wanted
        if wanted is None or _name(workspace) != wanted.scene:
            return
        self.bookmark.wanted = None
        names = workspace.session.world.names
        if wanted.figure and len(names) > 1:
            workspace.session.clock.paused = True
            workspace.session.seek(0)  # the lesson's numbers are those of the start
            workspace.selection.pair = wanted.bodies or (names[0], names[1])
            workspace.selection.figure = (wanted.figure, wanted.axis)
            workspace.panels.add("sat")


def _name(workspace: Workspace) -> str:
    return scene_name(Path(workspace.session.scene.source))
