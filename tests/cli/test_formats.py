"""`sandbox import` and `sandbox export`, and other commands on files of other programs."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.scene import load_scene
from tests.cli.conftest import cli  # noqa: F401

DRAWING = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="320" height="320"><text>hi</text>'
    '<rect class="static" y="300" width="320" height="20"/><circle cx="160" cy="250" r="16"/></svg>'
)


@pytest.fixture(autouse=True)
def drawing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "ball.drawing"  # no ending tells what it is
    path.write_text(DRAWING, encoding="utf-8")
    return path


def test_import_writes_a_scene_and_lists_the_rest(cli: Callable) -> None:  # noqa: F811
    done = cli("import", "ball.drawing", "-o", "ball.scene.json")
    assert (done.code, done.out) == (0, "ball.scene.json: 2 bodies, 0 joints, from a file in the format svg\n")
    assert done.err == "ball.drawing: elements of the kind text are left out: line 1 <text>\n"
    assert [body.id for body in load_scene("ball.scene.json").bodies] == ["body-1", "body-2"]


def test_import_for_machines(cli: Callable) -> None:  # noqa: F811
    done = cli("import", "ball.drawing", "-o", "ball.scene.json", "--units-per-metre", "16", "--json")
    assert json.loads(done.out) == {
        "format": 1, "sandbox": sandbox.__version__, "exit_code": 0,
        "path": "ball.scene.json", "file_format": "svg", "bodies": 2, "joints": 0,
        "remarks": [{"place": "line 1 <text>", "text": "elements of the kind text are left out"}],
    }  # fmt: skip
    assert load_scene("ball.scene.json").bodies[1].shapes[0].circle == 1


def test_layers_that_a_map_does_not_have(cli: Callable) -> None:  # noqa: F811
    Path("map.tmj").write_text('{"layers": [], "tilewidth": 8, "tileheight": 8}')
    done = cli("import", "map.tmj", "-o", "map.scene.json", "--solid", "sea", "--solid", "sky")
    assert done.code == 2
    assert 'no tile layer is named "sea"; there are none' in done.err


def test_a_file_that_is_there_stays(cli: Callable) -> None:  # noqa: F811
    Path("out.scene.json").write_text("mine")
    assert cli("import", "ball.drawing", "-o", "out.scene.json").code == 2
    assert cli("export", "pyramid-10", "-o", "out.scene.json").code == 2
    assert Path("out.scene.json").read_text() == "mine"
    assert cli("import", "ball.drawing", "-o", "out.scene.json", "--force").code == 0


@pytest.mark.parametrize(
    ("format", "message"),
    [("rube", "this is no file of the format rube (R.U.B.E. (b2dJson))"), ("dwg", "no such format; known are rube")],
)
def test_another_format_than_it_is(cli: Callable, format: str, message: str) -> None:  # noqa: F811
    done = cli("import", "ball.drawing", "-o", "out.scene.json", "--format", format)
    assert done.code == 2
    assert message in done.err


def test_check_and_events_take_such_a_file(cli: Callable) -> None:  # noqa: F811
    done = cli("check", "ball.drawing", "--steps", "60")
    assert done.code == 0
    assert "holds" in done.out
    assert "elements of the kind text are left out" in done.err
    assert "body-1" in cli("events", "ball.drawing", "--steps", "60", "--kind", "begin").out


@pytest.mark.parametrize(
    "arguments",
    [
        ["sat", "ball.drawing", "--json"],
        ["solver", "ball.drawing", "--over-time", "--steps", "2"],
        ["compare", "ball.drawing", "--steps", "2"],
        ["compare", "ball.drawing", "--steps", "2", "--twin=simple"],
        ["diff", "ball.drawing", "ball.drawing"],
        ["bench", "ball.drawing", "--engines", "pymunk", "--steps", "2"],
        ["sweep", "ball.drawing", "--vary", "gravity.1=-9,-3", "--steps", "1", "--collect", "energy", "-j", "1"],
        ["expand", "ball.drawing"],
        ["lint", "ball.drawing", "--ignore", "no-expect"],
    ],
)
def test_every_command_takes_such_a_file(cli: Callable, arguments: list[str]) -> None:  # noqa: F811
    done = cli(*arguments)
    assert (done.code, "elements of the kind text are left out" in done.err) == (0, True), done


def test_a_finding_in_such_a_file_says_where(cli: Callable) -> None:  # noqa: F811
    done = cli("lint", "ball.drawing", "--select", "no-expect")
    assert (done.code, done.out.splitlines()[0].partition(": ")[0]) == (1, "ball.drawing")


def test_a_damaged_file_is_told_once(cli: Callable) -> None:  # noqa: F811
    Path("bad.svg").write_text(DRAWING.replace("</svg>", ""))
    done = cli("check", "bad.svg")
    assert done.code == 2
    assert "bad.svg:1:" in done.out + done.err


def test_export_of_an_import(cli: Callable) -> None:  # noqa: F811
    assert cli("export", "ball.drawing", "-o", "world.json").code == 0
    done = cli("import", "world.json", "-o", "back.scene.json", "--json")
    assert json.loads(done.out)["file_format"] == "planck"


@pytest.mark.parametrize(
    ("name", "message"),
    [("a.svg", "pictures and pages are made by sandbox render"), ("a.scene.json", "are scenes"), ("a.dwg", "end in")],
)
def test_what_export_does_not_write(cli: Callable, name: str, message: str) -> None:  # noqa: F811
    done = cli("export", "pyramid-10", "-o", name)
    assert done.code == 2
    assert message in done.err
