"""`sandbox check`: what it finds, what it prints, and the exit code it ends with."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from sandbox import SceneError, load_scene
from sandbox.cli.check import find_files
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, shipped_scenes

HOLDS = {"at": 20, "rests": "crate"}
FAILS = {"at": 10, "above": 3, "of": "crate"}


def test_all_hold(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    write_scene("a.scene.json", HOLDS)
    write_scene("deep/down/b.scene.json", HOLDS)
    done = cli("check", tmp_path)
    assert done.code == 0
    head, first, second, summary = done.out.splitlines()
    assert head.split() == ["scene", "steps", "ms/step", "digest", "verdict"]
    assert re.fullmatch(r"\S*/a\.scene\.json +20 +\d+\.\d{3}  [0-9a-f]{16}  holds", first)
    assert "deep/down/b.scene.json" in second
    assert re.fullmatch(r"2 scenes: 2 hold; 40 steps in \d+\.\d s", summary)
    assert first.index("holds") == second.index("holds") == head.index("verdict")


def test_a_failed_expectation_is_named_with_line_step_expected_and_got(cli: Callable, tmp_path: Path) -> None:
    path = tmp_path / "fails.scene.json"
    path.write_text(
        '{"bodies": [{"id": "b", "shapes": [{"circle": 1}], "position": [0, 5]}],\n "gravity": [0, 0],\n'
        ' "expect": [{"at": 0, "rests": "b"},\n  {"at": 7,  "below": 4.50,\n   "of": "b"}]}'
    )
    done = cli("check", path)
    assert done.code == 1
    assert f'{path}:4: {{"at": 7, "below": 4.50, "of": "b"}}\n' in done.out
    assert "at step 7: expected y at most 4.5 m; got: b is at y = 5 m" in done.out
    assert "1 scene: 0 hold, 1 failed" in done.out


def test_github_shows_each_mistake_at_its_line(
    cli: Callable, write_scene: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_scene("fails.scene.json", FAILS)
    (tmp_path / "bad.scene.json").write_text('{\n"bodeis": []}')
    assert "::error" not in cli("check", tmp_path).out
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path))
    done = cli("check", tmp_path, "--require-expect")
    notes = [line for line in done.out.splitlines() if line.startswith("::")]
    assert notes[0] == (
        '::error file=bad.scene.json,line=2,title=check unusable::unknown field "bodeis": did you mean "bodies"?'
    )
    assert re.fullmatch(
        r"::error file=fails\.scene\.json,line=\d+,title=check failed::at step 10: .*; got: .*", notes[1]
    )
    assert len(notes) == 2
    assert "::error" in cli("check", tmp_path, "--json").err
    done = cli("lint", tmp_path / "bad.scene.json", write_scene("silent.scene.json"))
    assert "::error file=bad.scene.json,line=2,title=lint::unknown field" in done.out
    assert "::warning file=silent.scene.json,line=1,title=lint no-expect::the scene expects nothing" in done.out


def test_a_file_that_cannot_be_loaded_does_not_keep_others_from_running(
    cli: Callable, write_scene: Callable, tmp_path: Path
) -> None:
    write_scene("a.scene.json", HOLDS)
    write_scene("b.scene.json", FAILS)
    write_scene("bad.scene.json", bodeis=[])
    write_scene("z.scene.json", HOLDS)
    done = cli("check", tmp_path)
    assert done.code == 2
    assert "4 scenes: 2 hold, 1 failed, 1 could not be used" in done.out
    assert re.search(r"bad\.scene\.json +- +- +- +unusable", done.out)
    assert 'unknown field "bodeis"' in done.err
    assert "did you mean" in done.err


def test_an_expectation_failed_alone_is_exit_1(cli: Callable, write_scene: Callable) -> None:
    assert cli("check", write_scene("a.scene.json", HOLDS), write_scene("b.scene.json", FAILS)).code == 1


def test_a_missing_file_is_unusable_and_the_rest_runs(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    done = cli("check", tmp_path / "nowhere.scene.json", write_scene("a.scene.json", HOLDS))
    assert done.code == 2
    assert "1 hold, 1 could not be used" in done.out
    assert "nowhere.scene.json" in done.err


def test_nothing_found_is_exit_5_with_a_message(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    done = cli("check", tmp_path)
    assert (done.code, done.out) == (5, "")
    assert f"nothing to check: no *.scene.json in {tmp_path} or below" in done.err
    path = write_scene("a.scene.json")
    done = cli("check", path, "-k", "pyramid")
    assert (done.code, done.out) == (5, "")
    assert "no path contains 'pyramid'" in done.err


def test_other_json_files_are_run_only_when_named(write_scene: Callable, tmp_path: Path) -> None:
    scene, other = write_scene("a.scene.json"), write_scene("other.json")
    assert find_files([tmp_path]) == [scene]
    assert find_files([other]) == [other]


def test_each_file_runs_once_and_patterns_choose(write_scene: Callable, tmp_path: Path) -> None:
    a, b = write_scene("a.scene.json"), write_scene("b/b.scene.json")
    assert find_files([b, tmp_path, a]) == [b, a]
    assert find_files([tmp_path], "b/") == [b]
    with pytest.raises(SandboxError, match="nothing to check"):
        find_files([tmp_path], "c/")


def test_steps_replaces_the_scenes_own_number(cli: Callable, write_scene: Callable) -> None:
    done = cli("check", "--json", "--steps", 7, write_scene("a.scene.json"))
    assert json.loads(done.out)["scenes"][0]["steps"] == 7


def test_a_run_is_as_long_as_its_expectations_need(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", {"within": [1, 30], "rests": "crate"})
    assert json.loads(cli("check", "--json", path).out)["scenes"][0]["steps"] == 30


def test_a_shorter_run_leaves_open_what_is_expected_later(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", {"at": 30, "above": 9, "of": "crate"}, {"always": True, "below": 9})
    done = cli("check", "--json", "--steps", 5, path)
    (entry,) = json.loads(done.out)["scenes"]
    assert (done.code, entry["steps"], entry["verdict"], entry["unreached"]) == (0, 5, "holds", 1)
    assert [each["index"] for each in entry["expectations"]] == [1]
    assert "holds (1 not reached)" in cli("check", "--steps", 5, path).out
    assert cli("check", path).code == 1


def test_a_shorter_run_judges_what_it_reaches(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", {"at": 5, "above": 9, "of": "crate"}, {"at": 30, "rests": "crate"})
    assert cli("check", "--steps", 5, path).code == 1


@pytest.mark.parametrize("command", ["check", "expand", "solver", "compare"])
def test_a_recording_is_called_one(cli: Callable, write_scene: Callable, tmp_path: Path, command: str) -> None:
    recording = tmp_path / "a.replay.json"
    cli("record", write_scene("a.scene.json"), "-o", recording)
    done = cli(command, recording)
    said = "this is a recording, not a scene: sandbox replay runs it again, sandbox run and sandbox render show it"
    assert (done.code, done.err) == (2, f"{recording}: {said}\n")


def test_messages_of_documents_do_not_end_in_a_colon(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    write_scene("crates.scene.json", gravitee=[0, 1])
    for path in (tmp_path / "crates.scene.json", tmp_path / "crate.scene.json"):
        (entry,) = json.loads(cli("check", "--json", path).out)["scenes"]
        (problem,) = entry["problems"]
        assert problem["hint"].startswith("did you mean")
        assert not problem["message"].endswith(":")
        assert f"{problem['message']}: {problem['hint']}" in cli("check", path).err


def test_what_is_called_like_a_shipped_scene_says_where_that_is() -> None:
    with pytest.raises(SceneError, match=r"a scene of that name comes with the package, as .*/pyramid-10\.scene\.json"):
        load_scene("pyramid-10")


def test_json_is_one_document_with_the_documented_keys(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    write_scene("a.scene.json", HOLDS, FAILS)
    write_scene("bad.scene.json", bodies=3)
    done = cli("check", "--json", tmp_path)
    document = json.loads(done.out)
    assert done.code == document["exit_code"] == 2
    assert document["format"] == 1
    ran, bad = document["scenes"]
    assert ran["verdict"] == "failed"
    assert re.fullmatch("[0-9a-f]{16}", ran["digest"])
    assert {"path", "title", "steps", "ms_per_step", "frozen"} < set(ran)
    holds, fails = ran["expectations"]
    assert holds["holds"] is True
    assert fails == {
        "text": '{ "at": 10, "above": 3, "of": "crate" }',
        "line": fails["line"],
        "index": 1,
        "holds": False,
        "step": 10,
        "expected": "y at least 3 m",
        "got": fails["got"],
    }
    assert re.fullmatch(r"crate is at y = 0\.\d+ m", fails["got"])
    assert Path(ran["path"]).read_text().splitlines()[fails["line"]].strip() == '"at": 10,'
    assert bad["verdict"] == "unusable"
    assert bad["problems"][0]["pointer"] == "/bodies"
    assert bad["problems"][0]["line"] > 0


def test_the_same_scene_gives_the_same_digest(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", HOLDS)
    digests = {json.loads(cli("check", "--json", path).out)["scenes"][0]["digest"] for _ in range(3)}
    assert len(digests) == 1


def test_a_frozen_body_fails_the_scene_and_is_named(cli: Callable, write_scene: Callable) -> None:
    runaway = {
        "id": "runaway",
        "shapes": [{"circle": 1}],
        "position": [999_999_990, 0],
        "velocity": [900_000, 0],
    }
    done = cli("check", write_scene("a.scene.json", bodies=[runaway]))
    assert done.code == 1
    assert re.search(r"runaway was frozen at step \d+: its numbers went bad", done.out)


def test_a_scene_that_expects_nothing_says_so(cli: Callable, write_scene: Callable) -> None:
    done = cli("check", write_scene("a.scene.json"))
    assert done.code == 0
    assert "holds (expects nothing)" in done.out


def test_a_shipped_scene_is_found_by_name(cli: Callable) -> None:
    scene = shipped_scenes()[0]
    done = cli("check", scene.name.removesuffix(SCENE_SUFFIX), "--steps", 1)
    assert done.code in (0, 1)
    assert scene.as_posix() in done.out


def test_logs_have_no_progress_bar_and_no_colours(cli: Callable, write_scene: Callable) -> None:
    done = cli("check", write_scene("a.scene.json", HOLDS))
    assert "\x1b" not in done.out + done.err
    assert "steps" not in done.err


def test_workers_make_no_difference(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json")
    digests = [
        json.loads(cli("check", path, "--workers", count, "--json").out)["scenes"][0]["digest"] for count in (1, 2)
    ]
    assert digests[0] == digests[1]
    assert cli("check", path, "--workers", 0).code == 2


def test_junit_tells_what_failed_and_what_could_not_be_used(
    cli: Callable, write_scene: Callable, tmp_path: Path
) -> None:
    write_scene("a.scene.json", HOLDS)
    write_scene("b.scene.json", FAILS)
    write_scene("c.scene.json", bodeis=[])
    assert cli("check", tmp_path, "--junit", tmp_path / "out.xml").code == 2
    suite = ElementTree.parse(tmp_path / "out.xml").getroot()[0]
    assert suite.attrib.items() >= {"name": "sandbox check", "tests": "3", "failures": "1", "errors": "1"}.items()
    assert [case.get("name") for case in suite] == ["a.scene.json", "b.scene.json", "c.scene.json"]
    good, failed, unusable = suite
    assert len(good) == 0
    assert "expected y at least 3 m" in (failed[0].text or "")
    assert "b.scene.json:" in failed[0].attrib["message"]
    assert 'unknown field "bodeis"' in unusable[0].attrib["message"]


def test_a_scene_that_expects_nothing_fails_if_asked_for(cli: Callable, write_scene: Callable) -> None:
    idle, busy = write_scene("a.scene.json"), write_scene("b.scene.json", HOLDS)
    assert cli("check", idle, busy).code == 0
    done = cli("check", idle, busy, "--require-expect")
    assert done.code == 1
    assert re.search(r"a\.scene\.json .* failed\n  it expects nothing: say under", done.out)
    assert "2 scenes: 1 hold, 1 failed" in done.out


@pytest.mark.slow
def test_processes_give_the_same_in_the_same_order(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    write_scene("b.scene.json", HOLDS, settings={"steps": 200})
    write_scene("c.scene.json", FAILS)
    write_scene("d.scene.json", bodeis=[])

    def told(jobs: int) -> list[dict]:
        done = cli("check", tmp_path, "--json", "-j", jobs)
        assert done.code == 2
        assert 'unknown field "bodeis"' in done.err
        entries = json.loads(done.out)["scenes"]
        return [{key: value for key, value in entry.items() if key != "ms_per_step"} for entry in entries]

    assert told(2) == told(1)
