"""A recording that is damaged, hostile or newer, through the command line: one clear error, exit code 2, no more."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sandbox
from tests.cli.conftest import CRATE, GROUND

DEEP = "[" * 100_000


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The text of a recording with its scene inside."""
    path = tmp_path_factory.mktemp("good") / "good.replay.json"
    sandbox.record(sandbox.Scene(bodies=[GROUND, CRATE]), 12).save(path)
    return path.read_text(encoding="utf-8")


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("CI", "GITHUB_ACTIONS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.chdir(tmp_path)


def members(**fields: Any) -> Callable[[str], str]:
    """The recording with other members."""
    return lambda text: json.dumps(json.loads(text) | fields)


def command(*entry: Any) -> Callable[[str], str]:
    return members(commands=[list(entry)])


def leads_to(path: str) -> Callable[[str], str]:
    """The recording with its scene elsewhere."""

    def change(text: str) -> str:
        data = json.loads(text)
        del data["scene"]["content"]
        data["scene"]["path"] = path
        return json.dumps(data)

    return change


FILES: dict[str, tuple[Callable[[str], str | bytes], str]] = {
    "empty": (lambda text: "", "the file is empty"),
    "cut": (lambda text: text[: len(text) // 2], "ends too early"),
    "without its last line": (lambda text: text.rstrip()[:-1], "ends too early"),
    "twice": (lambda text: text + text, "ended before this"),
    "binary": (lambda text: bytes(range(256)), "is no text"),
    "zeroes": (lambda text: b"\0" * 500, "a value is due here"),
    "deep": (lambda text: DEEP, "nested deeper than 32 levels"),
    "deep inside": (lambda text: text.replace('"commands": []', f'"commands": {DEEP}'), "nested deeper"),
    "deep command": (
        lambda text: text.replace(
            '"commands": []', '"commands": [[1, "Spawn", ' + '{"a":' * 40 + "1" + "}" * 40 + "]]"
        ),
        "nested deeper",
    ),
    "newer": (members(format=2, unheard={"of": 1}), "has format 2 and this version of sandbox reads up to 1"),
    "no format": (lambda text: text.replace('"format": 1,', "", 1), 'begins with "format": 1'),
    "a list": (lambda text: "[]", "a recording is an object"),
    "1e9 steps": (members(steps=10**9), "steps must not be above"),
    "1e308 steps": (members(steps=1e308), "steps must be a whole number"),
    "5,000 digits": (lambda text: text.replace('"steps": 12', '"steps": ' + "9" * 5000), "steps must be"),
    "more steps than there are": (members(steps=10**6), "12 fingerprints for 1000000 steps"),
    "a list of steps": (members(steps=[12]), "steps must be a whole number, not a list"),
    "NaN": (members(step_rate=float("nan")), "step_rate must be a finite number"),
    "infinite place": (members(final={"crate": [float("inf"), 0, 0]}), "must be a finite number"),
    "a key twice": (lambda text: text.replace('"steps": 12', '"steps": 12, "steps": 13'), "is given twice"),
    "a command's key twice": (
        lambda text: text.replace(
            '"commands": []', '"commands": [[1, "SetGravity", {"gravity": [0, 1], "gravity": [0, 2]}]]'
        ),
        '"gravity" is given twice',
    ),
    "an unknown command": (command(1, "__import__", {"name": "os"}), 'there is no command "__import__"'),
    "a command of NaN": (command(1, "SetGravity", {"gravity": [float("nan"), 0]}), "must be a finite number"),
    "a command of 400 digits": (command(1, "SetGravity", {"gravity": [10**400, 0]}), "must be a finite number"),
    "a command after the end": (command(10**30, "SetGravity", {"gravity": [0, 1]}), "rise from 0 up to 12"),
    "an absolute path": (leads_to("/etc/passwd.json"), "path must be the way to a .json file"),
    "another kind of file": (leads_to("../../../../etc/passwd"), "path must be the way to a .json file"),
    "an address": (leads_to("https://example.org/a.json"), "path must be the way to a .json file"),
    "a zero in the path": (leads_to("a\0b.json"), "path must be the way to a .json file"),
    "itself": (leads_to("bad.replay.json"), "this is a recording, not a scene"),
    "words for a terminal": (members(environment="\x1b]0;x\x07"), "must be one line that can be printed"),
    "words for a server": (members(sandbox="1\n::error::x"), "must be one line that can be printed"),
}


@pytest.mark.parametrize("name", FILES)
def test_one_error_and_exit_2(cli: Callable, good: str, name: str) -> None:
    change, said = FILES[name]
    content = change(good)
    assert content != good
    Path("bad.replay.json").write_bytes(content if isinstance(content, bytes) else content.encode())
    done = cli("replay", "bad.replay.json")
    assert done.code == 2
    assert done.err.startswith("bad.replay.json:")
    assert said in done.err
    assert "Traceback" not in done.err
    assert "this is a bug" not in done.err
    assert "\x1b" not in done.err
    assert "unusable" in done.out


@pytest.mark.parametrize(
    "arguments",
    [
        ["diff", "bad.replay.json", "bad.replay.json"],
        ["render", "bad.replay.json", "-o", "out.html"],
        ["bisect", "bad.replay.json", "--good", "HEAD"],
        ["replay", "bad.replay.json", "--update=all"],
        ["replay", "bad.replay.json", "--report", "out.html"],
        ["replay", "bad.replay.json", "--heavy", "--json"],
        ["record", "ramp", "-o", "out.replay.json", "--commands", "bad.replay.json"],
    ],
    ids=" ".join,
)
def test_every_command_that_reads_one(cli: Callable, good: str, arguments: list[str]) -> None:
    bad = good.replace('"steps": 12', '"steps": 1000000000')
    Path("bad.replay.json").write_text(bad)
    done = cli(*arguments)
    assert done.code == 2
    assert "bad.replay.json:" in done.err
    assert "steps must not be above 1e+06" in done.err
    assert Path("bad.replay.json").read_text() == bad
    assert not Path("out.replay.json").exists()


def test_a_recording_that_is_damaged_gives_no_picture(cli: Callable, good: str) -> None:
    Path("good.replay.json").write_text(good)
    assert cli("render", "good.replay.json", "-o", "out.png").code == 0
    Path("bad.replay.json").write_text(good[:-40])
    done = cli("render", "bad.replay.json", "-o", "other.png")
    assert (done.code, "bad.replay.json:" in done.err, Path("other.png").exists()) == (2, True, False)


@pytest.mark.skipif(not hasattr(os, "symlink") or os.name == "nt", reason="needs POSIX links")
def test_links_to_nowhere_and_to_no_end(cli: Callable) -> None:
    Path("loop.replay.json").symlink_to("loop.replay.json")
    done = cli("replay", "loop.replay.json")
    assert (done.code, "Traceback" in done.err) == (2, False)
    Path("zero.replay.json").symlink_to("/dev/zero")
    done = cli("replay", "zero.replay.json")
    assert (done.code, "it is a device, not a regular file" in done.err) == (2, True)


@pytest.mark.parametrize("secret", ["SECRET=abc", '{"SECRET": "abc"}', "[1, 2, SECRET]", "", "\xff", '"SECRET'])
@pytest.mark.parametrize("command", [["replay"], ["render", "-o", "x.html"], ["diff", "pyramid-10"]])
def test_nothing_is_shown_of_a_file_that_is_no_scene(cli: Callable, good: str, secret: str, command: list[str]) -> None:
    Path("private.json").write_text(secret, encoding="latin-1")
    data = json.loads(good)
    del data["scene"]["content"]
    data["scene"]["path"] = "private.json"
    Path("bad.replay.json").write_text(json.dumps(data))
    done = cli(*command, "bad.replay.json")
    assert done.code == 2
    said = (
        "private.json: the recording names this file as its scene, but it is none: look at scene.path in the recording"
    )
    assert done.err == f"{said}\n"
    assert "SECRET" not in done.out


def test_mistakes_of_a_scene_are_shown(cli: Callable, good: str) -> None:
    data = json.loads(good)
    content = data["scene"].pop("content")
    data["scene"]["path"] = "other.json"
    Path("bad.replay.json").write_text(json.dumps(data))
    Path("other.json").write_text(json.dumps({**content, "gravitee": [0, 1]}))
    done = cli("replay", "bad.replay.json")
    assert (done.code, 'did you mean "gravity"?' in done.err) == (2, True)
