"""Includes: what they bring, how far they reach, and that their mistakes are told in their own files."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sandbox.errors import SceneError
from sandbox.resources import part_file, shipped_parts
from sandbox.scene import Scene, load_scene
from sandbox.scene.authoring import include
from sandbox.scene.limits import MAX_NESTING

BALL = {"vars": {"r": 0.5}, "materials": {"wax": {"density": 2}}, "prefabs": {"ball": {"shapes": [{"circle": "=r"}]}}}
OUT = "an include must stay within the folder above that of the scene"
USES = {"bodies": [{"id": "it", "prefab": "ball"}]}


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Writes files below a folder by their ways, and gives the path of the last one."""

    def write(**files: Any) -> Path:
        path = tmp_path
        for name, content in files.items():
            path = tmp_path / "home" / (name.replace("__", "/") + ".json")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path

    return write


def told(path: Path) -> list[str]:
    with pytest.raises(SceneError) as caught:
        load_scene(path)
    folder = path.parents[1].as_posix() + "/"
    return [line.replace(folder, "") for line in caught.value.lines() if ".json" in line.split(": ")[0]]


def test_parts_bring_numbers_materials_and_prefabs(write):
    path = write(parts__ball=BALL, scenes__a={"include": ["../parts/ball.json"], **USES})
    scene = load_scene(path)
    assert scene.flatten().bodies[0].shapes[0].radius == 0.5
    assert scene.materials["wax"].density == 2
    assert [file.name for file in scene.included_files] == ["ball.json"]


def test_the_own_number_holds_for_what_was_included(write):
    path = write(parts__ball=BALL, scenes__a={"include": ["../parts/ball.json"], "vars": {"r": 3}, **USES})
    assert load_scene(path).flatten().bodies[0].shapes[0].radius == 3
    assert load_scene(path, set={"vars.r": 4}).flatten().bodies[0].shapes[0].radius == 4


def test_parts_include_parts_each_once(write):
    path = write(
        parts__ball=BALL,
        parts__b={"include": ["ball.json"], "prefabs": {"b": {"shapes": [{"circle": "=2*r"}]}}},
        scenes__a={"include": ["../parts/b.json", "../parts/ball.json"], **USES},
    )
    assert {*load_scene(path).prefabs} == {"ball", "b"}


def test_a_saved_scene_takes_along_what_it_included(write, tmp_path):
    path = write(parts__ball=BALL, scenes__a={"include": ["sandbox:materials", "../parts/ball.json"], **USES})
    scene = load_scene(path)
    scene.save(tmp_path / "far.json")
    words = json.loads((tmp_path / "far.json").read_text())
    assert words["include"] == ["sandbox:materials"]
    assert words["prefabs"] == BALL["prefabs"]
    assert load_scene(tmp_path / "far.json") == scene
    scene.save(path.parent / "near.json")
    assert json.loads((path.parent / "near.json").read_text())["include"] == ["sandbox:materials", "../parts/ball.json"]
    assert load_scene(path.parent / "near.json") == scene


def test_all_shipped_parts_can_be_included_together():
    ways = [include.SHIPPED + name for name in shipped_parts()]
    assert "sandbox:materials" in ways
    scene = Scene(include=ways, bodies=[{"id": "a", "material": "steel", "shapes": [{"circle": 1}]}])
    assert scene.flatten().bodies[0].shapes[0].density == 7.8


@pytest.mark.parametrize(
    ("way", "said"),
    [
        ("../../secret.json", f'{OUT}, and "../../secret.json" leads out of it: copy the file there'),
        ("link.json", f'{OUT}, and "link.json" leads out of it: copy the file there'),
        ("/etc/passwd.json", 'an include is the way to a .json file from here, or "sandbox:NAME"'),
        ("c:/a.json", "an include is the way to a .json file from here, with / between folders"),
        ("..\\parts\\ball.json", 'an include is the way to a .json file from here, or "sandbox:NAME"'),
        ("../parts/ball.txt", 'an include is the way to a .json file from here, or "sandbox:NAME"'),
        ("../parts/bal.json", 'there is no file "../parts/bal.json": did you mean "../parts/ball.json"?'),
        ("../parts", 'an include is the way to a .json file from here, or "sandbox:NAME"'),
        ("sandbox:materials.json", 'no part is named "materials.json": did you mean "sandbox:materials"?'),
        ("sandbox:../README", 'no part is named "../README": '),
        ("a.json", "these files include each other: a.json"),
        ("\u0000.json", 'an include is the way to a .json file from here, or "sandbox:NAME"'),
    ],
)  # fmt: skip
def test_ways_that_are_refused(write, tmp_path, way, said):
    (tmp_path / "secret.json").write_text('{"vars": {"key": 4711}}')
    path = write(parts__ball=BALL, scenes__a={"include": [way]})
    os.symlink(tmp_path / "secret.json", path.parent / "link.json")
    (line,) = told(path)
    assert line.startswith(f"scenes/a.json:1:14: {said}")


def test_a_scene_in_no_file_reads_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ball.json").write_text(json.dumps(BALL))
    with pytest.raises(SceneError, match="includes only what comes with the package"):
        Scene(include=["ball.json"])


@pytest.mark.parametrize(
    ("part", "said"),
    [
        ('{"prefabs": {"ball": {"shapes": [{"circle": -1}]}}}', "parts/p.json:1:45: circle must not be below 1e-06 m"),
        ('{"vars": {"r": "=1/0"},\n "prefabs": {"ball": {"shapes": [{"circle": "=r"}]}}}',
         "parts/p.json:1:19: division by zero"),
        ('{"bodies": []}',
         'parts/p.json:1:2: an included file has no "bodies": a part brings vars, materials and prefabs'),
        ("[]", "parts/p.json:1:1: a part must be an object {...}, not a list"),
        ('{"prefabs": []}', "parts/p.json:1:13: prefabs must be an object {...}, not a list"),
        ('{"include": "x"}', 'parts/p.json:1:13: include must be a list ["FILE.json", ...]'),
        ('{"vars": {"a": 1, "a": 2}}', 'parts/p.json:1:19: "a" is given twice'),
        ('{"vars": }', "parts/p.json:1:10: a value is due here"),
        ('{"include": ["p.json"]}', "parts/p.json:1:14: these files include each other: p.json > p.json"),
        ('{"include": ["../scenes/a.json"]}', "parts/p.json:1:14: these files include each other: p.json > a.json"),
        ('{"include": ["../../secret.json"]}', "parts/p.json:1:14: an include must stay within the folder above"),
    ],
)  # fmt: skip
def test_mistakes_in_parts_are_told_there(write, part, said):
    lines = told(write(parts__p=part, scenes__a={"include": ["../parts/p.json"]}))
    assert lines[0].startswith(said)
    assert len(lines) == 1


def test_two_parts_of_one_name(write):
    files = {"parts__p": BALL, "parts__q": {"vars": {"r": 1}}}
    scene = {"include": ["../parts/p.json", "../parts/q.json"]}
    (line,) = told(write(**files, scenes__a=scene))
    assert 'two files bring "vars" "r"' in line
    assert load_scene(write(**files, scenes__a={**scene, "vars": {"r": 7}})).vars["r"] == 7


def test_includes_end_somewhere(write):
    files = {f"parts__p{k}": {"include": [f"p{k + 1}.json"]} for k in range(MAX_NESTING + 1)}
    path = write(**files, scenes__a={"include": ["../parts/p0.json"]})
    assert "deeper than 16 levels" in told(path)[0]


def test_parts_are_not_larger_than_a_scene_together(write, monkeypatch):
    monkeypatch.setattr(include, "MAX_BYTES", 100)
    path = write(
        parts__p=" " * 60 + "{}",
        parts__q=" " * 60 + "{}",
        scenes__a={"include": ["../parts/p.json", "../parts/q.json"]},
    )
    assert "larger than" in told(path)[0]


def test_the_materials_are_those_that_are_documented():
    names = json.loads(part_file("materials").read_text(encoding="utf-8"))["materials"]
    text = (part_file("materials").parents[1] / "README.md").read_text(encoding="utf-8")
    assert [name for name in names if name not in text] == []
