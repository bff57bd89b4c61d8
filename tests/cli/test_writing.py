"""What the commands write: a full disk harms nothing that was there, and nothing is written over unasked."""

from __future__ import annotations

import errno
import importlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

WRITERS = {
    "record": ("record", "a.scene.json", "--force", "-o", "out.replay.json"),
    "png": ("render", "a.scene.json", "--size", "64x48", "-o", "out.png"),
    "gif": ("render", "a.scene.json", "--size", "64x48", "--steps", "3", "-o", "out.gif"),
    "page": ("render", "a.scene.json", "-o", "out.html"),
    "sat": ("sat", "a.scene.json", "--bodies", "ground", "crate", "--svg", "out.svg"),
    "solver": ("solver", "a.scene.json", "--svg", "out.svg"),
    "junit": ("replay", "a.scene.json", "--junit", "out.xml"),
    "report": ("replay", "a.scene.json", "--report", "out.html"),
    "update": ("replay", "a.scene.json", "--update=all"),
    "plot": ("compare", "a.scene.json", "--twin=simple", "--plot", "out.svg"),
}


@pytest.fixture(autouse=True)
def here(write_scene: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene in the current folder; what was failed last is kept there, too."""
    write_scene("a.scene.json", {"at": 20, "rests": "crate"})
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CI", raising=False)


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_is_one_line_and_harms_nothing(cli: Callable, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    arguments = WRITERS[name]
    output = Path("a.replay.json" if name == "update" else arguments[-1])
    if name in ("junit", "report"):
        assert cli("record", "a.scene.json", "-o", "a.replay.json").code == 0
    output.write_text("what was there")
    if name == "update":
        assert cli("record", "a.scene.json", "--force", "-o", output).code == 0
    before, listed = output.read_bytes(), sorted(os.listdir())

    def full(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as disk:
        disk.setattr(os, "fsync", full)
        done = cli(*arguments)
    told = done.err
    assert (done.code, told.count("it cannot be written: No space left on device")) == (2, 1), told
    assert output.name in told
    assert (output.read_bytes(), sorted(os.listdir())) == (before, listed)


@pytest.mark.parametrize("name", ["record", "png", "page", "sat", "junit", "report"])
def test_a_folder_that_is_not_there_is_told_before_anything_runs(
    cli: Callable, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    *arguments, output = WRITERS[name]
    monkeypatch.setattr("sandbox.engine.world.World.step", None)
    done = cli(*arguments, f"no/{output}")
    assert (done.code, "no does not exist" in done.err, done.err.count("\n")) == (2, True, 1)


@pytest.mark.parametrize("name", ["a.scene.json", "a.replay.json"])
@pytest.mark.parametrize("command", ["check", "replay"])
def test_no_report_goes_over_a_scene_or_a_recording(cli: Callable, command: str, name: str) -> None:
    """As where the name of the report was forgotten, and the next word is taken for it."""
    assert cli("record", "a.scene.json", "-o", "a.replay.json").code == 0
    before = Path(name).read_bytes()
    done = cli(command, "--junit", name, ".")
    assert (done.code, done.err) == (2, f"sandbox: --junit {name}: the name must end in .xml\n")
    assert Path(name).read_bytes() == before


class TestRecordingOver:
    """`sandbox record` where there is a file of that name."""

    def test_it_is_refused_before_anything_runs(self, cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
        path = Path("a.replay.json")
        path.write_text("600 steps")
        monkeypatch.setattr("sandbox.engine.world.World.step", None)
        done = cli("record", "a.scene.json", "-o", path)
        assert (done.code, "there is a file of that name already; --force writes over it" in done.err) == (2, True)
        assert path.read_text() == "600 steps"

    def test_it_is_done_with_force(self, cli: Callable) -> None:
        path = Path("a.replay.json")
        path.write_text("600 steps")
        assert cli("record", "a.scene.json", "-o", path, "--force").code == 0
        assert json.loads(path.read_text())["steps"] == 20


@pytest.mark.parametrize("arguments", [
    ("record", "a.scene.json", "-o", "b.replay.json"), ("expand", "a.scene.json", "-o", "b.scene.json"),
    ("new", "stack", "-o", "b.scene.json"), ("export", "a.scene.json", "-o", "b.py"),
    ("bench", "a.scene.json", "--engines", "sandbox", "--steps", "2", "-o", "b.json"),
    ("import", "a.svg", "-o", "b.scene.json"),
], ids=lambda arguments: arguments[0])  # fmt: skip
def test_what_somebody_writes_meanwhile_is_not_written_over(
    cli: Callable, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...]
) -> None:
    """As by the same command, started twice: when they began, there was no such file."""
    Path("a.svg").write_text(DRAWING)
    Path(arguments[-1]).write_text("of the other")
    module = f"sandbox.cli.{arguments[0]}{'_' * (arguments[0] == 'import')}"
    checks = "_check_output" if arguments[0] == "record" else "check_new"
    importlib.import_module(module)
    monkeypatch.setattr(sys.modules[module], checks, lambda *_: None)
    done = cli(*arguments)
    assert (done.code, "there is a file of that name already" in done.err) == (2, True), done
    assert Path(arguments[-1]).read_text() == "of the other"


DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><rect id="crate" width="2" height="2"/></svg>'


@pytest.mark.parametrize("command", ["render", "sat", "solver"])
def test_no_picture_goes_over_the_drawing_that_it_is_made_of(cli: Callable, command: str) -> None:
    Path("a.svg").write_text(DRAWING)
    Path("other.svg").symlink_to("a.svg")
    option = "-o" if command == "render" else "--svg"
    done = cli(command, "a.svg", option, "other.svg", *(["--bodies", "crate", "crate"] if command == "sat" else []))
    assert (done.code, Path("a.svg").read_text()) == (2, DRAWING)
    assert "other.svg: it would go over what it is made of; give it another name" in done.err


@pytest.mark.parametrize(
    "words",
    [("export", "a.json", "-o"), ("bench", "a.json", "--engines", "sandbox", "--steps", "1", "-o"),
     ("import", "drawing.json", "-o"), ("expand", "a.json", "-o")],
)  # fmt: skip
def test_nothing_goes_over_what_it_is_made_of(cli: Callable, words: tuple[str, ...]) -> None:
    """Not even with --force, which is for what an earlier call has left: `bench` wrote its figures over the scene."""
    Path("a.scene.json").rename("a.json")
    Path("drawing.json").write_text(DRAWING)
    source = Path(words[1])
    before = source.read_bytes()
    Path("other.json").symlink_to(source)
    for name in (words[1], "other.json"):
        done = cli(*words, name, "--force")
        assert (done.code, source.read_bytes()) == (2, before)
        assert f"{name}: it would go over what it is made of; give it another name" in done.err
    assert cli(*words, "new.json", "--force").code == 0
    assert cli(*words, "new.json", "--force").code == 0


@pytest.mark.parametrize(
    ("words", "link"),
    [("record a.scene.json -o out.replay.json", "out.replay.json"), ("gallery . -o out.html", "out.html"),
     ("sweep a.scene.json --vary gravity.1=-9,-8 -o out.csv", "out.csv"), ("check . --junit out.xml", "out.xml"),
     ("replay a.scene.json --report out.html", "out.html"), ("compare . --twin=simple --plot out.svg", "out.svg"),
     ("run a.scene.json --screenshot out.png", "out.png")],
)  # fmt: skip
def test_no_link_leads_back_to_the_scene(cli: Callable, words: str, link: str) -> None:
    """What is written goes where a link says, whatever the link is called."""
    before = Path("a.scene.json").read_bytes()
    Path(link).symlink_to("a.scene.json")
    force = ["--force"] * (words.split()[0] in ("record", "sweep"))
    done = cli(*words.split(), *force)
    assert (done.code, Path("a.scene.json").read_bytes()) == (2, before)
    assert f"{link}: it would go over what it is made of; give it another name" in done.err


@pytest.mark.parametrize("command", ["expand", "export"])
def test_nothing_goes_over_what_a_scene_includes(cli: Callable, write_scene: Callable, command: str) -> None:
    """All that is in it went into a file that no longer has a part for others to include."""
    part = '{"materials": {"ice": {"friction": 0.01}}}'
    Path("part.json").write_text(part)
    write_scene("b.scene.json", include=["part.json"])
    done = cli(command, "b.scene.json", "-o", "part.json", "--force")
    assert (done.code, Path("part.json").read_text()) == (2, part)
    assert "part.json: it would go over what it is made of; give it another name" in done.err


def test_a_folder_is_told_to_be_one(cli: Callable) -> None:
    """`--force writes over it` was said of a folder, too, and was not true."""
    Path("folder").mkdir()
    for command in ("new", "stack"), ("expand", "a.scene.json"):
        done = cli(*command, "-o", "folder")
        assert (done.code, "it is a folder" in done.err, "--force" in done.err) == (2, True, False)


def test_figures_go_over_no_scene_and_no_recording(cli: Callable) -> None:
    before = Path("a.scene.json").read_text()
    for name in ("a.scene.json", "b.scene.json", "b.replay.json"):
        done = cli("bench", "a.scene.json", "--engines", "sandbox", "--steps", "1", "-o", name, "--force")
        assert "that is how scenes and recordings are named" in done.err
        assert (done.code, Path("a.scene.json").read_text(), Path("b.scene.json").exists()) == (2, before, False)


def test_a_schema_goes_over_no_scene(cli: Callable) -> None:
    before = Path("a.scene.json").read_text()
    done = cli("schema", "-o", "a.scene.json")
    assert (done.code, Path("a.scene.json").read_text()) == (2, before)
    assert "there is a file of that name already" in done.err
    assert [cli("schema", "-o", "scene.schema.json").code for _ in range(2)] == [0, 0]


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
@pytest.mark.parametrize("name", ["SIGTERM", "SIGKILL"])
@pytest.mark.slow
def test_processes_end_with_the_one_that_started_them(write_scene: Callable, name: str) -> None:
    """Whoever reads what they print comes to its end."""
    number = getattr(signal, name)
    for file in ("b.scene.json", "c.scene.json"):
        write_scene(file, settings={"steps": 1_000_000, "sleeping": False})
    command = [sys.executable, "-m", "sandbox", "check", ".", "-j", "2"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    line = process.stdout.readline()  # type: ignore[union-attr]
    while "a.scene.json" not in line:
        line = process.stdout.readline()  # type: ignore[union-attr]
        assert line
    process.send_signal(number)
    _, told = process.communicate(timeout=1800)
    assert process.returncode == (128 + number if name == "SIGTERM" else -number)
    if name == "SIGTERM":
        assert told == ""


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
@pytest.mark.slow
def test_a_sweep_that_is_told_to_end_says_what_is_kept(write_scene: Callable) -> None:
    write_scene("long.scene.json", settings={"steps": 1, "sleeping": False})
    varied = ["--vary", "settings.steps=1,1000000,1000000", "-j", "2", "-o", "table.csv"]
    command = [sys.executable, "-m", "sandbox", "sweep", "long.scene.json", *varied]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    journal = Path("table.csv.journal")
    while process.poll() is None and not (journal.exists() and len(journal.read_text().splitlines()) == 2):
        time.sleep(0.05)
    process.send_signal(signal.SIGTERM)
    _, told = process.communicate(timeout=1800)
    assert process.returncode == 128 + signal.SIGTERM
    assert "1 of 3 runs are kept" in told
    assert "leaked" not in told
