"""What panels keep of each step: series, branches, thinning, CSV, and that closed panels are not asked."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox.bench.stages import TimedCalls
from sandbox.resources import find_scene
from sandbox.window.history import Branches, History, thinned
from sandbox.window.panels.plots.quantities import BODY, CHARTS, WORLD, body_values, mechanics, world_values
from sandbox.window.panels.plots.table import csv_text
from sandbox.window.session import Session
from sandbox.window.stage_times import STAGES, StageTimes
from tests.window.test_session import SCENE


def test_a_history_forgets_what_another_future_has_replaced() -> None:
    session, history = Session(SCENE), History(("step", "double"))

    def watch() -> None:
        history.follow(session.timeline)
        history.note(session.world.step_count, (session.world.step_count, 2 * session.world.step_count))

    session.watchers.append(watch)
    for _ in range(20):
        session.step_once()
    session.seek(8)
    assert len(history) == 21  # looking back changes nothing
    session.do("Push", sandbox.ApplyImpulse("crate", (1.0, 0.0)))
    history.follow(session.timeline)
    assert len(history) == 9
    session.step_once()
    session.undo()
    history.follow(session.timeline)
    assert len(history) == 9
    assert history.column("double")[1:].tolist() == [2.0 * step for step in range(1, 9)]
    assert history.known().tolist() == list(range(1, 9))


def test_a_history_grows_and_leaves_gaps_where_nothing_was_seen() -> None:
    history = History(("a",))
    history.note(5000, [1.5])
    history.note(3, [0.5])
    assert len(history) == 5001
    assert history.known().tolist() == [3, 5000]
    assert np.isnan(history.column("a")[4])


def test_a_branch_is_told_once() -> None:
    session, branches = Session(SCENE), Branches()
    session.skip(10)
    session.seek(4)
    session.do("Push", sandbox.ApplyImpulse("crate", (1.0, 0.0)))
    assert branches.parting(session.timeline) == 4
    assert branches.parting(session.timeline) is None


def test_thinning_keeps_every_peak() -> None:
    values = np.zeros(10_000)
    values[1234], values[8765] = 7.0, -3.0
    places = thinned(values, 0, len(values), 100)
    assert len(places) <= 202
    assert {0, 1234, 8765, 9999} <= set(places.tolist())
    assert thinned(values, 10, 15, 100).tolist() == [10, 11, 12, 13, 14]
    assert thinned(np.full(1000, np.nan), 0, 1000, 10).size > 0


def test_energy_and_momentum_of_a_fall_are_those_of_the_closed_form() -> None:
    ball = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [2, 100], "velocity": [3, 0]}
    world = sandbox.World(sandbox.Scene(bodies=[ball]))
    before = mechanics(world.state)
    mass = world.body("ball").mass
    assert before["potential"] == pytest.approx(mass * 9.81 * 100)
    assert before["kinetic"] == pytest.approx(0.5 * mass * 9)
    assert before["spin"] == pytest.approx(-mass * 300)
    world.step(60)
    after = mechanics(world.state)
    assert after["momentum_x"] == pytest.approx(3 * mass)
    assert after["momentum_y"] == pytest.approx(-9.81 * mass, rel=1e-6)
    assert after["energy"] == pytest.approx(before["energy"], rel=1e-3)


def test_values_have_the_order_of_their_names() -> None:
    world = sandbox.World(SCENE)
    world.step(60)
    named = dict(zip(WORLD, world_values(world, 0.002, {"solve": 1.25}), strict=True))
    assert named["cost"] == 2.0
    assert named["solve"] == 1.25
    assert np.isnan(named["collide"])
    assert named["contacts"] == len(world.contacts) > 0
    row = world.directory.body("other")
    body = dict(zip(BODY, body_values(world, row), strict=True))
    assert (body["x"], body["y"]) == world.body("other").position
    assert body["speed"] == pytest.approx(np.hypot(body["vx"], body["vy"]))
    assert len({chart.name for chart in CHARTS}) == len(CHARTS)


def test_a_table_has_a_row_for_each_step_that_is_known() -> None:
    energy = next(chart for chart in CHARTS if chart.name == "energy")
    values = {"kinetic": np.array([np.nan, 1.0, 2.5]), "energy": np.array([np.nan, 4.0])}
    lines = [(energy, "kinetic", "kinetic"), (energy, "energy", "total")]
    rows = list(csv.reader(io.StringIO(csv_text(lines, values, 0.5))))
    assert rows[0] == ["step", "time (s)", "Energy: kinetic (J)", "Energy: total (J)"]
    assert rows[1:] == [["1", "0.5", "1.0", "4.0"], ["2", "1.0", "2.5", ""]]


@pytest.mark.parametrize("name", ["pyramid-10", "ragdolls", "rocket"])
def test_timing_in_the_middle_of_a_run_changes_no_bit(name: str) -> None:
    scene = sandbox.load_scene(find_scene(Path(name)))
    timed, plain = sandbox.World(scene), sandbox.World(scene)
    timed.step(15)
    plain.step(15)
    times = StageTimes()
    assert times.take(timed) == {}
    assert list(timed.events) == list(plain.events)
    for _ in range(20):
        timed.step()
        plain.step()
        assert list(timed.events) == list(plain.events)
    took = times.take(timed)
    assert timed.digest() == plain.digest()
    assert set(took) == set(STAGES)
    assert took["solve"] > 0.0
    assert isinstance(timed._stepper.calls, TimedCalls)


def test_watchers_are_told_of_steps_that_are_shown() -> None:
    session, seen = Session(SCENE), list[Any]()
    session.watchers.append(lambda: seen.append(session.world.step_count))
    session.step_once()
    session.seek(0)
    session.step_once()
    session.skip(3)
    session.step_once()
    assert seen == [1, 1, 5]
