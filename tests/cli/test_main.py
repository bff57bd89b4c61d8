"""The command line as a whole: help, version, laziness, and what a user sees when something goes wrong."""

from __future__ import annotations

import errno
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.cli import app, failures
from sandbox.errors import Problem, SandboxError, SceneError


def run_process(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "sandbox", *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=os.environ | environment)


def test_version_in_a_process_of_its_own() -> None:
    done = run_process("--version")
    assert (done.returncode, done.stdout) == (0, f"sandbox {sandbox.__version__}\n")


def test_help_names_every_command(cli: Callable) -> None:
    done = cli("--help")
    assert done.code == 0
    assert all(name in done.out for name in app.COMMANDS)


def test_check_help_documents_the_exit_codes(cli: Callable) -> None:
    text = " ".join(cli("check", "--help").out.replace("│", " ").split())
    for part in ("code 0: all hold", "code 1: an expectation failed", "code 2: a file could not be used"):
        assert part in text


def test_ctrl_c_while_commands_are_looked_up_is_silent(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(app, "build", interrupted)
    done = cli("list")
    assert (done.code, done.out, done.err) == (130, "", "")


@pytest.mark.parametrize("arguments", [["--help"], ["--version"], ["check", "--help"]])
def test_help_imports_nothing_heavy(arguments: list[str]) -> None:
    program = (
        "import sys\nfrom sandbox.cli import main\n"
        f"try: main({arguments!r})\nexcept SystemExit: pass\n"
        "heavy = {'numba', 'numpy', 'pygame', 'pymunk', 'moderngl', 'imgui_bundle'}\n"
        "print('heavy:', sorted(heavy & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.endswith("heavy: []\n")


def test_a_command_that_is_not_there_is_exit_2_with_the_nearest_name(cli: Callable) -> None:
    done = cli("chekc")
    assert done.code == 2
    assert "'check'" in done.err


@pytest.mark.parametrize(
    "arguments",
    [["check", ""], ["check", "--json", ""], ["replay", "--update", ""], ["compare", "--twin", ""], ["run", ""]],
)
def test_an_empty_argument_is_not_this_folder(arguments: list[str], cli: Callable) -> None:
    """As a shell gives it where a variable is not set."""
    done = cli(*arguments)
    assert done.code == 2
    assert "an argument is empty; is a variable of the shell not set?" in done.out + done.err


@pytest.mark.parametrize("arguments", [
    ["render", "a.json", "-o", ""], ["render", "a.json", "--output="], ["expand", "a.json", "-o", ""],
    ["compare", "a.json", "--save", ""], ["check", "a.json", "--junit="], ["run", "--screenshot", ""],
], ids=" ".join)  # fmt: skip
def test_an_empty_path_of_an_option_is_not_this_folder(arguments: list[str], cli: Callable) -> None:
    done = cli(*arguments)
    assert (done.code, ": the path is empty; is a variable of the shell not set?" in done.err) == (2, True)


@pytest.mark.parametrize("arguments", [
    ["expand", "a.json", "-o", "-"], ["schema", "--output=-"], ["new", "-o", "-"], ["record", "a.json", "-o", "-"],
    ["record", "a.json", "-o", "a.replay.json", "--commands", "-"],
], ids=" ".join)  # fmt: skip
def test_a_dash_is_no_file_of_that_name(
    arguments: list[str], cli: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`expand SCENE -o -` wrote a file that is called `-`, and nothing to stdout."""
    monkeypatch.chdir(tmp_path)
    done = cli(*arguments)
    assert (done.code, " -: this is no path; /dev/stdin and /dev/stdout stand" in done.err) == (2, True)
    assert os.listdir(tmp_path) == []
    assert cli("schema", "-o", "./-").code == 0
    assert os.listdir(tmp_path) == ["-"]


def test_an_option_may_be_empty(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("one.scene.json", bodies=[{"id": "ball", "shapes": [{"circle": 1}]}])
    assert cli("check", "--only", "", path, "--steps", "1").code == 0


def test_a_wrong_option_is_exit_2_on_stderr(cli: Callable) -> None:
    done = cli("check", "--stepz", "3", "x.json")
    assert (done.code, done.out) == (2, "")
    assert "--steps" in done.err
    assert done.err.count("\n") == 1


@pytest.mark.parametrize(("arguments", "words"), [
    (["check", "a.json", "--steps", "nan"], "'nan'"),
    (["check", "a.json", "--steps=1e3"], "'1e3'"),
    (["check", "a.json", "-j", "inf"], "'inf'"),
    (["render", "a.json", "-o", "a.png", "--height", "nan"], "'nan'"),
    (["import", "a.svg", "-o", "b.scene.json", "--tolerance", "inf"], "'inf'"),
    (["chekc"], "'check'"), (["check", "--stepz"], "--steps"),
    (["check"], "sandbox check --help"), (["bisect", "a.json"], "--good"), (["list", "a", "b"], "(b)"),
], ids=lambda value: " ".join(value) if isinstance(value, list) else "")  # fmt: skip
def test_a_command_line_of_no_use_is_one_line_and_a_document(cli: Callable, arguments: list[str], words: str) -> None:
    """As narrow as a terminal may be, nothing is broken into lines; what was given is told."""
    done = cli(*arguments)
    assert (done.code, done.out, done.err.count("\n"), words in done.err) == (2, "", 1, True), done.err
    document = json.loads(cli(*arguments, "--json").out)
    assert document["exit_code"] == 2
    assert words in document["problems"][0]["message"]


def test_no_command_at_all_is_helped(cli: Callable) -> None:
    done = cli()
    assert done.code == 2
    assert "Commands" not in done.err
    assert all(name in done.out for name in app.COMMANDS)


def _explode(error: Exception) -> Callable[[str], object]:
    def load(name: str) -> object:
        raise error

    return load


def test_a_sandbox_error_is_one_message_and_exit_2(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(app, "_load", _explode(SandboxError("no [bold]such[/bold] thing")))
    done = cli("check")
    assert (done.code, done.out, done.err) == (2, "", "sandbox: no [bold]such[/bold] thing\n")


def test_a_full_disk_is_no_bug(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(app, "_load", _explode(OSError(errno.ENOSPC, "No space left on device")))
    done = cli("check")
    assert (done.code, done.err) == (2, "sandbox: the output could not be written: No space left on device\n")


def test_an_unexpected_error_is_a_bug_on_one_line(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(failures.TRACEBACK_VARIABLE, raising=False)
    monkeypatch.setattr(app, "_load", _explode(ZeroDivisionError("division\nby zero")))
    done = cli("check")
    assert done.code == 70
    assert done.err.count("\n") == 1
    assert "this is a bug in sandbox" in done.err
    assert "ZeroDivisionError: division by zero" in done.err
    assert "SANDBOX_TRACEBACK=1" in done.err


def test_the_traceback_can_be_had(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(failures.TRACEBACK_VARIABLE, "1")
    monkeypatch.setattr(app, "_load", _explode(ZeroDivisionError("zero")))
    done = cli("check")
    assert done.code == 70
    assert "Traceback (most recent call last)" in done.err


def test_a_file_that_cannot_be_written_is_the_users_to_mend(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(app, "_load", _explode(PermissionError(13, "Permission denied", "/out.png")))
    done = cli("check")
    assert (done.code, done.err) == (2, "sandbox: /out.png: Permission denied\n")


@pytest.mark.skipif(sys.platform == "win32", reason="nobody can delete a folder there that somebody is in")
@pytest.mark.parametrize("arguments", [["check", "-j", "2"], ["replay", "-j", "2"]])
def test_a_folder_that_has_been_deleted_is_no_bug(
    cli: Callable, write_scene: Callable, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, arguments: list[str]
) -> None:
    """Processes are begun in the current one."""
    scenes = [write_scene("a.scene.json"), write_scene("b.scene.json")]
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    done = cli(*arguments, *scenes)
    assert done.code == 2
    assert done.err.strip().endswith("the current folder has been deleted: change to one that is there, and try again")


def test_scene_mistakes_are_listed_with_place_excerpt_and_mend(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    problems = [
        Problem(
            'unknown field "shpaes"',
            "/bodies/0/shpaes",
            3,
            7,
            'did you mean "shapes"?',
            '  3 | "shpaes"\n    | ^^^^',
        ),
        Problem("too many bodies"),
    ]
    monkeypatch.setattr(app, "_load", _explode(SceneError("a.json", problems)))
    done = cli("check")
    assert done.code == 2
    assert done.err.splitlines() == "\n".join(SceneError("a.json", problems).lines()).splitlines()
    assert done.err.startswith('a.json:3:7: unknown field "shpaes"')


def test_check_runs_in_a_process_of_its_own(write_scene: Callable, tmp_path: Path) -> None:
    path = write_scene("a.scene.json", {"at": 20, "rests": "crate"})
    done = run_process("check", str(path))
    assert done.returncode == 0, done.stderr
    assert "1 scene: 1 hold" in done.stdout


@pytest.mark.skipif(os.name != "posix", reason="a shell closes them")
@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&-", ">&- 2>&- <&-"])
@pytest.mark.parametrize("command", ["check", "expand", "fmt"])
def test_closed_streams_are_no_bug(write_scene: Callable, command: str, closed: str) -> None:
    """Daemons start programs without some."""
    scene = write_scene("a.scene.json")
    call = f'"{sys.executable}" -m sandbox {command} "{scene}" {closed}'
    done = subprocess.run(["sh", "-c", call], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(scene.read_text())["title"] == "a.scene.json"


@pytest.mark.parametrize("name", app.COMMANDS)
def test_help_breaks_no_line_where_its_source_does(name: str) -> None:
    """Sentences of 120 columns were broken there as well as by the terminal, in the middle of a line of 80."""
    words = app.build().get_command(None, name).help
    broken = [line for line in words.split("\n")[1:] if line and not line.startswith("Exit code")]
    assert [line for line in broken if f"\n\n{line}" not in words] == []
    assert words.count("Exit code") == len([line for line in words.split("\n") if line.startswith("Exit code")])


@pytest.mark.parametrize("name", ["", *app.COMMANDS])
def test_help_speaks_no_python(cli: Callable, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """`<bool>`, `<path>` and `<list[Path]>` stood beside options that have a name, or take nothing at all."""
    monkeypatch.setenv("COLUMNS", "200")
    text = cli(*([name] if name else []), "--help").out
    assert re.findall(r"<[^=>][^>]*>|BOOLEAN|INTEGER|FLOAT", text) == []


@pytest.mark.skipif(os.name != "posix", reason="a shell makes the pipe")
@pytest.mark.parametrize("command", ["check", "expand", "events", "check --json", "--help", "--version"])
def test_a_reader_who_goes_is_no_failed_expectation(write_scene: Callable, command: str) -> None:
    """`sandbox check SCENE | head -1` in a script with `pipefail`: 1 would say that the scene does not hold."""
    scene = "" if command.startswith("-") else f'"{write_scene("a.scene.json", {"at": 20, "rests": "crate"})}"'
    reading, writing = os.pipe()
    os.close(reading)
    call = f'"{sys.executable}" -m sandbox {command} {scene}'
    with os.fdopen(writing, "wb") as nobody:
        done = subprocess.run(["sh", "-c", call], stdout=nobody, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (141, "")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="has no /dev/full")
@pytest.mark.parametrize(("arguments", "code"), [(["check", "nix"], 2), (["list", "nix", "nix"], 2), (["nix"], 2)])
def test_a_full_stderr_changes_no_exit_code(arguments: list[str], code: int) -> None:
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-m", "sandbox", *arguments]
        assert subprocess.run(command, stdout=subprocess.DEVNULL, stderr=full).returncode == code


@pytest.mark.parametrize("command", ["check", "lint", "fmt", "replay"])
def test_a_name_that_is_too_long_is_told_and_the_others_run(
    cli: Callable, write_scene: Callable, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, command: str
) -> None:
    monkeypatch.chdir(tmp_path)
    write_scene("a.scene.json", {"at": 20, "rests": "crate"})
    done = cli(command, "x" * 300 + ".scene.json", "a.scene.json")
    assert done.code == 2
    assert "a.scene.json" in done.out or "1 as they were" in done.out or "2 scenes" in done.out
    assert "File name too long" in done.err


NOT_THERE = {
    "render": ("nix.scene.json", "-o", "out.png"), "record": ("nix.scene.json", "-o", "out.replay.json"),
    "expand": ("nix.scene.json",), "export": ("nix.scene.json", "-o", "out.json"), "events": ("nix.scene.json",),
    "sat": ("nix.scene.json", "--bodies", "a", "b"), "solver": ("nix.scene.json",), "diff": ("nix.scene.json",) * 2,
    "sweep": ("nix.scene.json", "--vary", "gravity.1=-9,-8"), "gallery": ("nix", "-o", "out.html"),
    "list": ("--theme", "nix"), "check": (".",), "lint": (".",), "compare": (".",), "replay": (".",),
}  # fmt: skip


@pytest.mark.parametrize("command", NOT_THERE)
def test_json_tells_also_why_there_is_nothing(
    cli: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.chdir(tmp_path)
    has_json = () if command == "expand" else ("--json",)
    done = cli(command, *NOT_THERE[command], *has_json)
    assert done.code in (2, 5)
    assert done.err
    if has_json:
        document = json.loads(done.out)
        assert document["exit_code"] == done.code
        assert any(entry["message"] in done.err for entry in document["problems"])
