"""What the commands write: a full disk harms nothing that was there, and nothing is written over unasked."""

from __future__ import annotations

import errno
import json
import os
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
