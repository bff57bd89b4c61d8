"""`sandbox solver` as a user calls it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest


def test_a_step_is_told_pass_by_pass(cli: Callable, write_scene: Callable) -> None:
    done = cli("solver", write_scene("a.scene.json"), "--iterations", 3, "--vary", "soft=off")
    assert done.code == 0
    for words in ("as the scene has it", "soft off", "crate on ground, point 2", "N s at 2", "\nmany "):
        assert words in done.out
    assert len([line for line in done.out.splitlines() if line.split()[:1] == ["3"]]) == 2


def test_a_run_is_told_over_time(cli: Callable, write_scene: Callable) -> None:
    done = cli("solver", write_scene("a.scene.json"), "--over-time", "--measure", "height", "--vary", "substeps=1")
    assert done.code == 0
    lines = done.out.splitlines()
    assert lines[0] == "height of the common centre of mass, m"
    assert "substeps 1" in lines[2]
    assert len(lines) == 3 + 13
    assert lines[3].split() == ["0.00", "0.500", "0.500"]


def test_both_in_json(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json")
    (run,) = json.loads(cli("solver", path, "--json", "--iterations", 2).out)["runs"]
    assert [len(row) for row in run["passes"]] == [2, 2]
    assert {tuple(point["names"]) for point in run["points"]} == {("ground", "crate")}
    (run,) = json.loads(cli("solver", path, "--over-time", "--steps", 4, "--json").out)["runs"]
    assert run["times"] == pytest.approx([k / 60 for k in range(5)])
    assert set(run["measures"][0]) == {"energy", "penetration", "height", "top"}


def test_all_figures_are_drawn(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    path, picture = write_scene("a.scene.json"), tmp_path / "a.svg"
    for arguments in ((), ("--figure", "impulse"), ("--over-time",), ("--over-time", "--figure", "ends")):
        picture.unlink(missing_ok=True)
        assert cli("solver", path, *arguments, "--vary", "relax=off", "--svg", picture).code == 0
        assert picture.read_text(encoding="utf-8").startswith("<svg ")


def test_runs_in_which_other_points_touch_are_drawn_side_by_side(
    cli: Callable, write_scene: Callable, tmp_path: Path
) -> None:
    """A crate that lands on a corner, and without contacts ahead of time does not touch yet with the other one."""
    ground, crate = ({"id": name, "shapes": [{"box": size}]} for name, size in (("ground", [40, 1]), ("crate", [1, 1])))
    bodies = [ground | {"type": "static", "position": [0, -0.5]}, crate | {"position": [0, 5], "angle": 15}]
    path, picture = write_scene("a.scene.json", bodies=bodies), tmp_path / "a.svg"
    vary = ("--vary", "substeps=1", "--vary", "speculative=off")
    document = json.loads(cli("solver", path, "--step", 66, *vary, "--json").out)
    counts = [[len(run["points"]), len(run["settled"]), len(run["passes"][0])] for run in document["runs"]]
    assert all(len(set(row)) == 1 for row in counts)
    assert len({row[0] for row in counts}) > 1
    assert cli("solver", path, "--step", 66, *vary, "--svg", picture).code == 0


def test_what_does_not_fit_is_refused_in_one_line(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    path = write_scene("a.scene.json")
    far = [{"id": "a", "shapes": [{"circle": 1}], "position": [0, 50]}]
    for arguments, message in [
        (("--vary", "sofd=off"), 'no technique is called "sofd"; did you mean "soft"?'),
        (("--vary", "soft=maybe"), "soft is on or off, such as soft=off"),
        (("--vary", "soft"), "soft is on or off, such as soft=off"),
        (("--vary", "substeps=0"), "substeps is a whole number from 1 to 64"),
        (("--vary", "iterations=1e3"), "iterations is a whole number from 1 to 1000"),
        (("--steps", 5), "--steps is for --over-time"),
        (("--measure", "top"), "--measure is for --over-time"),
        (("--over-time", "--measure", "tip"), '--measure tip: there is none of that name; did you mean "top"?'),
        (("--figure", "ends"), "--figure chooses what --svg FILE draws"),
        (("--figure", "ends", "--svg", tmp_path / "a.svg"), "--figure ends is drawn with --over-time"),
        (("--over-time", "--figure", "impulse", "--svg", tmp_path / "a.svg"), "impulse is drawn without --over-time"),
        (("--svg", tmp_path / "a.png"), "must end in .svg"),
    ]:
        done = cli("solver", path, *arguments)
        assert done.code == 2, arguments
        assert message in done.err, arguments
        assert done.out == ""
    done = cli("solver", write_scene("far.scene.json", bodies=far))
    assert (done.code, "nothing touches; give another one with --step" in done.err) == (2, True)
    assert "this scene has 2 joints" in cli("solver", "cart").err
