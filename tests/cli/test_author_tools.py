"""`sandbox list`, `fmt`, `expand` and `schema`: what they print, write, and end with."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox import load_scene
from sandbox.resources import scenes_dir
from tests.shipped import FILES

UGLY = '{"title":"x",\n\n "bodies": [{"id": "a", "mass": 1e-3,\n  "shapes": [{"circle": 1.0}]}]}'
TIDY = """{
  "title": "x",
  "bodies": [{"id": "a", "mass": 1e-3, "shapes": [{"circle": 1.0}]}]
}
"""


def test_list_names_every_shipped_scene(cli: Callable) -> None:
    done = cli("list")
    assert done.code == 0
    assert {line.split()[0] for line in done.out.splitlines() if line.startswith("  ")} == FILES.keys()
    assert done.out.splitlines()[-1] == f"{len(FILES)} scenes; sandbox run NAME opens one"


def test_list_searches_words_and_themes(cli: Callable) -> None:
    found = json.loads(cli("list", "PYRAMID boxes", "--theme", "stacks", "--json").out)["scenes"]
    assert [entry["name"] for entry in found] == ["pyramid-10", "pyramid-30"]
    assert found[0].items() >= {"bodies": 56, "joints": 0, "steps": 600, "theme": "stacks"}.items()
    assert load_scene(found[0]["path"]).title == found[0]["title"]
    assert cli("list", "no such words").code == 5
    done = cli("list", "--theme", "stack")
    assert done.code == 2
    assert 'did you mean "stacks"?' in done.err


def test_fmt_lays_out_in_place_and_once(cli: Callable, tmp_path: Path) -> None:
    path = tmp_path / "a.scene.json"
    path.write_text(UGLY)
    assert cli("fmt", "--check", tmp_path).code == 1
    assert path.read_text() == UGLY
    done = cli("fmt", tmp_path)
    assert (done.code, done.out) == (0, f"{path}: laid out anew\n1 changed, 0 as they were\n")
    assert path.read_text() == TIDY
    assert cli("fmt", "--check", path).code == 0
    assert json.loads(cli("fmt", path, "--json").out)["files"] == [{"path": str(path), "changes": False}]


def test_fmt_between_pipes(cli: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    def given(text: str) -> None:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))

    given(UGLY)
    assert cli("fmt", "-").out == TIDY
    given(TIDY)
    assert cli("fmt", "-", "--check").code == 0
    given('{"bodies": [}')
    done = cli("fmt", "-")
    assert (done.code, done.out) == (2, "")
    assert "<stdin>:1:13" in done.err
    assert cli("fmt", "-", "x.json").code == 2


def test_fmt_leaves_alone_what_it_cannot_read(cli: Callable, tmp_path: Path) -> None:
    bad, good = tmp_path / "a.scene.json", tmp_path / "b.scene.json"
    bad.write_text('{"a": 1')
    good.write_text(UGLY)
    done = cli("fmt", tmp_path)
    assert done.code == 2
    assert f"{bad}:1:" in done.err
    assert (bad.read_text(), good.read_text()) == ('{"a": 1', TIDY)
    recording = next(scenes_dir().rglob("pyramid-10.replay.json"))
    assert "this is a recording" in cli("fmt", "--check", recording).err


def test_expand_writes_a_scene_that_loads(cli: Callable, tmp_path: Path) -> None:
    path = tmp_path / "out.scene.json"
    assert cli("expand", "pyramid-10", "-o", path).code == 0
    assert len(load_scene(path).bodies) == 56
    assert cli("fmt", "--check", path).code == 0
    done = cli("expand", "stack-12", "-o", path)
    assert done.code == 2
    assert "--force" in done.err
    assert cli("expand", "stack-12", "-o", path, "--force").code == 0
    assert cli("expand", "stack-12").out == path.read_text()


def test_schema_is_the_one_beside_the_scenes(cli: Callable, tmp_path: Path) -> None:
    shipped = (scenes_dir() / "scene.schema.json").read_text(encoding="utf-8")
    assert cli("schema").out == shipped
    assert cli("schema", "-o", tmp_path / "s.json").code == 0
    assert (tmp_path / "s.json").read_text(encoding="utf-8") == shipped
