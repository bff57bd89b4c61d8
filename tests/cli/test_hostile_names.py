"""Names and titles from outside reach no terminal as they are: no control characters, no lines of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="has no such names")
EVIL = "a\x1b[31m\nsandbox: all is well\x9b2J[red]"
COMMANDS = {
    "check": ["check"], "events": ["events", "--kind", "begin"], "sat": ["sat", "--bodies", "ground", "crate"],
    "solver": ["solver"], "compare": ["compare"], "twin": ["compare", "--twin=simple"],
    "bench": ["bench", "--engines", "sandbox", "--steps", "2"], "replay": ["replay"],
    "update": ["replay", "--update=missing"], "render": ["render", "-o", f"{EVIL}.html"],
    "record": ["record", "-o", f"{EVIL}.replay.json"], "bad record": ["record", "-o", f"{EVIL}.json"],
    "folder": ["record", "-o", f"{EVIL}/a.replay.json"], "png": ["render", "-o", f"{EVIL}.jpg"],
    "import": ["import", "-o", f"{EVIL}.json"], "export": ["export", "-o", f"{EVIL}.py"],
    "report": ["replay", "--report", f"{EVIL}.txt"], "diff": ["diff", "pyramid-10"],
}  # fmt: skip


def is_clean(text: str) -> bool:
    """Lines that can be printed, and none of the name's making."""
    lines = text.split("\n")
    return all(map(str.isprintable, lines)) and not any(line.startswith("sandbox: all is well") for line in lines)


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Everything happens in an empty folder, on GitHub, where there are notes as well."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CI", raising=False)
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    return tmp_path


@pytest.mark.parametrize("broken", [False, True], ids=["fine", "broken"])
@pytest.mark.parametrize("name", COMMANDS)
def test_what_a_file_is_called(cli: Callable, write_scene: Callable, name: str, broken: bool) -> None:
    path = write_scene(f"{EVIL}.scene.json", {"at": 20, "above": 5.0, "of": "crate"})
    if broken:
        path.write_text("x")
    done = cli(*COMMANDS[name], path.name)
    assert done.code in (0, 1, 2)
    assert is_clean(done.out), done.out
    assert is_clean(done.err), done.err


@pytest.mark.parametrize("command", ["check", "replay"])
def test_what_a_folder_is_called(cli: Callable, here: Path, command: str) -> None:
    (here / EVIL).mkdir()
    done = cli(command, EVIL)
    assert done.code in (2, 5)
    assert is_clean(done.err), done.err


def test_what_comes_near_to_a_name(cli: Callable, here: Path) -> None:
    (here / "quirkiest\x1b\n.scene.json").write_text("")
    done = cli("check", "quirkiest.scene.json")
    assert "did you mean" in done.err
    assert is_clean(done.err), done.err


@pytest.mark.slow
def test_bytes_that_are_no_text(write_scene: Callable, here: Path) -> None:
    path = write_scene("a.scene.json")
    os.rename(path, os.fsencode(here) + b"/\xff.scene.json")
    for arguments in (["check", "."], ["check", "--json", "."], ["replay", "--json", "--update=all", "."]):
        done = subprocess.run([sys.executable, "-m", "sandbox", *arguments], capture_output=True)
        assert done.returncode in (0, 5), done.stderr
        if "--json" in arguments and done.stdout:
            json.loads(done.stdout)


def test_what_is_set_that_is_not_there(cli: Callable, write_scene: Callable) -> None:
    done = cli("check", write_scene("a.scene.json"), "--set", f"vars.{EVIL}=1")
    assert done.code == 2
    assert is_clean(done.err), done.err


def test_where_the_cache_is(cli: Callable, here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from sandbox._kernel_cache import cache_folder

    monkeypatch.setenv("SANDBOX_CACHE_DIR", str(here / EVIL))
    cache_folder.cache_clear()
    try:
        done = cli("cache")
    finally:
        cache_folder.cache_clear()
    assert done.code == 0
    assert is_clean(done.out), done.out
