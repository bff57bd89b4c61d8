"""`sandbox replay --against REV`: what another revision of the engine does, side by side."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox.replay.golden.run import run_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.revisions.against import HERE
from sandbox.replay.revisions.trace import trace
from tests.revisions.conftest import History


@pytest.mark.slow
def test_the_same_code_does_the_same(cli: Callable, history: History, golden: Path) -> None:
    done = cli("replay", golden, "--against", history.commits[1], "--engine", history.root, "--no-jit")
    assert done.code == 0, done.out + done.err
    assert history.worktrees() == 1


@pytest.mark.slow(seconds=10)
def test_one_line_of_the_solver_is_named_by_step_body_and_number(cli: Callable, history: History, golden: Path) -> None:
    """The two numbers are those of the two runs, as a run with that code by itself gives them."""
    done = cli("replay", golden, "--against", "HEAD", "--engine", history.root, "--no-jit", "--json")
    assert done.code == 1, done.err
    (entry,) = json.loads(done.out)["replays"]
    parted = entry["divergence"]
    assert entry["verdict"] == "diverged"
    assert parted["step"] >= 2  # it falls first
    assert parted["detail"]["body"] == "crate"
    assert parted["detail"]["expected"] != parted["detail"]["got"]
    assert parted["detail"]["ulps"] > 0
    assert entry["where"].startswith("body crate: a.scene.json:")
    assert any(history.commits[-1][:12] in note for note in entry["notes"])
    growth = [row["distance"] for row in parted["growth"]]
    assert growth[-1] > 0.0
    detail, step, run = parted["detail"], parted["step"], run_of(Recording.load(golden))
    table = {"contact": "contacts", "body": "bodies"}[detail["table"]]
    expected, got = (
        set(trace(root, run, [step], no_jit=True).arrays[f"{step}.{table}"][detail["field"]].tolist())
        for root in (history.root, HERE)
    )
    assert detail["expected"] in expected - got
    assert detail["got"] in got - expected


def test_a_revision_that_cannot_run_says_why(cli: Callable, history: History, golden: Path) -> None:
    done = cli("replay", golden, "--against", history.commits[2], "--engine", history.root, "--no-jit")
    assert done.code == 2
    assert "SyntaxError" in done.err
    assert history.worktrees() == 1


def test_an_unknown_revision_and_a_folder_without_git(
    cli: Callable, history: History, golden: Path, tmp_path: Path
) -> None:
    done = cli("replay", golden, "--against", "nowhere", "--engine", history.root)
    assert (done.code, "there is no revision 'nowhere'" in done.err) == (2, True)
    done = cli("replay", golden, "--against", "HEAD", "--engine", tmp_path)
    assert (done.code, "no git checkout of the engine" in done.err) == (2, True)
    done = cli("replay", golden, "--against", "HEAD", "--update")
    assert (done.code, "--against" in done.err) == (2, True)
    done = cli("replay", golden, "--engine", history.root)
    assert (done.code, "--engine says where the revision of --against is: give both" in done.err) == (2, True)
