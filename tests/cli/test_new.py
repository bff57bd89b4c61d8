"""`sandbox new`: starters that are sound as they are, and that nothing is lost for."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest

from sandbox.cli.starters import FOLDER, THEMES, starter
from sandbox.lint.run import lint
from sandbox.replay.headless_run import run_headless
from sandbox.resources import SCENE_SUFFIX, scene_name
from sandbox.scene import load_scene, loads_scene, schema
from sandbox.scene.layout import laid_out


@pytest.mark.parametrize("theme", THEMES)
def test_a_starter_is_sound(theme: str) -> None:
    first = starter(theme)
    scene = loads_scene(first.text)
    run = run_headless(scene)
    assert [verdict for verdict in run.verdicts if not verdict.holds] == []
    assert len(scene.expect) >= 3
    assert lint(scene) == []
    assert laid_out(first.text) == first.text
    jsonschema.Draft202012Validator(schema()).validate(json.loads(first.text))
    assert first.lines[-1].startswith("Try: ")
    assert first.text.count('"$comment"') >= 2


def test_every_file_is_on_the_list() -> None:
    assert sorted(map(scene_name, FOLDER.glob("*" + SCENE_SUFFIX))) == sorted(THEMES)


def test_it_is_written_and_never_over_another(cli: Callable, tmp_path: Path) -> None:
    path = tmp_path / "mine.scene.json"
    done = cli("new", "sat", "-o", path)
    assert done.code == 0
    assert f"sandbox run {path}" in done.out
    assert path.read_text(encoding="utf-8") == starter("sat").text
    done = cli("new", "-o", path)
    assert done.code == 2
    assert "--force" in done.err
    assert cli("new", "-o", path, "--force").code == 0
    assert load_scene(path).title == starter("stack").title


def test_a_schema_nearby_is_named(cli: Callable, tmp_path: Path) -> None:
    (tmp_path / "scene.schema.json").write_text("{}")
    (tmp_path / "a" / "b").mkdir(parents=True)
    for folder, address in ((tmp_path, "scene.schema.json"), (tmp_path / "a" / "b", "../../scene.schema.json")):
        path = folder / "x.scene.json"
        assert json.loads(cli("new", "game", "-o", path, "--json").out)["theme"] == "game"
        assert load_scene(path).schema_uri == address
        assert laid_out(path.read_text(encoding="utf-8")) == path.read_text(encoding="utf-8")


def test_themes_are_listed_and_found_by_near_names(cli: Callable) -> None:
    assert [line.split()[0] for line in cli("new", "--list").out.splitlines()] == list(THEMES)
    assert [each["theme"] for each in json.loads(cli("new", "--list", "--json").out)["starters"]] == list(THEMES)
    assert cli("new", "fluid").out == starter("fluid").text
    done = cli("new", "vehicles")
    assert done.code == 2
    assert 'did you mean "vehicle"?' in done.err
