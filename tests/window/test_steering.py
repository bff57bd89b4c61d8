"""Menus and panels by the keyboard alone: real keys on the whole window."""

from __future__ import annotations

from pathlib import Path

import pytest

import sandbox
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.steering import PANELS
from tests.window.hands import play

SCENE = sandbox.Scene(
    title="A yard",
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
    ],
    view={"center": [0, 3], "height": 12},
)
MENU = "key Ctrl+M\nwait 4\n"
"""Opens the first menu."""


def test_a_menu_is_gone_through_and_chosen_from(canvas: Canvas, tmp_path: Path) -> None:
    """File, Edit, Arrange, Time: pause stands first."""

    def inside(screen: PlayScreen) -> None:
        assert screen.workspace.steering.what == "menus"

    def chosen(screen: PlayScreen) -> None:
        assert screen.workspace.steering.what == ""
        assert not screen.session.clock.paused

    right = "key Right\nwait 5\n"
    play(canvas, SCENE, tmp_path, MENU, inside, right * 3 + "key Enter\nwait 4\n", chosen)


def test_arrows_belong_to_the_scene_again_after_escape(canvas: Canvas, tmp_path: Path) -> None:
    steps = "key .\n" * 6
    last: list[int] = []

    def before(screen: PlayScreen) -> None:
        last.append(screen.session.timeline.step_count)

    def in_menu(screen: PlayScreen) -> None:
        assert screen.session.timeline.step_count == last[0]  # Left has not rewound

    def after(screen: PlayScreen) -> None:
        assert screen.workspace.steering.what == ""
        assert screen.session.timeline.step_count < last[0]

    back = "key Left\nwait 3\n"
    play(canvas, SCENE, tmp_path, steps, before, MENU + back, in_menu, "key Esc\nwait 3\n" + back, after)


@pytest.mark.slow
def test_a_panel_is_gone_through_and_changed(canvas: Canvas, tmp_path: Path) -> None:
    """The inspector is in front, the world comes next: its first number is gravity along x. Numbers are
    what was typed, to the last bit."""
    seen: list[str] = []

    def where(screen: PlayScreen) -> None:
        seen.append(screen.workspace.steering.panel)

    def after(screen: PlayScreen) -> None:
        assert screen.workspace.steering.what == ""
        assert tuple(screen.session.world.gravity) == (0.3, -9.81)

    def both(screen: PlayScreen) -> None:
        assert tuple(screen.session.world.gravity) == (0.3, -1.62)

    to = "key Ctrl+K\nwait 6\n"
    number = "key Tab\nwait 3\n"
    play(
        canvas, SCENE, tmp_path, to, where, to, where, to, where, to, to, where,
        number + "type 0.3\nkey Enter\nwait 3\nkey Esc\nwait 3\n", after,
        to + number + number + "type -1.62\nkey Enter\nwait 3\nkey Esc\n", both,
    )  # fmt: skip
    assert seen == ["inspector", "world", "overlays", "world"]


def test_a_panel_that_opens_in_the_way_there_has_the_keyboard(canvas: Canvas, tmp_path: Path) -> None:
    def both(screen: PlayScreen) -> None:
        """Two keys in one picture, as where each takes long."""
        screen.workspace.steering.begin(PANELS)
        screen.workspace.toggle_panel("overlays")

    def after(screen: PlayScreen) -> None:
        assert screen.workspace.steering.what == PANELS
        assert "overlays" in screen.workspace.panels - screen.workspace.behind

    play(canvas, SCENE, tmp_path, "wait 3\n", both, "wait 4\n", after)


def test_a_window_without_room_for_any_panel_has_them_all_the_same(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[str] = []

    def where(screen: PlayScreen) -> None:
        assert screen.workspace.panels == screen.workspace.behind
        seen.append(screen.workspace.steering.panel)

    to = "key Ctrl+K\nwait 4\n"
    play(canvas, SCENE, tmp_path, "key F2\nkey F3\nwait 4\n", to, where, to, where, to, where, size=(60, 400))
    assert sorted(seen[:2]) == ["inspector", "world"]
    assert seen[2] == seen[0]
