"""`sandbox bisect`: the commit from which on a run goes another way."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.revisions.conftest import SOFTER, History


@pytest.mark.slow(seconds=10)
def test_it_finds_the_line_of_the_solver(cli: Callable, history: History, golden: Path) -> None:
    first, last = history.commits[0], history.commits[-1]
    done = cli("bisect", golden, "--good", first, "--bad", last, "--engine", history.root, "--no-jit")
    assert done.code == 0, done.out + done.err
    assert f"  {history.commits[4][:12]} pushes softer\n" in done.out
    assert "crate" in done.out
    assert f"show it: git show {history.commits[4][:12]}" in done.out
    assert history.worktrees() == 1


@pytest.mark.slow(seconds=10)
def test_a_revision_that_cannot_run_is_skipped_and_named(cli: Callable, history: History, golden: Path) -> None:
    first, broken, bad = history.commits[0], history.commits[2], history.commits[4]
    done = cli("bisect", golden, "--good", first, "--bad", bad, "--engine", history.root, "--no-jit", "--json")
    found = json.loads(done.out)
    assert done.code == 0
    assert [one["hash"] for one in found["suspects"]] == [bad]
    assert [one["commit"]["hash"] for one in found["skipped"]] == [broken]
    assert "SyntaxError" in found["skipped"][0]["reason"]
    assert found["divergence"]["detail"]["body"] == "crate"


@pytest.mark.slow(seconds=10)
def test_where_some_cannot_run_it_is_one_of_several(cli: Callable, history: History, golden: Path) -> None:
    history.git("checkout", "--quiet", "-b", "side", history.commits[2])
    history.commit("pushes softer, but nothing runs", *SOFTER)
    history.commit("runs again", "sandbox/tables.py", "import numpy as np !", "import numpy as np")
    side, history.commits[6:] = history.commits[6:], []
    history.git("checkout", "--quiet", "-")
    done = cli("bisect", golden, "--good", history.commits[1], "--bad", "side", "--engine", history.root, "--no-jit")
    assert done.code == 1, done.err
    assert "one of these is the first:" in done.out
    assert all(commit[:12] in done.out for commit in [history.commits[2], *side])


@pytest.fixture
def call(cli: Callable, history: History, golden: Path) -> Callable[[str, str], tuple[int, str]]:
    """Bisects between two revisions; the exit code and all that is printed."""

    def between(good: str, bad: str) -> tuple[int, str]:
        done = cli("bisect", golden, "--good", good, "--bad", bad, "--engine", history.root, "--no-jit")
        return done.code, done.out + done.err

    return between


def test_ends_that_cannot_be(call: Callable, history: History) -> None:
    code, text = call(history.commits[4], history.commits[1])
    assert (code, "is no ancestor of the bad one" in text) == (2, True)
    code, text = call(history.commits[1], history.commits[1])
    assert (code, f"are the same one, {history.commits[1][:12]}" in text) == (2, True)
    code, text = call("nowhere", history.commits[1])
    assert (code, "there is no revision" in text) == (2, True)


@pytest.mark.slow(seconds=10)
def test_ends_that_cannot_run_or_do_not_differ(call: Callable, history: History) -> None:
    commits = history.commits
    code, text = call(commits[0], commits[2])
    assert (code, "cannot run it" in text) == (2, True)
    code, text = call(commits[0], commits[1])
    assert (code, "no difference" in text) == (5, True)
    assert "\nboth do what was recorded\n" in text
    code, text = call(commits[2], commits[3])
    assert (code, f"the good commit {commits[2][:12]} broken cannot run it: SyntaxError" in text) == (2, True)


@pytest.mark.slow(seconds=10)
def test_a_good_revision_that_does_not_do_what_was_recorded(cli: Callable, history: History, golden: Path) -> None:
    lines = golden.read_text(encoding="utf-8").split("\n")
    lines[lines.index('  "digests": [') + 3] = '    "0000 0000 0000 0000",'
    golden.write_text("\n".join(lines), encoding="utf-8")
    options = ["--engine", history.root, "--no-jit", "--good", history.commits[3], "--bad"]
    done = cli("bisect", golden, *options, history.commits[4])  # the next one: nothing is between
    assert done.code == 0
    assert "the good revision does not do what was recorded either, from step 3 on;\n" in done.out
    assert f"  {history.commits[4][:12]} pushes softer\n" in done.out
    done = cli("bisect", golden, *options[:-3], "--good", history.commits[4], "--bad", history.commits[5])
    assert done.code == 5
    assert "neither does what was recorded, from step" in done.out
