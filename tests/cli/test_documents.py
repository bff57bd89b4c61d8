"""What every command prints for `--json`: one document, alone on stdout, with the same keys around what it tells."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
import sandbox.cli
from sandbox.cli import app
from sandbox.cli.document import document

ENVELOPE = ["format", "sandbox", "exit_code"]
DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><rect id="crate" width="2" height="2"/></svg>'
COMMANDS: dict[str, list[str]] = {
    "list": ["list pyramid", "list nix"],
    "render": ["render a.scene.json --size 64x48 -o a.png", "render a.scene.json -o a.html",
               "render a.scene.json --size 64x48 --steps 3 -o a.gif"],
    "gallery": ["gallery . -o gallery.html", "gallery . -o gallery.png"],
    "check": ["check .", "check a.scene.json nix.scene.json", "check a.scene.json --set gravity.1=9"],
    "record": ["record a.scene.json -o b.replay.json"],
    "replay": ["replay a.replay.json", "replay a.replay.json nix.replay.json"],
    "diff": ["diff a.scene.json a.scene.json", "diff a.scene.json a.scene.json --set gravity.1=-9"],
    "bisect": ["bisect a.scene.json --good HEAD --no-jit"],
    "new": ["new stack", "new stack -o new.scene.json", "new --list"],
    "lint": ["lint a.scene.json", "lint --rules"],
    "fmt": ["fmt --check a.scene.json", "fmt nix.scene.json"],
    "import": ["import a.svg -o imported.scene.json"],
    "export": ["export a.scene.json -o a.py"],
    "sat": ["sat a.scene.json"],
    "solver": ["solver a.scene.json", "solver a.scene.json --over-time"],
    "events": ["events a.scene.json"],
    "sweep": ["sweep a.scene.json --vary gravity.1=-9,-8 -j 1 --collect energy"],
    "compare": ["compare a.scene.json", "compare --twin a.scene.json"],
    "bench": ["bench a.scene.json --engines sandbox --steps 2", "bench nix.scene.json --engines sandbox"],
    "cache": ["cache"],
}  # fmt: skip
"""Command lines of every command that reports: one at least for each way in which it makes its document."""
WITHOUT = {"run", "schema", "expand"}
"""They have no `--json`: the first opens a window, the others print nothing but JSON."""


@pytest.fixture(autouse=True)
def here(cli: Callable, write_scene: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene, a recording of it and a drawing, in the current folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("GITHUB_ACTIONS", raising=False)
    write_scene("a.scene.json", {"at": 20, "rests": "crate"})
    Path("a.svg").write_text(DRAWING)
    assert cli("record", "a.scene.json", "-o", "a.replay.json").code == 0


def test_every_command_that_reports_is_among_them() -> None:
    """So that a new one is held to it: it goes into `COMMANDS`."""
    group = app.build()
    reporting = {
        name for name in app.COMMANDS if any("--json" in option.opts for option in group.get_command(None, name).params)
    }
    assert reporting == set(COMMANDS)
    assert set(app.COMMANDS) - reporting == WITHOUT


@pytest.mark.parametrize("line", [line for lines in COMMANDS.values() for line in lines])
def test_the_document_is_alone_and_says_what_it_is(cli: Callable, line: str) -> None:
    done = cli(*line.split(), "--json")
    found = json.loads(done.out, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    assert list(found)[:3] == ENVELOPE
    assert (found["format"], found["sandbox"], found["exit_code"]) == (1, sandbox.__version__, done.code)
    assert len(found) > len(ENVELOPE)


@pytest.mark.parametrize("name", COMMANDS)
def test_so_does_that_of_an_error(cli: Callable, name: str) -> None:
    done = cli(name, "--nix", "--json")
    found = json.loads(done.out)
    assert list(found) == [*ENVELOPE, "problems"]
    assert (found["sandbox"], found["exit_code"], done.code) == (sandbox.__version__, 2, 2)


def test_nothing_else_makes_documents() -> None:
    """A command that printed its own would do without the keys that all have."""
    folder = Path(sandbox.cli.__file__).parent
    printed = []
    for file in folder.glob("*.py"):
        for call in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and any(word.arg == "indent" for word in call.keywords):
                printed.append(file.name)
    assert printed == ["document.py"]


def test_the_keys_of_all_belong_to_no_command() -> None:
    with pytest.raises(AssertionError, match="format"):
        document({"format": "planck"})


def test_numbers_that_are_none_are_null() -> None:
    found = json.loads(document({"a": float("nan"), "b": [float("inf"), {"c": (1.5, -float("inf"))}]}))
    assert (found["a"], found["b"]) == (None, [None, {"c": [1.5, None]}])


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_a_document_is_utf_8_whatever_the_terminal_writes(write_scene: Callable, encoding: str) -> None:
    """Of what an encoding lacks, `\\xe9` and `\\U0001f600` were printed, which JSON does not know."""
    title = "caf\xe9 \u6ce2 \U0001f600"
    write_scene(f"{title}.scene.json", title=title)
    command = [sys.executable, "-m", "sandbox", "lint", f"{title}.scene.json", "--json"]
    done = subprocess.run(command, capture_output=True, env=os.environ | {"PYTHONIOENCODING": encoding}, check=False)
    assert json.loads(done.stdout.decode("utf-8"))["scenes"][0]["path"] == f"{title}.scene.json"


def test_where_a_report_cannot_be_written_there_is_still_one_document(
    cli: Callable, monkeypatch: pytest.MonkeyPatch
) -> None:
    for command, file, option in (("check", "a.scene.json", "--junit"), ("replay", "a.replay.json", "--junit")):

        def fails(*_: object) -> None:
            raise OSError(28, "No space left on device", "a.xml")

        with monkeypatch.context() as disk:
            disk.setattr("sandbox.cli.junit.write_bytes", fails)
            done = cli(command, file, option, "a.xml", "--json")
        assert (done.code, json.loads(done.out)["exit_code"]) == (2, 2)
