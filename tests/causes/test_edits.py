"""What was changed in scenes, commands and sources, in words with places."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sandbox import ApplyImpulse, SetVelocity
from sandbox.replay.causes.command_edits import command_edits, located
from sandbox.replay.causes.engine_edits import FileEdit, between_folders, is_engine, told
from sandbox.replay.causes.scene_edits import edits, edits_in_text

BALL = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 1]}
WALL = {"id": "wall", "type": "static", "shapes": [{"box": [1, 2]}, {"box": [2, 1], "friction": 0.5}]}
PUSH = (3, ApplyImpulse("ball", (1.0, 0.0)))
STOP = (7, SetVelocity("ball", (0.0, 0.0), 0.0))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ({"bodies": [BALL, WALL]}, {"bodies": [BALL, WALL]}, []),
        ({"title": "a", "about": "b", "expect": []}, {"title": "c", "view": {"height": 3}}, []),
        ({"bodies": [BALL]}, {"bodies": [{**BALL, "color": "#ff0000"}]}, []),
        ({"gravity": [0, -9.81]}, {"gravity": [0, -9.8]}, ["gravity was [0, -9.81] and is [0, -9.8]"]),
        ({}, {"gravity": [0, -9.8]}, ["gravity is new: [0, -9.8]"]),
        ({"bodies": [BALL]}, {"bodies": [{**BALL, "mass": 2}]}, ["bodies[ball].mass is new: 2"]),
        (
            {"bodies": [BALL, WALL]},
            {"bodies": [WALL, {**BALL, "position": [0, 2]}]},
            ["bodies[ball].position was [0, 1] and is [0, 2]"],
        ),
        (
            {"bodies": [WALL]},
            {"bodies": [{**WALL, "shapes": [WALL["shapes"][0], {"box": [2, 1]}]}]},
            ["bodies[wall].shapes[1].friction was 0.5 and is gone"],
        ),
        (
            {"materials": {"ice": {"friction": 0.1}}},
            {"materials": {"ice": {"friction": 0.1, "restitution": 0.2}, "mud": {}}},
            ["materials.ice.restitution is new: 0.2", "materials.mud is new: {}"],
        ),
    ],
)  # fmt: skip
def test_edits_of_a_scene(old: Any, new: Any, said: list[str]) -> None:
    assert [str(edit) for edit in edits(old, new)] == said


def test_a_body_that_is_gone_or_new_is_told_short() -> None:
    (gone,) = map(str, edits({"bodies": [BALL, WALL]}, {"bodies": [BALL]}))
    assert gone.startswith('bodies[wall] was {"id": "wall"')
    assert gone.endswith("... and is gone")
    assert len(gone) < 100
    (new,) = map(str, edits({"bodies": [BALL]}, {"bodies": [BALL, WALL]}))
    assert new.startswith('bodies[wall] is new: {"id": "wall"')


def test_places_are_those_of_the_text_of_now_and_five_are_told() -> None:
    old = {"bodies": [{"id": f"b{k}", "mass": 1} for k in range(8)]}
    new = {"bodies": [{"id": f"b{k}", "mass": 2} for k in range(8)]}
    text = json.dumps(new, indent=1)
    said = edits_in_text(old, new, text, "a.json")
    assert len(said) == 6
    assert said[-1] == "and 3 more"
    line = text[: text.index('"b1"')].count("\n") + 2
    assert said[1] == f"a.json:{line}:12: bodies[b1].mass was 1 and is 2"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ([PUSH, STOP], [PUSH, STOP], []),
        (
            [PUSH, STOP],
            [PUSH, (9, STOP[1])],
            ["command 2 (step 9, SetVelocity on ball): its step was 7 and is 9"],
        ),
        (
            [PUSH],
            [(3, SetVelocity("ball", (1.0, 0.0), 0.0))],
            ["command 1 (step 3, SetVelocity on ball): it was ApplyImpulse"],
        ),
        (
            [PUSH],
            [(4, ApplyImpulse("egg", (1.0, 0.5)))],
            [
                'command 1 (step 4, ApplyImpulse on egg): its step was 3 and is 4, body was "ball" and is "egg", '
                "impulse was [1.0, 0.0] and is [1.0, 0.5]"
            ],
        ),
        ([PUSH, STOP], [STOP], ["command 1 (step 3, ApplyImpulse on ball) is gone"]),
        ([STOP], [PUSH, STOP], ["command 1 (step 3, ApplyImpulse on ball) is new"]),
        ([PUSH], [PUSH, STOP], ["command 2 (step 7, SetVelocity on ball) is new"]),
        ([PUSH, STOP], [PUSH], ["command 2 (step 7, SetVelocity on ball) is gone"]),
    ],
)  # fmt: skip
def test_edits_of_commands(old: Any, new: Any, said: list[str]) -> None:
    assert [words for _, words in command_edits(old, new)] == said


def test_a_command_that_is_gone_has_the_place_of_the_list() -> None:
    text = '{\n "commands": []\n}'
    assert located(command_edits([PUSH], []), text, "a.json")[0].startswith("a.json:2:14: command 1 ")


def test_a_few_changed_lines_are_shown_and_many_are_not() -> None:
    one = FileEdit("sandbox/engine/a.py", "x = 1\ny = 2\n", "x = 1\ny = 3\nz = 4\n")
    assert told([one]) == [
        "sandbox/engine/a.py:2: was `y = 2`, is `y = 3`",
        "sandbox/engine/a.py:3: was ``, is `z = 4`",
    ]
    many = FileEdit("sandbox/engine/b.py", "", "\n".join(f"x{k} = 1" for k in range(9)))
    assert told([one, many]) == ["sandbox/engine/a.py, sandbox/engine/b.py"]
    assert told([many] * 8) == [", ".join(["sandbox/engine/b.py"] * 5) + " and 3 more"]


def test_only_what_decides_about_bits_counts(tmp_path: Path) -> None:
    assert is_engine("sandbox/engine/joints/ldl.py")
    assert is_engine("sandbox/_jit.py")
    assert not is_engine("sandbox/cli/replay.py")
    assert not is_engine("sandbox/engine/notes.md")
    assert not is_engine("tests/engine/test_step.py")
    for root, value in (("a", "1"), ("b", "2")):
        for name in ("engine/step.py", "cli/app.py", "world/same.py"):
            path = tmp_path / root / "sandbox" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("same\n" if "same" in name else f"x = {value}\n")
    (tmp_path / "b/sandbox/engine/new.py").write_text("z = 1\n")
    found = between_folders(tmp_path / "a", tmp_path / "b")
    assert [edit.path for edit in found] == ["sandbox/engine/new.py", "sandbox/engine/step.py"]
    assert found[0].old == ""
