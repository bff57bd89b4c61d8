"""Scenes and recordings of a user's repository as tests."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import pytest

from tests.cli.conftest import CRATE, GROUND

RESTS = {"at": 20, "rests": "crate"}
HIGHER = [GROUND, CRATE | {"position": [0, 0.6]}]


def edit(path: Path, old: str, new: str) -> None:
    """Replace the first `old` in a file."""
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def first_digest(replay: Path) -> str:
    return json.loads(replay.read_text(encoding="utf-8"))["digests"][0]


def spoil(replay: Path) -> None:
    """Another number in the poses of the first step."""
    digest = first_digest(replay)
    edit(replay, digest, digest[:-1] + ("0" if digest[-1] != "0" else "1"))


class TestScenes:
    def test_one_that_holds_passes(self, home: pytest.Pytester, put: Callable) -> None:
        put("scenes/good.scene.json", RESTS)
        put("scenes/silent.scene.json")
        home.runpytest().assert_outcomes(passed=1)

    def test_one_that_fails_says_what_where_and_no_more(self, home: pytest.Pytester, put: Callable) -> None:
        put("bad.scene.json", {"at": 20, "below": 0.2}, {"at": 20, "rests": "crate"})
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        assert re.search(r"bad\.scene\.json:\d+: \{", done.stdout.str())
        assert "Traceback" not in done.stdout.str()
        assert "runtest" not in done.stdout.str()

    def test_one_that_cannot_be_used_shows_its_mistake(self, home: pytest.Pytester, put: Callable) -> None:
        put("odd.scene.json", RESTS, gravitee=[0, 1])
        (home.path / "broken.scene.json").write_text("{", encoding="utf-8")
        done = home.runpytest()
        done.assert_outcomes(failed=2)
        done.stdout.re_match_lines([r"broken\.scene\.json:1:\d+: .*", r"odd\.scene\.json:\d+:\d+: unknown field .*"])
        assert "def " not in done.stdout.str()


class TestRecordings:
    def test_the_same_bits_pass(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        keep(put("a.scene.json"))
        home.runpytest("-v").assert_outcomes(passed=1)

    def test_other_bits_say_step_group_and_commands(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        spoil(keep(put("a.scene.json")))
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines(
            [
                "a.replay.json: diverged",
                "  step 1 (0.017 s): poses: expected * got *",
                "  look at it: sandbox run a.replay.json --step 0",
                "  accept it:  sandbox replay --update a.replay.json",
            ]
        )
        assert "Traceback" not in done.stdout.str()

    def test_an_edited_scene_is_stale_and_the_body_has_a_place(
        self, home: pytest.Pytester, put: Callable, keep: Callable
    ) -> None:
        keep(put("scenes/a.scene.json"))
        scene = put("scenes/a.scene.json", bodies=HIGHER)
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        line = 1 + scene.read_text().split('"crate"')[0].count("\n") - 1
        done.stdout.fnmatch_lines(
            [
                "scenes/a.replay.json: stale",
                "  since it was recorded, body crate was edited",
                f"  body crate: scenes/a.scene.json:{line}:3",
            ]
        )

    def test_a_corrupt_one_is_one_clear_error(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        edit(keep(put("a.scene.json")), '"steps": 20', '"steps": "many"')
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.re_match_lines([r"a\.replay\.json:\d+:\d+: .*whole number.*"])

    @pytest.mark.parametrize("trouble", ["none", "diverged", "stale", "orphaned", "missing"])
    def test_the_same_verdict_as_sandbox_replay(
        self, home: pytest.Pytester, put: Callable, keep: Callable, cli: Callable, trouble: str
    ) -> None:
        home.makeini("[pytest]\nsandbox_recordings_required = true\n")
        scene = put("a.scene.json", RESTS)
        replay = keep(scene)
        if trouble == "diverged":
            spoil(replay)
        elif trouble == "stale":
            put("a.scene.json", RESTS, bodies=[GROUND, CRATE | {"position": [0, 0.7]}])
        elif trouble == "orphaned":
            scene.unlink()
        elif trouble == "missing":
            replay.unlink()
        done = home.runpytest()
        told = cli("replay", ".")
        assert int(done.ret) == told.code == (0 if trouble == "none" else 1)
        if trouble != "none":
            assert f"a.replay.json: {trouble}" in done.stdout.str()
            assert trouble in told.out


class TestUpdate:
    def test_it_writes_what_changed_and_what_is_missing(
        self, home: pytest.Pytester, put: Callable, keep: Callable
    ) -> None:
        replay = keep(put("a.scene.json"))
        before = replay.read_text()
        spoil(replay)
        put("b.scene.json", RESTS)
        done = home.runpytest("--replay-update")
        done.assert_outcomes(passed=3)
        done.stdout.fnmatch_lines(["*recordings written*", "a.replay.json", "b.replay.json"])
        assert replay.read_text() == before
        home.runpytest().assert_outcomes(passed=3)

    def test_missing_leaves_what_changed(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        replay = keep(put("a.scene.json"))
        spoil(replay)
        before = replay.read_text()
        put("b.scene.json", RESTS)
        home.runpytest("--replay-update=missing").assert_outcomes(passed=2, failed=1)
        assert replay.read_text() == before

    def test_nothing_is_written_where_ci_is_set(
        self, home: pytest.Pytester, put: Callable, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        put("a.scene.json", RESTS)
        monkeypatch.setenv("CI", "true")
        done = home.runpytest("--replay-update")
        assert done.ret == pytest.ExitCode.USAGE_ERROR
        done.stderr.fnmatch_lines(["*--replay-update: CI is set*"])
        assert not (home.path / "a.replay.json").exists()

    def test_a_path_is_not_taken_for_a_mode(self, home: pytest.Pytester, put: Callable) -> None:
        put("a.scene.json", RESTS)
        done = home.runpytest("--replay-update", "a.scene.json")
        assert done.ret == pytest.ExitCode.USAGE_ERROR
        done.stderr.fnmatch_lines(["*before a path write --replay-update=changed*"])


class TestPage:
    def test_it_has_a_player_for_what_failed(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        keep(put("a.scene.json"))
        keep(put("b.scene.json"))
        put("b.scene.json", bodies=HIGHER)
        done = home.runpytest("--replay-report", "page.html")
        done.assert_outcomes(passed=1, failed=1)
        done.stdout.fnmatch_lines(["page on recordings: page.html"])
        text = (home.path / "page.html").read_text(encoding="utf-8")
        assert "a.replay.json" in text
        assert "body crate was edited" in text
        assert text.count('class="player') == 1

    def test_a_page_that_cannot_be_written_is_one_line(
        self, home: pytest.Pytester, put: Callable, keep: Callable
    ) -> None:
        keep(put("a.scene.json"))
        done = home.runpytest("--replay-report", "nowhere/page.html")
        done.stdout.fnmatch_lines(["nowhere/page.html: it cannot be written: the folder *nowhere does not exist"])


class TestManners:
    def test_collecting_loads_no_engine(self, home: pytest.Pytester, put: Callable) -> None:
        put("a.scene.json", RESTS)
        code = (
            "import sys, pytest; pytest.main(['--collect-only', '-p', 'sandbox.pytest_plugin']);"
            "print(sorted({'numba', 'numpy', 'pydantic', 'rich', 'typer'} & set(sys.modules)))"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        assert "SceneItem check" in done.stdout
        assert done.stdout.splitlines()[-1] == "[]"

    def test_the_entry_point_is_this_plugin(self) -> None:
        project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))
        (module,) = project["project"]["entry-points"]["pytest11"].values()
        assert import_module(module).pytest_collect_file

    def test_files_are_collected_once(self, home: pytest.Pytester, put: Callable, keep: Callable) -> None:
        keep(put("a.scene.json", RESTS))
        home.runpytest(".", "a.scene.json").assert_outcomes(passed=2)

    @pytest.mark.slow
    def test_workers_keep_the_list_of_what_was_written(self, home: pytest.Pytester, put: Callable) -> None:
        put("a.scene.json", RESTS)
        done = home.runpytest("-p", "xdist.plugin", "-n", "1", "--replay-update")
        done.stdout.fnmatch_lines(["*recordings written*", "a.replay.json"])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="has no pipes among its files")
def test_pipes_are_not_waited_for(home: pytest.Pytester) -> None:
    os.mkfifo(home.path / "a.scene.json")
    os.mkfifo(home.path / "b.replay.json")
    assert home.runpytest().ret == pytest.ExitCode.NO_TESTS_COLLECTED
    for name in ("a.scene.json", "b.replay.json"):
        assert home.runpytest(name).ret == pytest.ExitCode.USAGE_ERROR
