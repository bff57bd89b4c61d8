"""A scene written out comes down to the same: to the bit, as its recording would say."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given

from sandbox.engine.world import World
from sandbox.replay.recording.meaning import meaning_of
from sandbox.scene import Scene, loads_scene
from sandbox.scene.pretty import scene_text
from sandbox.scene.write_out import written_out
from tests.examples import examples
from tests.scene.scene_strategies import scenes
from tests.shipped import FILES, shipped

MOST = 200


def loaded_again(scene: Scene) -> Scene:
    return loads_scene(scene_text(written_out(scene)))


@pytest.mark.parametrize("name", list(FILES)[::3])
def test_shipped_scenes_mean_the_same_written_out(name: str) -> None:
    scene = shipped(name)
    if len(scene.flatten().bodies) > MOST:
        pytest.skip("large, and like others")
    out = loaded_again(scene)
    assert not out.generate
    assert not out.prefabs
    assert meaning_of(out.flatten()) == meaning_of(scene.flatten())
    assert out.expect == scene.expect


@pytest.mark.parametrize("name", ["breakout", "bridge-160", "wrecking-shot", "lift", "harbour"])
def test_it_runs_to_the_same_bits(name: str) -> None:
    worlds = World(shipped(name)), World(loaded_again(shipped(name)))
    for world in worlds:
        world.step(20)
    assert worlds[0].digest() == worlds[1].digest()


@given(scenes())
@examples(12)
def test_any_scene_means_the_same_written_out(data: dict[str, Any]) -> None:
    scene = loads_scene(json.dumps(data))
    flat = scene.flatten()
    # A prefab may have thrusters, and a body of it be of a type that they do not push.
    bodies = [body if body.type == "dynamic" else replace(body, thrusters=()) for body in flat.bodies]
    assert meaning_of(loaded_again(scene).flatten()) == meaning_of(replace(flat, bodies=tuple(bodies)))


def test_every_generator_and_spawned_bodies_are_written_out() -> None:
    scene = Scene(
        materials={"wood": {"density": 0.7}},
        prefabs={"crate": {"shapes": [{"box": [1, 0.5]}], "material": "wood", "angle": 30, "color": "#123456"}},
        bodies=[{"id": "own", "prefab": "crate", "angle": 5}],
        generate=[
            {"id": "row", "row": "crate", "count": 3},
            {"id": "stack", "stack": "crate", "count": 3, "at": [9, 0]},
            {"id": "grid", "grid": "crate", "columns": 2, "rows": 2, "at": [19, 0], "stagger": 0.3},
            {"id": "peak", "pyramid": "crate", "rows": 3, "at": [29, 0]},
            {"id": "rain", "scatter": "crate", "count": 5, "inside": [0, 20, 9, 30], "angle": [-9, 9]},
            {"id": "rope", "chain": "crate", "count": 3, "at": [0, 9], "step": [0.7, 0.7], "pin": "both",
             "break_force": 100},
        ],
        joints=[{"id": "first", "type": "weld", "bodies": ["own"], "anchor": [0, 0]}],
        rules=[{"when": {"time": 1}, "do": [{"spawn": {"id": "new", "prefab": "crate", "position": [0, 50]}}]}],
    )  # fmt: skip
    out = loaded_again(scene)
    assert "prefab" not in scene_text(out.to_data())
    plain = [replace(body, pointer="") for body in scene.flatten().bodies]
    assert [replace(body, pointer="") for body in out.flatten().bodies] == plain
    assert [replace(joint, pointer="") for joint in out.flatten().joints] == [
        replace(joint, pointer="") for joint in scene.flatten().joints
    ]
    assert meaning_of(out.flatten()) == meaning_of(scene.flatten())
