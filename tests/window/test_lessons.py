"""The lessons in the window: read from their pages, and what their buttons show."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sandbox.cli.sat_pair import pair_in
from sandbox.resources import find_scene, scenes_dir
from sandbox.window.lessons.lesson import LESSONS, Showing, lesson
from sandbox.window.panels.lessons import Bookmark, LessonsPanel
from sandbox.window.panels.sat import FIGURES
from sandbox.window.sat.tour import Kind
from tests.window.test_sat_panel import canvas, run

__all__ = ["canvas"]


@pytest.mark.parametrize("name", LESSONS)
def test_every_section_is_there_with_its_words(name: str) -> None:
    page = (scenes_dir() / name / "README.md").read_text(encoding="utf-8")
    sections = lesson(name)
    assert [section.title for section in sections[1:]] == [line[3:] for line in page.splitlines() if line[:3] == "## "]
    for section in sections:
        assert section.blocks
        for block in section.blocks:
            if block.kind != "code":
                assert not any(mark in block.text for mark in ("**", "`", "](", "!["))


def test_code_keeps_its_lines() -> None:
    dot = next(section for section in lesson("sat") if section.title == "3. The dot product")
    code = next(block.text for block in dot.blocks if block.text.startswith("def dot"))
    scope: dict[str, Any] = {}
    exec(code, scope)
    assert scope["dot"]((9, 3), (0, 7)) == 21


@pytest.mark.parametrize("name", LESSONS)
def test_whatever_can_be_shown_is_there(name: str) -> None:
    for section in lesson(name):
        for showing in section.showings:
            path = find_scene(scenes_dir() / showing.scene)
            assert path.is_file()
            if showing.figure:
                pair_in(path, showing.bodies, 0)  # raises if there is no such pair


def test_commands_are_read_with_their_options() -> None:
    shown = [showing for section in lesson("sat") for showing in section.showings]
    assert Showing("test-two", None, "dot", 4) in shown
    assert Showing("test-two", ("triangle", "square"), "mtv") in shown
    assert Showing("test-two") in shown
    assert set(FIGURES.values()) <= set(Kind.__args__)  # type: ignore[attr-defined]


@pytest.mark.slow
def test_a_button_of_a_lesson_opens_its_scene_and_shows_the_test(
    canvas: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(LessonsPanel, "bookmark", Bookmark())
    script = "key Space\nkey U\nwait 2\n" + "click lessons.next\n" * 14 + "click lessons.show.0\nwait 12\n"
    app = run(canvas, tmp_path, "pyramid-10", script, first="")
    assert app.screen.session.stem == "test-two"
    assert app.screen.workspace.selection.pair == ("square", "triangle")
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    assert app.panel.focus.step is not None
    assert app.panel.steps(seen)[app.panel.focus.step].kind == "cut"
    assert LessonsPanel.bookmark.section == 14
    assert (app.screen.session.clock.paused, app.screen.session.world.step_count) == (True, 0)
