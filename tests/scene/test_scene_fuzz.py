"""Whatever is done to a scene's text, loading gives a scene or a `SceneError`, never anything else."""

from __future__ import annotations

import json
from collections.abc import Callable
from copy import deepcopy
from typing import Any

from hypothesis import example, given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.scene import Scene, loads_scene
from tests.examples import examples
from tests.scene.scene_strategies import scenes

FRAGMENTS = [
    *'{}[]:,"\\0-.eE+#/ \n\t\ufeff\x00é',
    "NaN", "Infinity", "-Infinity", "1e999", "-1e999", "1e400", "1e-400", "9" * 400, "9" * 5000, "null", "true",
    "false", '"\\ud800"', '"*"', '"["', "[]", "{}", "[[1,2],[3,4]]", "[" * 40, "[" * 5000, '{"a":' * 40,
    '"id":"a",', '"at":1,', '"always":true,', '"circle":1,', '"box":[1,1],', '"prefab":"crate",', '"angle":90,',
    "1e-7", "1e7", "1e9", "-1", "0", "1.5", "4294967296", "100000", "1000001",
]  # fmt: skip
PYDANTIC = ("Input should", "Extra inputs", "Field required", "Value error")
KEYS = [
    "id",
    "shapes",
    "circle",
    "box",
    "prefab",
    "material",
    "at",
    "expect",
    "bodies",
    "generate",
    "rows",
    "x",
]
VALUES: list[Any] = [
    None, True, False, 0, -1, 1.5, 10**400, -(10**30), 1e308, 5e-324, float("nan"), float("inf"), "", "a", "*",
    "crate", "\ud800", "\x00circle", "#12", [], {}, [1], [1, 2], [1, 2, 3, 4], ["a", "a"], [[0, 0], [1, 1]],
    [[0, 0], [1, 0], [0, 1]], [[]], {"circle": 1}, {"id": "a"}, [{"circle": 1}], [{}], [{"id": "a"}, {"id": "a"}],
]  # fmt: skip


def refusal(build: Callable[[], object]) -> SceneError | None:
    try:
        build()
    except SceneError as error:
        return error
    return None


def load(text: str) -> None:
    """Load; a refusal must carry a place in the text and messages that any terminal can show."""
    error = refusal(lambda: loads_scene(text))
    if error is not None:
        assert error.problems
        str(error).encode("utf-8")
        assert not any(noise in str(error) for noise in PYDANTIC)
        lines = [problem.line for problem in error.problems if problem.line]
        assert lines == sorted(lines)
        assert lines or not text


@st.composite
def damaged_texts(draw: st.DrawFn) -> str:
    text = json.dumps(draw(scenes()), indent=draw(st.sampled_from([None, 1])))
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(0, 12)))
        text = text[:start] + draw(st.sampled_from(["", *FRAGMENTS])) + text[end:]
    return text


@st.composite
def damaged_data(draw: st.DrawFn) -> Any:
    """A scene in which a few values are replaced, added or taken away, at any depth."""
    data = deepcopy(draw(scenes()))  # what strategies share must stay whole for the next example
    for _ in range(draw(st.integers(1, 4))):
        node: Any = data
        while draw(st.integers(0, 4)) and isinstance(_any_child(draw, node), (dict, list)):
            node = _any_child(draw, node)
        _damage(draw, node)
    return data


def _any_child(draw: st.DrawFn, node: Any) -> Any:
    values = list(node.values()) if isinstance(node, dict) else node
    containers = [value for value in values if isinstance(value, (dict, list))]
    return draw(st.sampled_from(containers)) if containers else None


def _damage(draw: st.DrawFn, node: Any) -> None:
    if isinstance(node, dict):
        key = draw(st.sampled_from([*node, *KEYS]))
        node.pop(key, None)
        if draw(st.booleans()):
            node[key] = deepcopy(draw(st.sampled_from(VALUES)))
    elif node and draw(st.booleans()):
        node[draw(st.integers(0, len(node) - 1))] = deepcopy(draw(st.sampled_from(VALUES)))
    else:
        node.append(deepcopy(draw(st.sampled_from(VALUES))))


@given(damaged_texts())
@examples(120)
def test_damaged_text_is_a_scene_or_a_scene_error(text):
    load(text)


@given(damaged_data())
@examples(200)
@example({"bodies": 5, "generate": 5, "expect": 5, "materials": 5, "prefabs": 5, "categories": 5})
@example({"bodies": [{"id": "a", "shapes": [{"box": [10**400, 1], "radius": 10**400}]}]})
@example({"\ud800": 1})
def test_damaged_values_are_a_scene_or_a_scene_error(data):
    load(json.dumps(data))


@given(damaged_data())
@examples(100)
def test_damaged_values_in_python_are_a_scene_or_a_scene_error(data):
    error = refusal(lambda: Scene(**data).flatten())
    assert error is None or error.problems


@given(st.text())
def test_any_text_is_a_scene_or_a_scene_error(text):
    load(text)


@given(st.recursive(st.sampled_from(VALUES), lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner)))
def test_any_json_is_a_scene_or_a_scene_error(data):
    load(json.dumps(data))
