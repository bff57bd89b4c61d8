"""The guides tell the truth: links lead somewhere, commands and options exist, programs run."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.cli import app
from sandbox.engine.arithmetic_version import NOTES
from sandbox.engine.commands.registry import COMMAND_CLASSES
from tests.cli.conftest import cli  # noqa: F401

ROOT = Path(sandbox.__file__).parents[1]
README = ROOT / "README.md"
GUIDES = sorted(
    [README, ROOT / ".github" / "CONTRIBUTING.md", *ROOT.glob("sandbox/**/*.md"), *ROOT.glob("scenes/**/*.md")]
)
NAMES = [path.relative_to(ROOT).as_posix() for path in GUIDES]


def text_of(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def blocks(path: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", text_of(path), re.MULTILINE | re.DOTALL)


def anchors(path: Path) -> set[str]:
    """The ids that GitHub gives to headings."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", text_of(path), flags=re.M | re.S), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading).strip().lower().replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("path", GUIDES, ids=NAMES)
def test_links_lead_somewhere(path: Path) -> None:
    dead = []
    for target in re.findall(r"\]\(([^)\s]+)\)", text_of(path)):
        if target.startswith("https://"):
            continue
        file, _, anchor = target.partition("#")
        there = path.parent / file if file else path
        if not there.exists() or (anchor and anchor not in anchors(there)):
            dead.append(target)
    assert dead == []


def said(line: str) -> list[str]:
    """The words of a `sandbox` command in a line of a shell, from its name on; none if there is none."""
    words = shlex.split(line, comments=True)
    at = next((k for k, word in enumerate(words) if word == "sandbox" or word.endswith("/sandbox")), len(words))
    return words[at + 1 :]


COMMANDS = [(name, line) for path, name in zip(GUIDES, NAMES, strict=True) for block in blocks(path, "sh")
            for line in block.splitlines() if said(line)]  # fmt: skip


@pytest.mark.parametrize(("name", "line"), COMMANDS, ids=[f"{name}: {line[:50]}" for name, line in COMMANDS])
def test_commands_have_the_options_that_guides_name(name: str, line: str) -> None:
    check_options(*said(line))


def check_options(command: str, *words: str) -> None:
    """That `sandbox COMMAND` exists and has the options among the words."""
    assert command in app.COMMANDS
    options = {option for parameter in app.build().get_command(None, command).params for option in parameter.opts}
    assert [word for word in words if re.match(r"--?[a-zA-Z]", word) and word.partition("=")[0] not in options] == []


def test_the_table_of_commands_has_them_all() -> None:
    rows = re.findall(r"^\| (`sandbox .*?`) \|", text_of(README), re.MULTILINE)
    named = [name for row in rows for name in re.findall(r"`(?:sandbox )?(\w+)[^`]*`", row)]
    assert sorted(named) == sorted(app.COMMANDS)


def test_the_readme_stays_short() -> None:
    assert len(text_of(README).splitlines()) <= 150


@pytest.fixture
def crate(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the README's first scene, to work in."""
    (scene,) = blocks(README, "json")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "crate.scene.json").write_text(scene, encoding="utf-8")
    return tmp_path


def test_the_first_scene_holds_and_is_recorded_as_told(crate: Path, cli: Callable) -> None:  # noqa: F811
    (block,) = [block for block in blocks(README, "sh") if "sandbox record" in block]
    lines = [said(line) for line in block.splitlines()]
    assert [words[0] for words in lines] == ["run", "check", "record", "replay"]
    assert [cli(*words).code for words in lines[1:]] == [0, 0, 0]


def test_the_first_program_runs(crate: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (code,) = blocks(README, "python")
    exec(code, {})
    before, after = capsys.readouterr().out.splitlines()
    assert before.startswith("5.0 (")
    assert float(after.rpartition("(")[2].partition(",")[0]) > 0.0  # the crate was pushed to the right


def test_the_programs_of_the_python_guide_run_one_after_the_other(
    crate: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known: dict[str, object] = {}
    for code in blocks(ROOT / "sandbox" / "PYTHON.md", "python"):
        exec(code, known)
    printed = capsys.readouterr().out.splitlines()
    assert printed[0].startswith("5.0 (")
    assert re.fullmatch(r"\d+ ground ball [\d.]+ [\d.]+", printed[1])  # the hit
    assert printed[2] == "{} None"  # nothing is played there
    assert printed[3].startswith("ball (0.0, ")  # what the ray met
    assert printed[4].startswith("(Overlap(body='ball'")
    assert len(sandbox.load_scene(crate / "balls.scene.json").bodies) == 3


@pytest.mark.slow
def test_the_game_loop_runs_and_what_is_played_can_be_replayed(tmp_path: Path, cli: Callable) -> None:  # noqa: F811
    (code,) = blocks(ROOT / "sandbox" / "COMING_FROM.md", "python")
    assert len([line for line in code.splitlines() if line]) <= 50
    jump = "pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_SPACE))"
    played = code.replace("True\n", f"True\npygame.time.set_timer(pygame.QUIT, 400, 1)\n{jump}\n", 1)
    environment = {
        **os.environ,
        "SDL_VIDEODRIVER": "dummy",
        "SDL_AUDIODRIVER": "dummy",
        "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    }
    done = subprocess.run(
        [sys.executable, "-c", played], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    recording = sandbox.Recording.load(tmp_path / "ball.replay.json")
    assert recording.steps > 0
    assert "ApplyImpulse" in {type(command).__name__ for _, command in recording.commands}
    assert cli("replay", str(tmp_path / "ball.replay.json")).code == 0


def test_the_notebook_runs(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("MPLBACKEND", "agg")
    cells = json.loads(text_of(ROOT / "sandbox" / "first_steps.ipynb"))["cells"]
    known: dict[str, object] = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            assert (cell["outputs"], cell["execution_count"]) == ([], None)
            exec("".join(cell["source"]), known)
    contacts, hit = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"\d+ contacts; [\d.]+ N s", contacts)
    assert hit.startswith("RayHit(body=")
    assert max(known["speeds"]) > 10.0  # type: ignore[call-overload]


def test_the_python_guide_names_every_command() -> None:
    assert [name for name in COMMAND_CLASSES if f"`{name}`" not in text_of(ROOT / "sandbox" / "PYTHON.md")] == []


def test_the_changelog_has_every_number_of_the_arithmetic() -> None:
    rows = re.findall(r"^\| (\d+) \| (.*) \|$", text_of(ROOT / "sandbox" / "CHANGELOG.md"), re.MULTILINE)
    assert {int(number): note for number, note in rows} == NOTES
