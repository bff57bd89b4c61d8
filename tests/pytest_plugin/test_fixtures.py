"""The fixtures `world` and `replay_check` in a user's tests."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox

GUIDE = Path(sandbox.__file__).with_name("replay") / "README.md"
PUSH = """
from sandbox import ApplyImpulse

def test_falls(replay_check):
    replay_check("crate", 30, [(5, ApplyImpulse("crate", ({push}, 0.0)))])
"""


def write_test(home: pytest.Pytester, text: str) -> Path:
    return home.makepyfile(test_crate=text)


class TestWorld:
    def test_by_name_path_dict_and_scene(self, home: pytest.Pytester, put: Callable) -> None:
        put("scenes/crate.scene.json")
        (home.path / "tests").mkdir()
        (home.path / "tests" / "test_it.py").write_text(
            "import sandbox\n"
            "def test_it(world):\n"
            "    for what in ('crate', '../scenes/crate.scene.json', sandbox.load_scene('scenes/crate.scene.json')):\n"
            "        made = world(what)\n"
            "        made.step(2)\n"
            "        assert made.names == ('ground', 'crate')\n"
            "    assert world('pyramid-10').names\n"
            "    assert world({'bodies': [{'id': 'a', 'shapes': [{'circle': 1}]}]}).names == ('a',)\n"
        )
        home.runpytest().assert_outcomes(passed=1)

    def test_an_unknown_name_says_where_it_was_looked_for(self, home: pytest.Pytester) -> None:
        write_test(home, "def test_it(world): world('nowhere')")
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines([f"no scene 'nowhere' in {home.path.as_posix()}, nor *"])

    @pytest.mark.parametrize(("wrong", "right"), [("crat", "crate"), ("piramid-10", "pyramid-10")])
    def test_a_misspelt_name_gets_the_nearest(
        self, home: pytest.Pytester, put: Callable, wrong: str, right: str
    ) -> None:
        put("scenes/crate.scene.json")
        write_test(home, f"def test_it(world): world('{wrong}')")
        home.runpytest().stdout.fnmatch_lines([f"no scene '{wrong}' in *: did you mean \"{right}\"?"])

    def test_a_bad_scene_shows_the_line_of_the_test_and_none_of_ours(self, home: pytest.Pytester) -> None:
        write_test(home, "def test_it(world):\n    world({'bodies': [{'id': 'a'}]})\n")
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines(["E *SceneError*", "test_crate.py:2: SceneError"])
        assert "fixtures.py" not in done.stdout.str()


class TestReplayCheck:
    def test_a_recording_that_cannot_be_written_shows_none_of_ours(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0))
        (home.path / "test_crate.test_falls.replay.json").mkdir()
        done = home.runpytest("--replay-update")
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines(["E *it cannot be written: it is a folder: *test_crate.test_falls.replay.json'"])
        assert "_atomic_write.py" not in done.stdout.str()

    def test_without_a_recording_it_fails_and_says_how_to_make_one(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0))
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines(
            [
                "*test_crate.test_falls.replay.json: missing",
                "  accept it:  pytest --replay-update=changed 'test_crate.py::test_falls'",
            ]
        )
        assert "Error" not in done.stdout.str()

    def test_written_once_it_passes_and_is_collected_once(
        self, home: pytest.Pytester, put: Callable, cli: Callable
    ) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0))
        home.runpytest("--replay-update").assert_outcomes(passed=1)
        assert (home.path / "test_crate.test_falls.replay.json").is_file()
        home.runpytest().assert_outcomes(passed=1)
        home.runpytest("test_crate.test_falls.replay.json").assert_outcomes(passed=1)
        assert cli("replay", ".").code == 0

    def test_another_push_is_found(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0))
        home.runpytest("--replay-update")
        write_test(home, PUSH.format(push=1.5))
        done = home.runpytest()
        done.assert_outcomes(failed=1)
        done.stdout.fnmatch_lines(
            [
                "*test_crate.test_falls.replay.json: stale",
                "  since it was recorded, command 1 of the test was edited*",
                "  step 6 (0.100 s): *",
                "  body crate: *crate.scene.json:*",
            ]
        )
        home.runpytest("--replay-update").assert_outcomes(passed=1)
        home.runpytest().assert_outcomes(passed=1)

    def test_what_was_edited_and_the_first_number_are_named(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0))
        home.runpytest("--replay-update")
        write_test(home, PUSH.format(push=1.5))
        home.runpytest().stdout.fnmatch_lines(
            [
                "  first: *crate*: * expected *, got * ulps off*",
                "  cause: the commands were edited: *command 1 (step 5, ApplyImpulse on crate): impulse was * and is *",
            ]
        )

    def test_a_scene_of_the_test_itself(self, home: pytest.Pytester) -> None:
        text = "def test_it(replay_check):\n    replay_check({{'bodies': [{{'id': 'a', 'position': [0, {y}]}}]}}, 5)\n"
        text = text.replace("{{'id'", "{{'shapes': [{{'circle': 1}}], 'id'")
        write_test(home, text.format(y=1))
        home.runpytest("--replay-update").assert_outcomes(passed=1)
        write_test(home, text.format(y=2))
        home.runpytest().stdout.fnmatch_lines(
            ["  cause: the scene was edited: bodies?a?.position was ?0.0, 1.0? and is ?0.0, 2.0?"]
        )

    def test_the_page_shows_what_the_test_did(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, PUSH.format(push=1.0) + "\n\ndef test_rests(replay_check):\n    replay_check('crate', 5)\n")
        home.runpytest("--replay-update").assert_outcomes(passed=2)
        write_test(
            home,
            PUSH.format(push=1.5)
            + "\n\ndef test_rests(replay_check):\n    replay_check('crate', 5)\n"
            + "\n\ndef test_new(replay_check):\n    replay_check('crate', 6)\n",
        )
        done = home.runpytest("--replay-report", "page.html")
        done.assert_outcomes(passed=1, failed=2)
        page = (home.path / "page.html").read_text(encoding="utf-8")
        for name, word in (("falls", "stale"), ("rests", "passed"), ("new", "missing")):
            assert re.search(rf">test_crate.test_{name}.replay.json<.*?>{word}<", page, re.DOTALL), name
        assert page.count('class="player"') == 1
        assert "command 1 (step 5, ApplyImpulse on crate): impulse was" in page
        assert "the run with the commands of test_crate.test_falls.replay.json as it stands" in page
        assert "accept it:  pytest --replay-update=changed 'test_crate.py::test_falls'" in page
        assert "sandbox replay --update" not in page

    def test_other_steps_are_found(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, "def test_it(replay_check): replay_check('crate', 30)")
        home.runpytest("--replay-update")
        write_test(home, "def test_it(replay_check): replay_check('crate', 25)")
        home.runpytest().stdout.fnmatch_lines(["*the test takes 25 steps, not 30*"])

    def test_what_a_test_did_to_a_recorder(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        text = (
            "import sandbox\n"
            "def test_it(world, replay_check):\n"
            "    recorder = sandbox.Recorder(world('crate'))\n"
            "    recorder.step(7)\n"
            "    replay_check(recorder)\n"
            "    recorder.step(3)\n"
            "    replay_check(recorder, name='later')\n"
        )
        write_test(home, text)
        home.runpytest("--replay-update").assert_outcomes(passed=1)
        home.runpytest().assert_outcomes(passed=1)
        names = sorted(path.name for path in home.path.glob("*.replay.json"))
        assert names == ["test_crate.test_it.later.replay.json", "test_crate.test_it.replay.json"]

    def test_two_of_one_name_are_refused(self, home: pytest.Pytester, put: Callable) -> None:
        put("crate.scene.json")
        write_test(home, "def test_it(replay_check):\n    replay_check('crate', 5)\n    replay_check('crate', 6)\n")
        home.runpytest("--replay-update").stdout.fnmatch_lines(["*needs another name=*"])


class TestGuide:
    def test_the_tests_that_the_guide_shows_pass(self, home: pytest.Pytester, put: Callable) -> None:
        put("scenes/yard.scene.json")
        text = GUIDE.read_text(encoding="utf-8")
        (code,) = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        (home.path / "test_yard.py").write_text(code, encoding="utf-8")
        home.runpytest("--replay-update").assert_outcomes(passed=2)
        home.runpytest().assert_outcomes(passed=2)
        (written,) = home.path.glob("*.replay.json")
        assert f"`{written.name}`" in text
