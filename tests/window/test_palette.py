"""The command palette by real keys: all that has a name can be reached without the mouse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox.render.overlays.registry import OVERLAYS
from sandbox.window.actions.registry import ACTIONS
from sandbox.window.palette import MOST, Offer, Palette, matching
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from tests.window.hands import play

SCENE = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [-3, 0.5]},
    ],
    view={"center": [0, 3], "height": 12},
)


@pytest.mark.slow
def test_words_and_enter_do_what_is_meant_and_nothing_else_hears_the_keys(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[Any] = []

    def look(screen: PlayScreen) -> None:
        workspace = screen.workspace
        seen.append((screen.tool_box.tool.name, list(workspace.overlays), workspace.selection.bodies))
        assert not workspace.palette_shown

    play(
        canvas, SCENE, tmp_path,
        "key Ctrl+P\nwait 3\ntype wind\nkey Enter\nwait 2\n", look,
        "key Ctrl+P\nwait 3\ntype overlay contact\nkey Enter\nwait 2\n", look,
        "key Ctrl+P\nwait 3\ntype crate\nkey Enter\nwait 2\n", look,
        "key Ctrl+P\nwait 3\ntype nothing of that name\nkey Enter\nkey Esc\nwait 2\n", look,
        "key Ctrl+P\nwait 3\ntype zx\nkey Enter\nkey Backspace\nkey Backspace\ntype box\nkey Enter\nwait 2\n", look,
    )  # fmt: skip
    crate = "wind", ["contacts"], ("crate",)
    assert seen == [("wind", [], ()), ("wind", ["contacts"], ()), crate, crate, ("box", *crate[1:])]


def test_arrows_go_round_and_the_next_time_begins_anew(canvas: Canvas, tmp_path: Path) -> None:
    chosen: list[str] = []

    def look(screen: PlayScreen) -> None:
        chosen.append(screen.tool_box.tool.title)

    first = "key Ctrl+P\nwait 3\ntype tool\n"
    play(
        canvas, SCENE, tmp_path, first + "key Down\nkey Down\nkey Enter\nwait 2\n", look,
        first + "key Up\nkey Enter\nwait 2\n", look, first + "key Enter\nwait 2\n", look,
    )  # fmt: skip
    assert chosen == ["Play", "Pair", "Hand"]


def test_it_offers_every_action_tool_panel_and_overlay(canvas: Canvas, tmp_path: Path) -> None:
    def look(screen: PlayScreen) -> None:
        palette = Palette(screen.workspace, screen.tool_box, screen.panels)
        offers = {(offer.kind, offer.title) for offer in palette.offers()}
        can = {(one.menu, one.title) for one in ACTIONS if not one.held and one.enabled(screen.workspace)}
        assert can - offers == {("Help", "Find and do")}
        assert {("Tool", tool.title) for tool in screen.tool_box.tools.values()} <= offers
        assert {("Panel", panel.title) for panel in screen.panels.values()} <= offers
        assert {("Overlay", overlay.title) for overlay in OVERLAYS.values()} <= offers

    play(canvas, SCENE, tmp_path, look)


def test_a_key_brings_its_panel_to_the_front_before_it_closes_it(canvas: Canvas, tmp_path: Path) -> None:
    states: list[tuple[bool, bool]] = []

    def look(screen: PlayScreen) -> None:
        states.append(("world" in screen.workspace.panels, "world" in screen.workspace.behind))

    press = "key F3\nwait 4\n"
    play(canvas, SCENE, tmp_path, "wait 6\n", look, press, look, press, look, press, look)
    assert states == [(True, True), (True, False), (False, False), (True, False)]


def test_words_may_stand_anywhere_and_what_begins_with_them_comes_first() -> None:
    offers = [Offer(title, kind, "", "", print) for title, kind in (("Save as replay", "File"), ("Replay", "Panel"))]
    assert [offer.title for offer in matching(offers, "replay")] == ["Replay", "Save as replay"]
    assert [offer.title for offer in matching(offers, "file SAVE")] == ["Save as replay"]
    assert matching(offers, "save panel") == []
    assert len(matching([Offer(f"crate-{k}", "Body", "", "", print) for k in range(999)], "crate")) == MOST
