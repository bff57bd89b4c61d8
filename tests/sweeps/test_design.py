"""Which values runs have: grids, samples, and paths into a scene."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.sweeps.design import grid, sample
from sandbox.sweeps.override import Words

DOCUMENT = {
    "materials": {"wood": {"friction": 0.4}},
    "prefabs": {"ball": {"shapes": [{"circle": 0.1}]}},
    "bodies": [{"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 2]}],
    "generate": [{"id": "rain", "scatter": "ball", "count": 3, "inside": [0, 3, 4, 6], "seed": 5}],
}


def test_a_grid_is_every_combination_in_order() -> None:
    design = grid({"a": "0.1:0.9:9", "b": "0:2", "c": "wood, ice,true,7"})
    assert design.paths == ("a", "b", "c")
    assert len(design.runs) == 9 * 3 * 4
    assert design.runs[:5] == ((0.1, 0, "wood"), (0.1, 0, "ice"), (0.1, 0, True), (0.1, 0, 7), (0.1, 1, "wood"))
    assert [values[0] for values in design.runs[::12]] == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]


def test_values_from_python() -> None:
    assert grid({"a": range(3)}).runs == ((0,), (1,), (2,))
    assert grid({"a": np.linspace(0, 1, 3), "b": [True, "x"]}).runs[1] == (0.0, "x")
    assert [type(value) for value in grid({"a": np.arange(2)}).runs[0]] == [int]


@given(st.integers(0, 2**63), st.integers(1, 40), st.integers(1, 40))
def test_a_longer_sample_begins_with_a_shorter_one(seed: int, one: int, more: int) -> None:
    vary = {"a": "0.5:2", "b": "-3:3", "c": "x,y"}
    short, long = sample(vary, one, seed), sample(vary, one + more, seed)
    assert long.runs[:one] == short.runs
    for a, b, c in long.runs:
        assert 0.5 <= a < 2
        assert b in range(-3, 4)
        assert c in ("x", "y")


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ("0.1:0.9", "how many numbers"),
        ("3:1", "write 1:3"),
        ("0:1:0", "a whole number from 1"),
        ("0:1:2.5", "a whole number from 1"),
        ("1:2:3:4", "a range is LOW:HIGH:COUNT"),
        ("a,,b", "nothing between two commas"),
        ("0:99999999999", "at most 1,000,000"),
        ([], "list of values"),
        (7, "list of values"),
        ([None], "a value is a finite number"),
        ([float("nan")], "a value is a finite number"),
    ],
)
def test_what_is_no_range(values: object, said: str) -> None:
    with pytest.raises(sandbox.ArgumentError, match=said):
        grid({"gravity.1": values})


def test_too_many_runs() -> None:
    with pytest.raises(sandbox.ArgumentError, match="4,000,000 runs"):
        grid({"a": "1:2000", "b": "1:2000"})


def test_paths_lead_to_values() -> None:
    values = {"gravity.1": -2.0, "bodies.crate.position.0": 3.0, "bodies.0.angle": 9.0, "settings.substeps": 7,
              "materials.wood.friction": 0.9, "generate.rain.count": 2, "seed": 8,
              "bodies.crate.velocity.1": 4.0}  # fmt: skip
    scene = Words.of(sandbox.Scene(**DOCUMENT)).with_values(values)
    assert scene.gravity == (0.0, -2.0)
    assert scene.bodies[0].position == (3.0, 2.0)
    assert (scene.bodies[0].angle, scene.bodies[0].velocity) == (9.0, (0.0, 4.0))
    assert scene.settings.substeps == 7
    assert scene.materials["wood"].friction == 0.9
    assert (scene.generate[0].count, scene.generate[0].seed) == (2, 8)  # type: ignore[union-attr]
    assert DOCUMENT["bodies"][0]["position"] == [0, 2]  # type: ignore[index]


@pytest.mark.parametrize(
    ("path", "said"),
    [
        ("gravty.1", 'gravty.1: the scene has no "gravty": did you mean "gravity"?'),
        ("gravity.2", 'gravity has no "2"'),
        ("gravity.1.0", "gravity.1 is a value by itself"),
        ("bodies.crat.angle", 'did you mean "crate"'),
        ("materials.wod.friction", 'did you mean "wood"'),
        ("vars.grip", 'the scene has no number "grip"'),
        ("", 'has no ""'),
    ],
)
def test_paths_that_lead_nowhere(path: str, said: str) -> None:
    words = Words.of(sandbox.Scene(**DOCUMENT))
    with pytest.raises(sandbox.SceneError) as error:
        words.with_values({path: 0})
    assert said in words.told(error.value)


def test_numbers_by_name_and_values_set_before() -> None:
    text = """{"vars": {"x": 1, "seed": 2}, "bodies": [
        {"id": "a.b", "shapes": [{"box": [1, 1]}], "position": ["=x", "=seed"]}]}"""
    words = Words.of(sandbox.loads_scene(text, set={"vars.x": 7}))
    scene = words.with_values({"seed": 5, "bodies.a.b.angle": 30})
    assert (scene.bodies[0].position, scene.bodies[0].angle) == ((7.0, 5.0), 30.0)


def test_a_seed_of_nothing() -> None:
    with pytest.raises(sandbox.ArgumentError, match="nothing in this scene is random"):
        Words.of(sandbox.Scene()).with_values({"seed": 1})
