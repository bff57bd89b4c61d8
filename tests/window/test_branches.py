"""Futures that were left for another one, and the way back to them."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.widgets import places
from tests.window.hands import play
from tests.window.test_session import SCENE


@pytest.mark.slow
def test_after_a_goodbye_all_futures_are_there_again(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[int, int, int, int]] = []

    def look(screen: PlayScreen) -> None:
        timeline = screen.session.timeline
        seen.append((timeline.step_count, timeline.length, len(screen.session.world.names), len(timeline.branches)))

    play(
        canvas, SCENE, tmp_path, "key Ctrl+A\n" + "key .\n" * 6 + "key ,\n" * 4 + "key Delete\nkey .\nwait 2\n",
        look, "key ,\nkey ,\nwait 3\n", look,
    )  # fmt: skip
    play(
        canvas, SCENE, tmp_path, look, "key Ctrl+Shift+O\nwait 20\n", look,
        "click time.branches\nwait 3\nclick branch.0\nkey End\nwait 2\n", look,
        "key Ctrl+Z\nkey Ctrl+Z\nkey End\nwait 2\n", look,
    )  # fmt: skip
    _, left, fresh, *again = seen
    assert fresh == (1, 1, len(SCENE.bodies), 0)
    assert again == [left, (7, 7, len(SCENE.bodies), 1), (7, 7, len(SCENE.bodies), 0)]


def test_a_future_is_chosen_from_the_list_and_by_its_key_and_all_is_undone(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[int, int, int]] = []

    def look(screen: PlayScreen) -> None:
        timeline = screen.session.timeline
        seen.append((timeline.step_count, timeline.length, len(screen.session.world.names)))

    def none(screen: PlayScreen) -> None:
        assert "time.branches" not in places

    screen = play(
        canvas, SCENE, tmp_path, "key Ctrl+A\n" + "key .\n" * 6, none,
        "key ,\n" * 4 + "key Delete\nkey .\nwait 2\n", look,
        "click time.branches\nwait 3\nclick branch.0\nwait 2\n", look, "key End\nwait 2\n", look,
        "key Ctrl+B\nwait 2\n", look, "key Ctrl+Z\nkey Ctrl+Z\nwait 2\n", look,
        size=(720, 450),
    )  # fmt: skip
    before = len(SCENE.bodies)
    after = seen[0][2]
    assert after < before
    assert seen == [(4, 4, after), (3, 7, before), (7, 7, before), (3, 4, before), (4, 4, after)]
    assert [branch.label for branch in screen.session.timeline.branches] == [""]
