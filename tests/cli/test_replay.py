"""`sandbox record`, `sandbox replay` and `sandbox diff`: words, exit codes, and what they write."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from sandbox.cli import pool
from sandbox.errors import SandboxError
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import ReplaySettings, examine
from tests.cli.conftest import CRATE, GROUND

HOLDS = {"at": 20, "rests": "crate"}
PUSH = {"body": "crate", "impulse": [0.3, 1.1], "angular_impulse": 0.0}
COMMANDS = [[2, "ApplyImpulse", PUSH], [9, "SetGravity", {"gravity": [0.0, -5.0]}]]


@pytest.fixture(autouse=True)
def _quiet(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("CI", "GITHUB_ACTIONS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def golden(cli: Callable, write_scene: Callable, tmp_path: Path) -> Path:
    """The recording of a scene beside it."""
    scene = write_scene("a.scene.json", HOLDS)
    assert cli("record", scene, "-o", tmp_path / "a.replay.json").code == 0
    return tmp_path / "a.replay.json"


class Deadly(ReplaySettings):
    """Ends the process that unpacks it."""

    def __reduce__(self) -> Any:
        return os._exit, (3,)


def words(out: str) -> dict[str, str]:
    return dict(re.findall(r"(\S+)\.replay\.json +\S+ +\S+  (\w+)", out))


class TestRecord:
    def test_it_writes_what_replay_runs_again(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        (tmp_path / "push.json").write_text(json.dumps(COMMANDS))
        done = cli(
            "record", write_scene("a.scene.json"), "-o", "b.replay.json", "--steps", 33, "--commands", "push.json"
        )
        assert done.code == 0
        assert re.fullmatch(r"b\.replay\.json: 33 steps, 2 commands, digest [0-9a-f]{16}\n", done.out)
        assert json.loads((tmp_path / "b.replay.json").read_text())["commands"] == COMMANDS
        assert cli("replay", "b.replay.json").code == 0

    def test_the_commands_of_another_recording(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        (tmp_path / "push.json").write_text(json.dumps(COMMANDS))
        scene = write_scene("a.scene.json")
        cli("record", scene, "-o", "a.replay.json", "--commands", "push.json")
        assert cli("record", scene, "-o", "b.replay.json", "--commands", "a.replay.json").code == 0
        assert (tmp_path / "a.replay.json").read_text() == (tmp_path / "b.replay.json").read_text()

    @pytest.mark.parametrize(
        ("text", "place", "words"),
        [
            ("[[1, 2]]", "1:2", "a command is [step"),
            ('[\n [1, "Jump", {}]]', "2:6", 'there is no command "Jump"'),
            ('[[1, "SetGravitee", {"gravity": [0, 1]}]]', "1:6", 'did you mean "SetGravity"'),
            ('[[1, "SetGravity", {"gravity": [0, "x"]}]]', "1:36", "must be a number"),
            ('[[1, "SetGravity", {"gravity": [0, 1], "speed": 2}]]', "1:40", 'unknown field "speed"'),
            ('[[1, "SetGravity", {}]]', "1:20", '"gravity" is missing'),
            ('[[-1, "SetGravity", {"gravity": [0, 1]}]]', "1:3", "whole number from 0"),
            ('[[9, "SetGravity", {"gravity": [0, 1]}],[8, "EndDrag", {"body": "a"}]]', "1:42", "8 comes after 9"),
            ("{}", "1:1", "commands are a list"),
            ("[[1,", "1:5", "ends too early"),
        ],
    )  # fmt: skip
    def test_bad_commands_are_told_with_their_place(
        self, cli: Callable, write_scene: Callable, tmp_path: Path, text: str, place: str, words: str
    ) -> None:
        (tmp_path / "bad.json").write_text(text)
        done = cli("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "bad.json")
        assert done.code == 2
        assert f"bad.json:{place}: " in done.err
        assert words in done.err
        assert not (tmp_path / "a.replay.json").exists()

    def test_a_command_that_the_world_refuses(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        (tmp_path / "bad.json").write_text('[[3, "EndDrag", {"body": "crate"}]]')
        done = cli("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "bad.json")
        assert done.code == 2
        assert "bad.json:1:2: EndDrag after step 3 (0.050 s) was refused: " in done.err
        assert "not being dragged" in done.err

    def test_a_refused_command_of_a_recording_has_its_place_in_it(self, cli: Callable, write_scene: Callable) -> None:
        """Whatever else reads the recording, which the world refuses to go along with, tells it in the same words."""
        Path("push.json").write_text(json.dumps(COMMANDS))
        cli("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "push.json")
        data = json.loads(Path("a.replay.json").read_text())
        data["commands"] = [[3, "ApplyImpulse", {"body": "nobody", "impulse": [1, 2]}]]
        Path("a.replay.json").write_text(json.dumps(data, indent=1))
        line = Path("a.replay.json").read_text().partition('"commands"')[0].count("\n") + 2
        told = f"a.replay.json:{line}:3: ApplyImpulse after step 3 (0.050 s) was refused: no body 'nobody'"
        for arguments in (
            ("record", "a.scene.json", "-o", "b.replay.json", "--commands", "a.replay.json"),
            ("render", "a.replay.json", "-o", "b.png", "--step", 9, "--size", "64x64"),
            ("replay", "a.replay.json", "--update=all"),
        ):
            done = cli(*arguments)
            assert (done.code, told in done.err) == (2, True), done.err
        done = cli("render", "a.replay.json", "-o", "b.html")
        assert (done.code, "the run ended after step 3: commands[0]: ApplyImpulse" in done.err) == (2, True)
        assert not [name for name in os.listdir() if name.startswith("b.")]

    def test_a_command_after_the_end_is_told_with_its_line(self, cli: Callable, write_scene: Callable) -> None:
        late = '[[5, "SetGravity", {"gravity": [0, 0]}],\n [21, "SetGravity", {"gravity": [0, 1]}]]'
        Path("late.json").write_text(late)
        arguments = ("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "late.json")
        done = cli(*arguments)
        assert done.code == 2
        assert "late.json:2:3: the steps of commands rise from 0 up to 20, and 21 comes after 5" in done.err
        assert cli(*arguments, "--steps", 21).code == 0

    def test_another_ending_is_refused(self, cli: Callable, write_scene: Callable) -> None:
        done = cli("record", write_scene("a.scene.json"), "-o", "a.json")
        assert done.code == 2
        assert "named NAME.replay.json" in done.err

    def test_a_folder_that_is_not_there(self, cli: Callable, write_scene: Callable) -> None:
        done = cli("record", write_scene("a.scene.json"), "-o", "nowhere/a.replay.json")
        assert done.code == 2
        assert "nowhere does not exist" in done.err


class TestWords:
    def test_passed(self, cli: Callable, golden: Path, tmp_path: Path) -> None:
        done = cli("replay", tmp_path)
        assert (done.code, words(done.out), done.err) == (0, {f"{tmp_path}/a": "passed"}, "")
        assert "1 replay: 1 passed; 20 steps" in done.out

    def test_a_scene_stands_for_its_recording(self, cli: Callable, golden: Path) -> None:
        assert cli("replay", "a.scene.json").code == 0

    def test_a_scene_of_the_package_is_found_by_name(self, cli: Callable) -> None:
        done = cli("replay", "pyramid-10")
        assert done.code in (0, 1)
        assert "stacks/pyramid-10.replay.json" in done.out

    def test_diverged(self, cli: Callable, golden: Path, tmp_path: Path) -> None:
        lines = golden.read_text().splitlines()
        first = lines.index('  "digests": [') + 1
        old = lines[first + 6].strip(' ",')
        groups = old.split()
        groups[2] = f"{int(groups[2], 16) ^ 1:04x}"
        golden.write_text("\n".join(lines).replace(old, " ".join(groups), 1) + "\n")
        done = cli("replay", golden)
        assert done.code == 1
        step = [line.strip(' ",') for line in lines[first:]].index(old) + 1
        expected, got = groups[2], old.split()[2]
        assert f"step {step} ({step / 60:.3f} s): impulses: expected {expected}, got {got}" in done.out
        assert f"sandbox replay --update {golden}" in done.out

    def test_stale_names_what_was_edited_and_runs_nevertheless(
        self, cli: Callable, golden: Path, write_scene: Callable
    ) -> None:
        write_scene("a.scene.json", HOLDS, bodies=[GROUND, {**CRATE, "position": [0, 0.75]}])
        done = cli("replay", golden)
        assert (done.code, words(done.out)) == (1, {str(golden).removesuffix(".replay.json"): "stale"})
        assert "since it was recorded, body crate was edited" in done.out
        assert "step 1 (0.017 s): pairs: " in done.out or "step 1 (0.017 s): manifolds: " in done.out
        assert "ended elsewhere" in done.out or "all steps" not in done.out

    def test_stale_without_a_consequence(self, cli: Callable, golden: Path, write_scene: Callable) -> None:
        write_scene("a.scene.json", HOLDS, settings={"steps": 20, "push_out_speed": 2.5})
        done = cli("replay", golden)
        assert done.code == 1
        assert "settings, gravity or regions were edited" in done.out

    def test_missing_only_where_something_is_expected(
        self, cli: Callable, write_scene: Callable, tmp_path: Path
    ) -> None:
        write_scene("quiet.scene.json")
        assert cli("replay", tmp_path).code == 5
        write_scene("loud.scene.json", HOLDS)
        done = cli("replay", tmp_path)
        assert (done.code, list(words(done.out).values())) == (1, ["missing"])
        assert "--update=missing" in done.out

    def test_scenes_of_an_environment_are_not_the_users(
        self, cli: Callable, write_scene: Callable, golden: Path, tmp_path: Path
    ) -> None:
        for name in ("venv/lib/b.scene.json", ".tox/b.scene.json", "node_modules/b.scene.json", "below/c.scene.json"):
            write_scene(name, HOLDS)
        (tmp_path / "venv/pyvenv.cfg").write_text("")
        assert words(cli("replay", ".").out) == {"a": "passed", "below/c": "missing"}
        assert cli("check", ".").out.count(".scene.json") == 2
        assert list(words(cli("replay", "venv").out)) == ["venv/lib/b"]

    def test_orphaned(self, cli: Callable, golden: Path, tmp_path: Path) -> None:
        (tmp_path / "a.scene.json").unlink()
        done = cli("replay", tmp_path)
        assert (done.code, list(words(done.out).values())) == (1, ["orphaned"])
        assert golden.exists()
        assert cli("replay", "--prune", tmp_path).code == 0
        assert not golden.exists()

    def test_unusable_does_not_keep_others_from_running(self, cli: Callable, golden: Path, tmp_path: Path) -> None:
        (tmp_path / "b.replay.json").write_text('{"format": 99}')
        done = cli("replay", tmp_path)
        assert done.code == 2
        assert sorted(words(done.out).values()) == ["passed", "unusable"]
        assert "b.replay.json:1:12: the file has format 99" in done.err
        assert "Traceback" not in done.err

    def test_a_command_that_is_refused_now(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        (tmp_path / "push.json").write_text(json.dumps(COMMANDS))
        cli("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "push.json")
        write_scene("a.scene.json", bodies=[GROUND])
        done = cli("replay", "a.replay.json")
        assert done.code == 1
        assert "body crate was taken away" in done.out
        assert "step 1 (0.017 s): pairs: " in done.out
        assert "the run ended after step 2, for a command was refused: commands[0], " in done.out
        assert "no body 'crate' in this world" in done.out
        done = cli("replay", "--update", "a.replay.json")
        assert done.code == 2
        assert "no body 'crate'" in done.err
        assert "after step 2 (0.033 s) was refused" in done.err

    def test_nothing_found_is_exit_5(self, cli: Callable, golden: Path, tmp_path: Path) -> None:
        done = cli("replay", tmp_path, "-k", "nothing-like-this")
        assert (done.code, done.out) == (5, "")
        assert "nothing to replay" in done.err


class TestUpdate:
    @pytest.fixture
    def three(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> dict[str, bytes]:
        """Recordings of one that passes and one that is stale; one is missing."""
        for name in "abc":
            write_scene(f"{name}.scene.json", HOLDS)
        cli("replay", "--update=missing", "a.scene.json", "b.scene.json")
        write_scene("b.scene.json", HOLDS, gravity=[0, -4])
        (tmp_path / "a.replay.json").write_text(
            (tmp_path / "a.replay.json").read_text().replace('"environment": "', '"environment": "Elsewhere, ')
        )
        return {name: (tmp_path / f"{name}.replay.json").read_bytes() for name in "ab"}

    @pytest.mark.parametrize(
        ("option", "code", "changed"),
        [
            ("--update=missing", 1, "c"),
            ("--update=changed", 0, "bc"),
            ("--update", 0, "bc"),
            ("--update=all", 0, "abc"),
            ("--update missing", 1, "c"),
            ("--update all", 0, "abc"),
        ],
    )
    def test_what_is_written(
        self, cli: Callable, three: dict[str, bytes], tmp_path: Path, option: str, code: int, changed: str
    ) -> None:
        assert cli("replay", *option.split(), tmp_path).code == code
        after = {name: (tmp_path / f"{name}.replay.json").read_bytes() for name in "abc"}
        assert "".join(name for name in "abc" if after[name] != three.get(name)) == changed
        assert cli("replay", tmp_path).code == code

    def test_commands_stay(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        (tmp_path / "push.json").write_text(json.dumps(COMMANDS))
        cli("record", write_scene("a.scene.json"), "-o", "a.replay.json", "--commands", "push.json", "--steps", 44)
        write_scene("a.scene.json", gravity=[0, -4])
        assert cli("replay", "--update", "a.replay.json").code == 0
        data = json.loads((tmp_path / "a.replay.json").read_text())
        assert (data["commands"], data["steps"]) == (COMMANDS, 44)

    @pytest.mark.parametrize("option", ["--update", "--update=all", "--prune"])
    def test_nothing_is_written_under_ci(
        self, cli: Callable, three: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, option: str
    ) -> None:
        monkeypatch.setenv("CI", "true")
        done = cli("replay", option, tmp_path)
        assert done.code == 2
        assert "CI is set" in done.err
        assert not (tmp_path / "c.replay.json").exists()

    def test_another_word_is_refused(self, cli: Callable, golden: Path) -> None:
        done = cli("replay", "--update=everything", golden)
        assert done.code == 2
        assert "missing, changed, all" in done.err


class TestHowItRuns:
    @pytest.mark.parametrize("options", [["-j", 2], pytest.param(["--no-jit"], marks=pytest.mark.slow), ["--heavy"]])
    def test_processes_and_no_jit_come_to_the_same(
        self, cli: Callable, write_scene: Callable, tmp_path: Path, options: list[object]
    ) -> None:
        for name in "abc":
            write_scene(f"{name}.scene.json", HOLDS, settings={"steps": 4})
        cli("replay", "--update", tmp_path)
        done = cli("replay", tmp_path, *options)
        assert done.code == 0
        assert [name[-1] for name in words(done.out)] == ["a", "b", "c"]

    def test_tolerance_passes_what_is_near(self, cli: Callable, golden: Path) -> None:
        text = golden.read_text()
        digest = json.loads(text)["digest"]
        golden.write_text(text.replace(digest, "0" * 16))
        assert cli("replay", golden).code == 1
        assert cli("replay", "--tolerance", golden).code == 0

    def test_tolerance_names_the_figure_that_is_not(self, cli: Callable, golden: Path) -> None:
        text = golden.read_text()
        energy = json.loads(text)["checkpoints"][-1]["energy"]
        golden.write_text(text.replace(f'"energy": {energy!r}', f'"energy": {1.1 * energy!r}'))
        done = cli("replay", "--tolerance", golden)
        assert done.code == 1
        assert "step 20 (0.333 s): energy: expected " in done.out

    def test_a_process_that_is_killed_is_told(self, golden: Path) -> None:
        with pytest.raises(SandboxError, match="killed from outside"):
            list(pool.elsewhere(partial(examine, settings=Deadly()), [Case(golden)], 1))

    def test_shards_share_all_files(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        for name in "abcde":
            write_scene(f"{name}.scene.json", HOLDS)
        seen = [name for part in ("1/2", "2/2") for name in words(cli("replay", tmp_path, "--shard", part).out)]
        assert sorted(name[-1] for name in seen) == list("abcde")
        assert cli("replay", tmp_path, "--shard", "3/2").code == 2

    def test_last_failed(
        self, cli: Callable, write_scene: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        from sandbox._kernel_cache import cache_folder

        cache_folder()  # is asked for once, before the variable moves it
        monkeypatch.setenv("SANDBOX_CACHE_DIR", str(tmp_path / "cache"))
        for name in "ab":
            write_scene(f"{name}.scene.json", HOLDS)
        cli("replay", "--update", tmp_path)
        assert len(words(cli("replay", tmp_path, "--last-failed").out)) == 2
        write_scene("b.scene.json", HOLDS, gravity=[0, -4])
        cli("replay", tmp_path)
        assert list(words(cli("replay", tmp_path, "--last-failed").out).values()) == ["stale"]
        write_scene("b.scene.json", HOLDS)
        assert list(words(cli("replay", tmp_path, "--last-failed").out).values()) == ["passed"]
        assert len(words(cli("replay", tmp_path, "--last-failed").out)) == 2


class TestForMachines:
    @pytest.fixture
    def stale(self, golden: Path, write_scene: Callable) -> Path:
        write_scene("a.scene.json", HOLDS, bodies=[GROUND, {**CRATE, "position": [0, 2]}])
        return golden

    def test_json(self, cli: Callable, stale: Path) -> None:
        done = cli("replay", "--json", stale)
        data = json.loads(done.out)
        assert (done.code, data["exit_code"]) == (1, 1)
        (entry,) = data["replays"]
        assert (entry["verdict"], entry["steps"], entry["edits"]) == ("stale", 20, ["body crate was edited"])
        assert entry["divergence"]["step"] == 1
        assert entry["drifts"][0]["body"] == "crate"

    def test_junit(self, cli: Callable, stale: Path, tmp_path: Path) -> None:
        (tmp_path / "b.replay.json").write_text("{")
        cli("replay", "--junit", "junit.xml", tmp_path)
        suite = ElementTree.parse(tmp_path / "junit.xml").getroot()[0]
        assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("2", "1", "1")
        failure = suite[0][0]
        assert (failure.tag, failure.get("type")) == ("failure", "stale")
        assert "step 1 (0.017 s)" in (failure.text or "")

    def test_annotations_only_on_github_and_at_most_ten(
        self, cli: Callable, stale: Path, write_scene: Callable, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        assert "::error" not in cli("replay", stale).out
        monkeypatch.setenv("GITHUB_ACTIONS", "true")
        done = cli("replay", "a.replay.json")
        (note,) = [line for line in done.out.splitlines() if line.startswith("::error")]
        line = int(re.search(r"file=a.replay.json,line=(\d+),title=replay stale::", note)[1])  # type: ignore[index]
        assert stale.read_text().splitlines()[line - 2].strip() == '"digests": ['
        for k in range(12):
            write_scene(f"m{k}.scene.json", HOLDS)
        assert sum(line.startswith("::error") for line in cli("replay", tmp_path).out.splitlines()) == 10
        assert json.loads(cli("replay", tmp_path, "--json").out)

    def test_a_broken_scene_is_what_is_told_of(
        self, cli: Callable, golden: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        """Also where its recording is not there, and from the root of the repository."""
        monkeypatch.setenv("GITHUB_ACTIONS", "true")
        monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path.parent))
        (tmp_path / "b.scene.json").write_text('{"bodies": [')
        done = cli("replay", "b.scene.json", "--junit", "junit.xml")
        (note,) = [line for line in done.out.splitlines() if line.startswith("::error")]
        told = 'the file ends too early: the "[" at 1:12 is not closed by a "]"'
        assert note == f"::error file={tmp_path.name}/b.scene.json,line=1,title=replay unusable::{told}"
        (entry,) = json.loads(cli("replay", "b.scene.json", "--json").out)["replays"]
        assert entry["reasons"] == [f"b.scene.json:1:13: {told}"]
        assert entry["problems"][0]["source"] == "b.scene.json"
        error = ElementTree.parse(tmp_path / "junit.xml").getroot()[0][0][0]
        assert f"b.scene.json:1:13: {told}" in (error.text or "")

    def test_ends_are_told_by_what_they_are_sorted_by(
        self, cli: Callable, golden: Path, write_scene: Callable, tmp_path: Path
    ) -> None:
        scene = json.loads((tmp_path / "a.scene.json").read_text())
        crate = next(body for body in scene["bodies"] if body["id"] == "crate")

        def told(**changes: Any) -> str:
            others = [body for body in scene["bodies"] if body is not crate]
            (tmp_path / "a.scene.json").write_text(json.dumps({**scene, "bodies": [*others, {**crate, **changes}]}))
            return cli("replay", golden).out

        assert re.search(r"ended elsewhere: crate by [\d.e-]+ m and [\d.]+ degrees", told(angle=90))
        scene["expect"] = []
        assert "ended elsewhere: crate, which is gone, box, which is new\n" in told(id="box", position=[3, 9])


class TestDiff:
    def test_no_difference(self, cli: Callable, golden: Path) -> None:
        done = cli("diff", golden, "a.scene.json")
        assert (done.code, done.out) == (0, "no difference in 20 steps\n")

    def test_the_first_number_that_differs(self, cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
        scene = write_scene("a.scene.json")
        for name, push in (("a", 1.1), ("b", 1.1000000000000003)):
            commands = [[7, "ApplyImpulse", {"body": "crate", "impulse": [0.3, push]}]]
            (tmp_path / "push.json").write_text(json.dumps(commands))
            cli("record", scene, "-o", f"{name}.replay.json", "--commands", "push.json")
        done = cli("diff", "a.replay.json", "b.replay.json")
        assert done.code == 1
        assert "step 8 (0.133 s): " in done.out
        assert re.search(r"first: \w+ .*crate: \w+ expected \S+.*ulps? off", done.out)
        found = json.loads(cli("diff", "--json", "a.replay.json", "b.replay.json").out)["divergence"]
        assert (found["step"], found["detail"]["body"]) == (8, "crate")
        assert found["detail"]["ulps"] > 0

    def test_an_edited_scene_against_an_embedded_one(self, cli: Callable, write_scene: Callable) -> None:
        scene = write_scene("a.scene.json")
        cli("record", scene, "-o", "a.replay.json", "--embed")
        crate = {**CRATE, "shapes": [{"box": [1, 1], "friction": 0.4}]}
        write_scene("a.scene.json", bodies=[GROUND, crate])
        done = cli("diff", "a.replay.json", scene)
        assert done.code == 1
        assert "first: shape crate: friction expected 0.5, got 0.4" in done.out

    def test_a_file_that_is_not_there(self, cli: Callable, golden: Path) -> None:
        assert cli("diff", golden, "nowhere.replay.json").code == 2
