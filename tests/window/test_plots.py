"""The plots by real keys and clicks."""

from __future__ import annotations

import csv
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sandbox.window.panels.plots.chart import DASH_PIXELS, gaps, value_range
from sandbox.window.panels.plots.panel import PlotsPanel
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from tests.window.hands import play
from tests.window.test_session import SCENE


def plots_of(screen: PlayScreen) -> PlotsPanel:
    panel = screen.panels["plots"]
    assert isinstance(panel, PlotsPanel)
    return panel


@pytest.mark.slow
def test_what_happens_while_the_panel_is_closed_is_not_kept(canvas: Canvas, tmp_path: Path) -> None:
    lines = "key Space\nwait 20\nkey F6\nwait 20\nkey F6\nwait 20\nkey F6\nwait 10"
    screen = play(canvas, SCENE, tmp_path, lines)
    known = plots_of(screen)._world.known()
    assert 25 < len(known) < 60
    assert known[0] > 18
    gaps = [int(b - a) for a, b in pairwise(known)]
    assert max(gaps) > 18
    assert screen.session.world.step_count > 70


@pytest.mark.slow
def test_a_plot_begins_where_there_is_something_to_plot(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[float, float]] = []

    def look(screen: PlayScreen) -> None:
        panel = plots_of(screen)
        for panel._span in ("all", "10 s", "1 s"):
            seen.append(panel._limits(screen.workspace))
        screen.session.seek(5)
        seen.append(panel._limits(screen.workspace))

    play(canvas, SCENE, tmp_path, "key Space\nwait 40\nkey F6\nwait 100\nkey Space\nwait 2", look)
    (first, last), ten, one, back = seen
    assert first > 38
    assert ten == (first, last)
    assert one == pytest.approx((last - 60, last))
    assert back[0] == 5


def test_lines_that_cover_each_other_take_turns_to_be_seen() -> None:
    x = np.arange(0.0, 10 * DASH_PIXELS)
    low, high, across = (np.column_stack([x, y]) for y in (0.0 * x, 0.0 * x + 50.0, x))
    assert not gaps(low, []).any()
    assert not gaps(high, [low]).any()
    assert gaps(low, [low]).mean() == 0.5
    assert gaps(low, [low, low]).mean() == pytest.approx(0.7)  # three lines, three turns
    assert not gaps(across, [low])[3:].any()  # only where they meet


@pytest.mark.slow
def test_a_click_in_a_plot_goes_there(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[Any] = []
    lines = "key F6\nkey Space\nwait 60\nclick plots.chart.energy\nwait 2"
    screen = play(canvas, SCENE, tmp_path, lines, lambda screen: seen.append(screen.session.timeline.length))
    step = screen.session.world.step_count
    assert screen.session.clock.paused
    assert 0.3 * seen[0] < step < 0.7 * seen[0]


@pytest.mark.slow
def test_what_is_shown_is_saved_and_nothing_is_written_over(canvas: Canvas, tmp_path: Path) -> None:
    lines = "key F6\nkey Space\nclick @0,0.5\nwait 20\nclick plots.overlap\nclick plots.csv\nwait 2\nkey Space\n"
    screen = play(canvas, SCENE, tmp_path, lines + "wait 2\nclick plots.csv\nwait 2")
    first, second = (tmp_path / f"played-plots{n}.csv" for n in ("", "-2"))
    rows = list(csv.reader(first.open()))
    assert rows[0] == ["step", "time (s)", "Energy: kinetic (J)", "Energy: potential (J)", "Energy: total (J)"]
    steps = [int(row[0]) for row in rows[1:]]
    assert steps == list(range(steps[0], steps[-1] + 1))
    assert second.exists()
    assert "saved played-plots-2.csv" in screen.note


def test_fields_of_the_selected_body_are_kept(canvas: Canvas, tmp_path: Path) -> None:
    screen = play(canvas, SCENE, tmp_path, "key F6\nclick @4,3\nwait 2\nkey Space\nwait 30")
    panel = plots_of(screen)
    panel.chosen.add("position")
    x = panel.values(screen.workspace)["y"]
    assert x[-1] == screen.session.world.body("other").position[1]


@pytest.mark.slow
def test_a_branch_cuts_what_was_kept(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[int] = []

    def look(screen: PlayScreen) -> None:
        seen.append(len(plots_of(screen)._world))

    lines = "key F6\nkey Space\nwait 40\nkey Space\nkey Home\nkey .\nkey .\nwait 2"
    play(canvas, SCENE, tmp_path, lines, look, "click panel.world\nwait 2\nclick world.gravity.moon\nwait 2", look)
    assert seen[0] > 40
    assert seen[1] == 3


def test_a_plot_shows_all_of_its_lines() -> None:
    low, high = value_range([np.array([1.0, math.nan, 3.0]), np.array([-2.0])])
    assert low < -2.0
    assert high > 3.0
    assert value_range([]) == (0.0, 1.0)
    bottom, top = value_range([np.array([0.0, 1.0])], 100.0)
    assert (top - 1.0) / (top - bottom) * 52.0 > 24.0  # the legend covers no line in a low plot
    low, high = value_range([np.full(5, 1e6)])
    assert low < 1e6 < high


def test_a_switch_of_the_solver_is_a_command_that_can_be_undone(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[int, int]] = []

    def look(screen: PlayScreen) -> None:
        setting = screen.session.world.state.settings[0]
        seen.append((int(setting.warm_starting), int(setting.substeps)))

    lines = "click panel.world\nwait 2\nclick world.warm_starting\nwait 2\n"
    typed = "click world.substeps\nwait 2\nkey Ctrl+A\ntype 9\nkey Enter\nwait 2"
    screen = play(canvas, SCENE, tmp_path, lines, look, typed, look, "key Ctrl+Z\nkey Ctrl+Z\nwait 2", look)
    assert seen == [(0, 4), (0, 9), (1, 4)]
    assert screen.session.timeline.redo_label == "Warm start off"
