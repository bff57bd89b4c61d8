"""Values set from outside: what paths mean, what is told of wrong ones, and that recordings keep them."""

from __future__ import annotations

import json

import pytest

from sandbox.errors import SceneError
from sandbox.replay.golden.rerun import rerun
from sandbox.replay.recording.recorder import record
from sandbox.replay.recording.recording import Recording
from sandbox.scene import load_scene, loads_scene

SCENE = {
    "vars": {"rows": 3, "side": "=1/2"},
    "prefabs": {"crate": {"shapes": [{"box": ["=side", "=side"]}]}},
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]},
        {"id": "big.crate", "prefab": "crate", "position": [3, 5]},
    ],
    "generate": [{"id": "wall", "row": "crate", "count": "=rows", "at": [0, 4]}],
}
TEXT = json.dumps(SCENE)


@pytest.mark.parametrize(
    ("path", "value", "found"),
    [
        ("vars.rows", 5, lambda scene: len(scene.flatten().bodies) == 7),
        ("vars.rows", "=2+2", lambda scene: len(scene.flatten().bodies) == 6),
        ("gravity.1", -1.62, lambda scene: scene.gravity == (0, -1.62)),
        ("bodies.0.shapes.0.box.0", 30, lambda scene: scene.bodies[0].shapes[0].box == (30, 1)),
        ("bodies.big.crate.position.0", 7, lambda scene: scene.bodies[1].position == (7, 5)),
        ("bodies.ground.position", [1, 2], lambda scene: scene.bodies[0].position == (1, 2)),
        ("bodies.big.crate.velocity.0", 2, lambda scene: scene.bodies[1].velocity == (2, 0)),
        ("settings.substeps", 8, lambda scene: scene.settings.substeps == 8),
        ("view.height", 20, lambda scene: scene.view.height == 20),
        ("prefabs.crate.type", "static", lambda scene: scene.flatten().bodies[1].type == "static"),
        ("generate.wall.count", 1, lambda scene: len(scene.flatten().bodies) == 3),
        ("title", "Two", lambda scene: scene.title == "Two"),
    ],
)  # fmt: skip
def test_a_path_sets_a_value(path, value, found):
    scene = loads_scene(TEXT, set={path: value})
    assert found(scene)
    assert scene.set_values == {path: value}


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("vars.row", 5, 'the scene has no number "row": did you mean "vars.rows"?'),
        ("gravitty.1", 5, 'the scene has no "gravitty": did you mean "gravity"?'),
        ("gravitty", 5, 'the scene has no "gravitty": did you mean "gravity"?'),
        ("bodies.grund.mass", 5,
         'bodies has no "grund"; it has 2 entries, and no id of that name: did you mean "ground"?'),
        ("bodies.2.mass", 5, 'bodies has no "2"; it has 2 entries, and no id of that name'),
        ("bodies.-1.mass", 5, 'bodies has no "-1"; it has 2 entries, and no id of that name'),
        ("bodies.ground.mas", 5, 'bodies.0 has no "mas": did you mean "mass"?'),
        ("bodies.ground.mass", "2 kg", "mass must be a number, not text: a number stands without its unit and quotes"),
        ("bodies.ground.id.x", 5, 'bodies.0.id is a value by itself, and has no "x"'),
        ("bodies.ground.mass.x", 5, 'bodies.0 has no "mass" in which something could be set: set all of it'),
        ("settings.substeps", 0, "substeps must not be below 1"),
        ("view.follow", "grund", 'no body has the id "grund": did you mean "ground"?'),
        ("vars.rows", "=1/0", "division by zero"),
        ("", 1, 'the scene has no ""'),
        ("..", 1, 'the scene has no ""'),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_the_path(path, value, said):
    with pytest.raises(SceneError) as caught:
        loads_scene(TEXT, "x.json", {path: value})
    assert caught.value.lines() == [f"x.json: --set {path}: {said}"]


def test_the_author_s_own_mistakes_keep_their_places():
    with pytest.raises(SceneError) as caught:
        loads_scene('{"vars": {"a": 1},\n "titel": "x"}', "x.json", {"vars.a": 2})
    assert caught.value.lines()[0] == 'x.json:2:2: unknown field "titel": did you mean "title"?'


def test_values_are_not_shared_with_the_caller():
    position = [0, 4]
    scene = loads_scene(TEXT, set={"bodies.ground.position": position})
    position[0] = 9
    assert scene.bodies[0].position == (0, 4)


@pytest.mark.parametrize("embed", [False, True])
def test_a_recording_is_replayed_with_what_was_set(tmp_path, embed):
    path = tmp_path / "a.scene.json"
    path.write_text(TEXT)
    recorded = record(load_scene(path, set={"vars.rows": 2, "gravity.1": -5}), 20)
    recorded.save(tmp_path / "a.replay.json", embed=embed)
    again = Recording.load(tmp_path / "a.replay.json")
    assert len(again.load_scene().flatten().bodies) == 4
    assert rerun(again).passed
    assert again.scene.set == ({} if embed else {"vars.rows": 2, "gravity.1": -5})


def test_a_recording_notices_that_an_included_file_changed(tmp_path):
    (tmp_path / "b.json").write_text('{"prefabs": {"ball": {"shapes": [{"circle": 1}]}}}')
    path = tmp_path / "a.scene.json"
    path.write_text('{"include": ["b.json"], "bodies": [{"id": "it", "prefab": "ball"}]}')
    record(path, 5).save(tmp_path / "a.replay.json")
    (tmp_path / "b.json").write_text('{"prefabs": {"ball": {"shapes": [{"circle": 2}]}}}')
    outcome = rerun(Recording.load(tmp_path / "a.replay.json"))
    assert not outcome.passed
    assert "body it was edited" in outcome.edits
