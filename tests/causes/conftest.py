"""Recordings that part from what is run, in folders of their own, with git and without."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from tests.cli.conftest import cli  # noqa: F401
from tests.git_folder import enter

SLOPE = {"id": "slope", "type": "static", "shapes": [{"box": [40, 1]}], "angle": -15}
BOX = {"id": "box", "shapes": [{"box": [1, 1]}], "position": [-3, 4], "angle": -15}
PUSH = [20, "ApplyImpulse", {"body": "box", "impulse": [0.5, 0.0]}]
STOP = [31, "SetVelocity", {"body": "box", "velocity": [0.0, 0.0], "angular_velocity": 0.0}]


@dataclass(frozen=True)
class Views:
    """The four views of one failure: the text of `sandbox replay`, its JSON, JUnit and page."""

    text: str
    entry: dict[str, Any]
    junit: str
    page: str

    @property
    def divergence(self) -> Any:
        return self.entry["divergence"]

    def all_say(self, words: str) -> bool:
        """Whether all four have these words."""
        told = "\n".join(self.entry["reasons"])
        return all(words in view for view in (self.text, told, self.junit, self.page))


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    enter(tmp_path, monkeypatch)


@pytest.fixture
def views(cli: Callable) -> Callable[..., Views]:  # noqa: F811
    """Runs `sandbox replay` on one failing recording, twice, and gives all that it says."""

    def look(*arguments: object) -> Views:
        done = cli("replay", *arguments, "--report", "r.html", "--junit", "j.xml")
        assert done.code == 1, done.out + done.err
        (entry,) = json.loads(cli("replay", *arguments, "--json").out)["replays"]
        return Views(done.out, entry, junit_text(Path("j.xml")), page_text(Path("r.html")))

    return look


def junit_text(path: Path) -> str:
    """What the first failure of a JUnit file says."""
    failure = ElementTree.parse(path).getroot()[0][0][0]
    return failure.text or ""


def page_text(path: Path) -> str:
    """A page with its commonest entities read."""
    text = path.read_text(encoding="utf-8")
    return text.replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&")


def write(*bodies: Any, friction: float = 0.3, **fields: Any) -> Path:
    """The scene `slide.scene.json`, with one friction for all."""
    made = [{**body, "material": "stuff"} for body in bodies or (SLOPE, BOX)]
    data = {"materials": {"stuff": {"friction": friction}}, "bodies": made, "settings": {"steps": 60}, **fields}
    path = Path("slide.scene.json")
    path.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
    return path


def record(cli: Callable, *options: object) -> Path:  # noqa: F811
    """Record that scene."""
    assert cli("record", "slide.scene.json", "-o", "slide.replay.json", *options).code == 0
    return Path("slide.replay.json")


def place(path: Path, words: str) -> str:
    """`FILE:LINE:COLUMN` of the first place of some words in a file, counted from 1."""
    text = path.read_text(encoding="utf-8")
    before = text[: text.index(words)]
    return f"{path.as_posix()}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"
