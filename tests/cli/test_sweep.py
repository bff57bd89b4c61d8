"""`sandbox sweep`: tables on disk, sweeps that go on after a crash, and what it refuses."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from sandbox.sweeps import sweep as module

VARY = ("--vary", "gravity.1=-12:-2:6", "--vary", "bodies.crate.velocity.0=1,2")
COLLECT = ("--collect", "body('crate').x", "--collect", "top = max(body('crate').speed)")


@pytest.fixture
def scene(write_scene: Callable[..., Path]) -> Path:
    return write_scene("slide.scene.json")


def test_a_table_is_written(cli: Callable, scene: Path, tmp_path: Path) -> None:
    output = tmp_path / "t.csv"
    done = cli("sweep", scene, *VARY, *COLLECT, "-o", output)
    assert (done.code, done.err) == (0, "")
    assert "t.csv: 12 runs" in done.out
    lines = output.read_text().splitlines()
    assert lines[0] == "gravity.1,bodies.crate.velocity.0,crate_x,top,digest,steps,status"
    assert len(lines) == 13
    assert not (tmp_path / "t.csv.journal").exists()
    assert cli("sweep", scene, *VARY, *COLLECT).out.splitlines()[:13] == lines


def test_the_document(cli: Callable, scene: Path) -> None:
    document = json.loads(cli("sweep", scene, "--vary", "gravity.1=-9,-1", "--steps", "3", "--json").out)
    assert (document["runs"], document["failed"], document["exit_code"]) == (2, 0, 0)
    assert [row["gravity.1"] for row in document["rows"]] == [-9, -1]
    assert [row["steps"] for row in document["rows"]] == [3, 3]


def test_runs_that_fail(cli: Callable, scene: Path) -> None:
    done = cli("sweep", scene, "--vary", "settings.substeps=4,0", "--steps", "1")
    assert done.code == 1
    assert "1 of 2 runs failed, the first with: " in done.err
    assert "substeps must not be below 1" in done.out.splitlines()[2]


def test_a_sweep_that_was_ended_goes_on(
    cli: Callable, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    output, whole = tmp_path / "t.csv", tmp_path / "whole.csv"
    cli("sweep", scene, *VARY, *COLLECT, "-o", whole)
    really, made = module.run_here, []

    def ended(study: Any, jobs: Any) -> Iterator[Any]:
        for outcome in really(study, jobs):
            made.append(outcome.run)
            if len(made) == 5:
                raise OSError(28, "No space left on device")
            yield outcome

    monkeypatch.setattr(module, "run_here", ended)
    assert cli("sweep", scene, *VARY, *COLLECT, "-o", output, "-j", 1).code == 2
    assert not output.exists()
    refused = cli("sweep", scene, *VARY, *COLLECT, "-o", output)
    assert refused.code == 2
    assert "--resume goes on with it" in refused.err
    other = cli("sweep", scene, *VARY, "-o", output, "--resume")
    assert (other.code, "of another sweep" in other.err) == (2, True)
    made.clear()
    made += [-1] * 6  # it is not ended again
    assert cli("sweep", scene, *VARY, *COLLECT, "-o", output, "--resume", "-j", 1).code == 0
    assert made[6:] == list(range(4, 12))
    assert output.read_bytes() == whole.read_bytes()
    assert not (tmp_path / "t.csv.journal").exists()


def test_a_plot_of_a_table_that_is_there(cli: Callable, scene: Path, tmp_path: Path) -> None:
    table, plot = tmp_path / "t.csv", tmp_path / "p.svg"
    cli("sweep", scene, *VARY, *COLLECT, "-o", table, "--plot", plot, "--by", "bodies.crate.velocity.0")
    first = plot.read_bytes()
    done = cli("sweep", table, "--plot", plot, "--x", "gravity.1", "--y", "crate_x", "--y", "top", "--theme", "light")
    assert done.code == 0
    assert plot.read_bytes() != first


def test_over_two_values_it_is_a_heat_map(cli: Callable, scene: Path, tmp_path: Path) -> None:
    table, plots = tmp_path / "t.csv", [tmp_path / "p.svg", tmp_path / "q.svg"]
    title = "title=top over gravity.1 and bodies.crate.velocity.0"
    cli("sweep", scene, *VARY, *COLLECT, "-o", table, "--plot", plots[0], "--set", title)
    cli("sweep", table, "--plot", plots[1], "--x", "gravity.1", "--over", "bodies.crate.velocity.0", "--y", "top")
    assert plots[0].read_bytes() == plots[1].read_bytes()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "nothing varies"),
        (("--vary", "gravity.1"), "write PATH=VALUES"),
        (("--vary", "gravity.1=1", "--vary", "gravity.1=2"), "given twice"),
        (("--vary", "gravity.1=1", "-o", "t.xlsx"), "must end in .csv or .parquet"),
        (("--vary", "gravity.1=1", "-o", "no/such/t.csv"), "does not exist"),
        (("--vary", "gravity.1=1", "--resume"), "name it with -o"),
        (("--vary", "gravity.1=1", "--plot", "p.gif"), "must end in .png or .svg"),
        (("--vary", "gravity.1=1", "--plot", "p.png"), "nothing is collected"),
        (("--vary", "gravity.1=1", "--plot", "p.png", "--collect", "energy", "--x", "gravity.2"), "no column"),
        (("--vary", "bodies.crat.angle=1"), 'did you mean "crate"'),
        (("--vary", "gravity.1=1", "--collect", "body('crat').x"), 'did you mean "crate"'),
    ],
)
def test_what_cannot_be_done_is_told_at_once(
    cli: Callable, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: Any, said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    done = cli("sweep", scene, *arguments)
    assert (done.code, done.out) == (2, "")
    assert said in " ".join(done.err.split())
    assert os.listdir(tmp_path) == [scene.name]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="no such signal")
@pytest.mark.parametrize(
    "option", [VARY[:2], COLLECT[:2], ("--set", "gravity.1=-1"), ("--steps", "3"), ("-o", "u.csv"), ("--sample", "3")]
)
def test_a_table_is_only_drawn(cli: Callable, scene: Path, tmp_path: Path, option: tuple[str, str]) -> None:
    """Options about runs were passed over in silence: no run was made, and the plot was not of what was asked for."""
    table, plot = tmp_path / "t.csv", tmp_path / "p.svg"
    table.write_text("gravity.1,top\n-9,1\n-8,2\n")
    done = cli("sweep", table, "--plot", plot, *option)
    assert (done.code, plot.exists()) == (2, False)
    assert "is a table, which is only drawn" in done.err


def test_what_varies_is_not_set_as_well(cli: Callable, scene: Path) -> None:
    vary = ("--vary", "bodies.crate.velocity=[1,0],[2,0]"), ("--vary", "gravity.1=-9,-1")
    for varied, value in ((vary[1], "gravity.1=-3"), (vary[0], "bodies.crate.velocity.1=1")):
        done = cli("sweep", scene, *varied, "--steps", "1", "--set", value)
        assert (done.code, done.out) == (2, "")
        assert "leave one of them away" in done.err
    assert cli("sweep", scene, *vary[1], "--steps", "1", "--set", "gravity=[1,2]").code == 0


def test_an_address_of_no_scheduler_is_told_at_once(cli: Callable, scene: Path) -> None:
    """Dask took 20 s to give up a client without an address, and printed a traceback at the end."""
    distributed = pytest.importorskip("distributed")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(distributed, "Client", lambda *_, **__: pytest.fail("a client of nobody"))
        for address in ("bogus", "tcp://", "foo://a:1", "tcp://a:b"):
            done = cli("sweep", scene, "--vary", "gravity.1=-9,-1", "--scheduler", address)
            assert done.code == 2
            assert f"--scheduler {address}: no Dask scheduler answers there" in done.err


def test_a_killed_sweep_goes_on(cli: Callable, scene: Path, tmp_path: Path) -> None:
    output, whole, journal = tmp_path / "t.csv", tmp_path / "whole.csv", tmp_path / "t.csv.journal"
    arguments = ["sweep", str(scene), "--vary", "gravity.1=-12:-2:150", "--steps", "60", *COLLECT]
    command = [sys.executable, "-m", "sandbox", *arguments, "-o", str(output), "-j", "2"]
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while running.poll() is None and not (journal.exists() and journal.read_bytes().count(b"\n") > 10):
        time.sleep(0.005)
    running.send_signal(signal.SIGKILL)
    running.wait()
    finished = journal.read_bytes().count(b"\n") - 1
    assert 10 <= finished < 150
    assert cli(*arguments, "-o", output, "--resume", "-j", 1).code == 0
    cli(*arguments, "-o", whole, "-j", 1)
    assert output.read_bytes() == whole.read_bytes()
