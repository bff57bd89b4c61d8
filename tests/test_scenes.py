"""The shipped scenes: tidy files whose expectations hold."""

from __future__ import annotations

import json
import re

import pytest

from sandbox.replay.headless_run import run_headless
from sandbox.resources import scenes_dir, shipped_scenes
from tests.shipped import FILES, shipped

PROMISED = {
    "pyramid-10", "pyramid-30", "pyramid-100", "stack-12", "stack-20", "card-house", "arch", "dominoes", "ramp",
    "bouncing-balls", "newtons-cradle", "newtons-cradle-two", "dust", "far-away",
}  # fmt: skip
every_scene = pytest.mark.parametrize("name", FILES)


@every_scene
def test_it_keeps_its_promises(name: str) -> None:
    run = run_headless(shipped(name))
    assert [verdict for verdict in run.verdicts if not verdict.holds] == []
    assert run.frozen == ()


@every_scene
def test_it_is_tidy(name: str) -> None:
    file, scene = FILES[name], shipped(name)
    assert re.fullmatch(r"[a-z]+(-[a-z0-9]+)*", name)
    assert re.fullmatch(r"[a-z]+", file.parent.name)
    assert file.parent.parent == scenes_dir()
    assert scene.schema_uri is not None
    assert (file.parent / scene.schema_uri).is_file()
    text = file.read_text(encoding="utf-8")
    assert max(len(line) for line in text.splitlines() if not line.startswith('  "about"')) <= 126
    assert list(json.loads(text))[:4] == ["$schema", "format", "title", "about"]


@every_scene
def test_it_tells_what_to_watch_for(name: str) -> None:
    scene = shipped(name)
    assert 5 <= len(scene.title) <= 40
    assert not scene.title.endswith(".")
    assert 40 <= len(scene.about) <= 170
    assert re.search(r"[.?!]$", scene.about)


@every_scene
def test_nothing_may_leave_it(name: str) -> None:
    expect = shipped(name).to_data()["expect"]
    assert any("inside" in wanted and wanted.get("always") and "of" not in wanted for wanted in expect)
    assert len(expect) >= 3


def test_names_are_unique_and_the_promised_scenes_are_there() -> None:
    assert len(FILES) == len(shipped_scenes())
    assert FILES.keys() >= PROMISED
