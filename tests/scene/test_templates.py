"""Bodies of a kind that was read before are read as all others are, mistakes included."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.errors import SceneError
from sandbox.scene.known import Known
from sandbox.scene.spawned import Spawning
from sandbox.scene.templates import Templates
from tests.examples import examples

SCENE = sandbox.Scene(
    materials={"ice": {"friction": 0.0}},
    prefabs={
        "crate": {"shapes": [{"box": [1, 1]}], "angle": 30, "velocity": [1, 0]},
        "post": {"type": "static", "shapes": [{"box": [1, 4]}]},
    },
    bodies=[{"id": "there", "type": "static", "shapes": [{"circle": 1}]}],
)
KNOWN = Known({"there": "static"}, {}, 1)
kinds: st.SearchStrategy[dict[str, Any]] = st.sampled_from([
    {"prefab": "crate"}, {"prefab": "post"}, {"shapes": [{"circle": 0.5}]}, {"shapes": [{"circle": 1}]},
    {"shapes": [{"circle": 1.0}]}, {"shapes": ({"circle": 1},)}, {"shapes": [{"circle": True}]},
    {"shapes": [{"circle": -0.0}]}, {"shapes": [{"box": [1, 2]}], "material": "ice", "type": "kinematic"},
    {"shapes": [{"circle": np.float64(0.5)}]}, {"prefab": "none"}, {"shapes": []}, {"shapes": [{"circle": 0.5, 1: 2}]},
    {"type": "static", "shapes": [{"chain": [[0, 0], [1, 0], [2, 1]]}]},
])  # fmt: skip
numbers = st.sampled_from([0, 0.0, -0.0, 1, 2.5, True, "1", None, float("nan"), 1e12, np.float64(2.0)])
points = st.one_of(st.lists(numbers, min_size=1, max_size=3), st.tuples(numbers, numbers))
fields = st.fixed_dictionaries(
    {},
    optional={
        "id": st.sampled_from(["a", "b", "there", "", 7, "not so"]), "position": points, "velocity": points,
        "angle": numbers, "angular_velocity": numbers, "colour": st.just("#ffffff"),
    },
)  # fmt: skip
entries = st.builds(lambda kind, own: {"id": "a", **kind, **own}, kinds, fields)
joints = st.builds(
    lambda name, both, lower: {"id": name, "type": "revolute", "bodies": both, "anchor": [0, 0], "lower": lower},
    st.sampled_from(["j", "k", 3]), st.lists(st.sampled_from(["a", "b", "there", None]), min_size=1, max_size=2),
    st.sampled_from([-10, 0, "x"]),
)  # fmt: skip


def told(spawning: Spawning, bodies: Any, held: Any) -> Any:
    """What comes of reading entries, or what is wrong with them. As text: -0.0 is not 0.0."""
    try:
        return repr(spawning.read(bodies, held, KNOWN, "test"))
    except SceneError as error:
        return str(error)


@given(st.lists(st.tuples(st.lists(entries, max_size=3), st.lists(joints, max_size=2)), min_size=1, max_size=5))
@examples(300)
def test_what_was_read_before_changes_nothing(turns: list[Any]) -> None:
    spawning = Spawning(SCENE)
    for _ in range(2):
        for bodies, held in turns:
            assert told(spawning, bodies, held) == told(Spawning(SCENE), bodies, held)


def test_only_the_first_of_a_kind_is_read_in_full(monkeypatch: pytest.MonkeyPatch) -> None:
    spawning = Spawning(SCENE)
    crate = {"shapes": [{"box": [1, 1]}, {"circle": 0.3}]}
    first = spawning.read([{**crate, "id": "a"}], [], KNOWN, "test")
    monkeypatch.setattr("sandbox.scene.spawned.cross_checks", lambda *_: pytest.fail("read in full"))
    again = spawning.read([{**crate, "id": "b"}, {"id": "c", **crate}], [], KNOWN, "test")
    assert [body.id for body in again.bodies] == ["b", "c"]
    assert all(body.shapes is first.bodies[0].shapes for body in again.bodies)


def test_templates_are_not_kept_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sandbox.scene.templates._MOST", 4)
    spawning = Spawning(SCENE)
    for k in range(10):
        entry = {"id": "a", "shapes": [{"circle": 1.0 + k}]}
        assert spawning.read([entry], [], KNOWN, "test").bodies[0].shapes[0].radius == 1.0 + k
    templates: Templates = spawning._templates
    assert len(templates._known) <= 4
