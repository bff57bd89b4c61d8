"""The event log and the profile, as tables and by real clicks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox.engine.events.happening import HAPPENINGS
from sandbox.resources import find_scene
from sandbox.window.panels.events import log
from sandbox.window.panels.events.log import EventTable, Filter
from sandbox.window.panels.events.panel import EventsPanel, go_to
from sandbox.window.panels.profile.panel import ProfilePanel
from sandbox.window.panels.profile.table import KEPT, PARTS, StageTable
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.session import Session
from tests.window.hands import play
from tests.window.test_session import SCENE


def watched(scene: sandbox.Scene, steps: int) -> tuple[Session, EventTable]:
    session, table = Session(scene), EventTable()

    def watch() -> None:
        table.follow(session.timeline)
        table.note(session.world.events)

    session.watchers.append(watch)
    for _ in range(steps):
        session.step_once()
    return session, table


def happenings(table: EventTable, wanted: Filter | None = None) -> list[log.LoggedEvent]:
    return [table.event(int(number)) for number in table.matching(wanted or Filter())]


@pytest.mark.parametrize("name", ["galton-board", "ragdolls", "wrecking-ball", "breakout"])
def test_the_table_holds_what_the_world_tells(name: str) -> None:
    scene = sandbox.load_scene(find_scene(Path(name)))
    _, table = watched(scene, 120)
    world, told = sandbox.World(scene), list[Any]()
    for _ in range(120):
        world.step()
        told += list(world.events)
    assert len(told) == len(table) > 0
    kept = sorted(happenings(table), key=lambda one: one.step)
    for one, event in zip(kept, told, strict=True):
        assert (one.kind, one.step) == (event["event"], event["step"])
        if "a" in event:
            assert one.bodies == (event["a"], event["b"])
            assert (one.point, one.speed) == (tuple(event["point"]), event["speed"])
        elif "joint" in event:
            assert one.joint == event["joint"]
        elif event["event"] in HAPPENINGS:
            assert all(str(value) in one.said for word, value in event.items() if word not in ("event", "step"))
        else:
            assert one.bodies == tuple(event[word] for word in ("sensor", "body") if word in event)


def test_kinds_and_words_filter() -> None:
    _, table = watched(SCENE, 90)
    every = happenings(table)
    hits = happenings(table, Filter({"hit"}))
    assert hits
    assert {one.kind for one in hits} == {"hit"}
    assert len(hits) < len(every)
    words = happenings(table, Filter(words="GROUND other"))
    assert words
    assert all({"ground", "other"} <= set(one.bodies) for one in words)
    assert happenings(table, Filter(set())) == []
    assert [one.step for one in every] == sorted((one.step for one in every), reverse=True)


def test_words_find_what_comes_later_too() -> None:
    session, table = watched(SCENE, 5)
    before = len(table.matching(Filter(words="other")))
    for _ in range(60):
        session.step_once()
    assert len(table.matching(Filter(words="other"))) > before


def test_a_branch_cuts_the_log_and_playing_again_adds_nothing_twice() -> None:
    session, table = watched(SCENE, 90)
    whole = happenings(table)
    session.seek(10)
    for _ in range(80):
        session.step_once()
    assert happenings(table) == whole
    session.seek(20)
    session.do("Fly", sandbox.SetGravity((0.0, 9.81)))
    table.follow(session.timeline)
    assert all(one.step <= 20 for one in happenings(table))
    session.step_once()
    session.undo()
    for _ in range(70):
        session.step_once()
    assert happenings(table) == whole


@pytest.mark.slow
def test_the_oldest_are_forgotten_when_there_are_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log, "MOST_ROWS", 20)
    scene = sandbox.load_scene(find_scene(Path("galton-board")))
    _, table = watched(scene, 200)
    assert table.forgotten
    assert len(table) <= 20
    monkeypatch.setattr(log, "MOST_ROWS", 10**6)
    _, full = watched(scene, 200)
    kept, every = happenings(table), happenings(full)
    assert set(kept) < set(every)
    assert [one.step for one in kept] == [one.step for one in every[: len(kept)]]


@pytest.mark.slow
def test_a_click_goes_there_in_time_and_space(canvas: Canvas, tmp_path: Path) -> None:
    screen = play(
        canvas,
        SCENE,
        tmp_path,
        "key F5\nkey Space\nwait 70\nclick events.hit\nclick events.hit\nclick events.row.2\nwait 2",
    )
    panel = screen.panels["events"]
    assert isinstance(panel, EventsPanel)
    one = happenings(panel.table, panel.filter)[2]
    assert screen.session.clock.paused
    assert screen.session.world.step_count == one.step
    assert screen.camera.center == one.point
    assert screen.workspace.selection.bodies == one.bodies


def test_a_click_on_what_has_no_place_looks_at_the_bodies(canvas: Canvas, tmp_path: Path) -> None:
    def go(screen: PlayScreen) -> None:
        go_to(screen.workspace, log.LoggedEvent(3, "wake", ("other",)))

    screen = play(canvas, SCENE, tmp_path, "key Space\nwait 10", go)
    assert screen.camera.center == screen.session.world.body("other").center
    assert screen.session.world.step_count == 3


def test_closed_panels_are_not_called(canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[str] = []
    for kind in (EventsPanel, ProfilePanel):
        for what in ("note_step", "draw"):
            monkeypatch.setattr(kind, what, lambda self, workspace, what=what: called.append(f"{self.name} {what}"))
    screen = play(canvas, SCENE, tmp_path, "key Space\nwait 20", lambda _: called.append("open"), "key F5\nwait 10")
    assert called[0] == "open"
    assert {"events note_step", "events draw"} == set(called[1:])
    assert type(screen.session.world._stepper).__name__ == "Stepper"  # and nothing is timed


def test_the_profile_times_all_stages(canvas: Canvas, tmp_path: Path) -> None:
    screen = play(canvas, SCENE, tmp_path, "key F7\nkey Space\nwait 40")
    panel = screen.panels["profile"]
    assert isinstance(panel, ProfilePanel)
    rows = {name: (now, mean, share) for name, now, mean, share in panel.table.summary()}
    assert {"collide", "solve", "rest"} <= set(rows)
    assert sum(share for _, _, share in rows.values()) == pytest.approx(1.0)
    assert rows["solve"][1] > 0.0


def test_the_table_of_stages_is_a_ring() -> None:
    table = StageTable()
    assert table.summary() == []
    for number in range(KEPT + 10):
        table.note(2.0 * number, {"collide": 0.5 * number, "solve": 1.0 * number})
    rows = table.rows
    assert rows.shape == (KEPT, len(PARTS))
    assert np.allclose(rows[:, PARTS.index("solve")], np.arange(10, KEPT + 10))
    assert {name: now for name, now, _, _ in table.summary()} == {
        "collide": pytest.approx(0.5 * (KEPT + 9)), "solve": KEPT + 9.0, "rest": pytest.approx(0.5 * (KEPT + 9)),
    }  # fmt: skip
