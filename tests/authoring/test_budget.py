"""What a few lines could make of themselves is refused before it is made."""

from __future__ import annotations

import json
import tracemalloc
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.scene import loads_scene
from sandbox.scene.authoring import output
from sandbox.scene.authoring.document import Document, Written
from sandbox.scene.authoring.least_bodies import least_bodies
from sandbox.scene.limits import MAX_NESTING
from tests.examples import examples

BALL = {"shapes": [{"circle": 1}]}


def told(prefabs: dict[str, Any], *generate: dict[str, Any]) -> str:
    """The first mistake of a scene; refusing it must take little memory."""
    text = json.dumps({"prefabs": prefabs, "generate": generate})
    loads_scene('{"prefabs": {"p": {"bodies": []}}, "generate": [{"id": "x", "place": "p"}]}')
    tracemalloc.start()
    with pytest.raises(SceneError) as caught:
        loads_scene(text)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000_000
    return caught.value.problems[0].message


def doubling(levels: int, last: dict[str, Any], count: int = 2) -> dict[str, Any]:
    """Prefabs each of which holds `count` copies of the next."""
    inner = {f"p{k}": {"generate": [{"id": "a", "place": f"p{k + 1}", "count": count}]} for k in range(levels)}
    return {**inner, f"p{levels}": last}


def test_many_copies_of_many_bodies_are_counted_first():
    prefab = {"bodies": [{"id": f"b{k}", **BALL} for k in range(500)]}
    assert told({"p": prefab}, {"id": "x", "place": "p", "count": 100_000}).startswith("the scene has more than 100000")
    assert told({"p": prefab}, {"id": "x", "row": "p", "count": 1000, "step": [1, 0]}).startswith("the scene has more")


def test_copies_of_copies(monkeypatch):
    monkeypatch.setattr(output, "MAX_BODIES", 1000)
    assert (
        told(doubling(12, BALL), {"id": "x", "place": "p0"})
        == "the scene has more than 1000 bodies, which is the limit"
    )


def test_copies_of_copies_are_counted_before_one_is_made():
    """1,000 to the power of 11: one by one, the first 100,000 took 17 s and 300 MB."""
    said = told(doubling(10, BALL, 1000), {"id": "x", "place": "p0", "count": 1000})
    assert said == "the scene has more than 100000 bodies, which is the limit"


def test_prefabs_that_are_too_deep_are_told_once():
    """However many copies of them there would be."""
    text = json.dumps({"prefabs": doubling(20, {"bodies": []}, 1000), "generate": [{"id": "x", "place": "p0"}]})
    with pytest.raises(SceneError) as caught:
        loads_scene(text)
    assert [each.message for each in caught.value.problems] == ["prefabs in prefabs, deeper than 16 levels"]


@given(
    st.lists(st.lists(st.tuples(st.integers(0, 9), st.sampled_from([1, 2, 3, "=2", "=i - 1"])), max_size=3), max_size=5)
)
@examples(100)
def test_the_least_that_a_copy_makes_is_not_more_than_it_makes(nested):
    """Each prefab holds a body and copies of those behind it."""
    prefabs = {
        f"p{k}": {
            "bodies": [{"id": "b", **BALL}],
            "generate": [
                {"id": f"g{n}", "place": f"p{k + 1 + at % (len(nested) - k)}", "count": count}
                for n, (at, count) in enumerate(copies)
            ],
        }
        for k, copies in enumerate(nested)
    }
    prefabs[f"p{len(nested)}"] = BALL
    document = Document("", {"prefabs": prefabs}, "", None)
    written = {name: Written(document, ("prefabs", name), prefab) for name, prefab in prefabs.items()}
    text = json.dumps({"prefabs": prefabs, "generate": [{"id": "x", "place": "p0"}]})
    try:
        made = len(loads_scene(text).flatten().bodies)
    except SceneError:
        return  # some expression gives no copy
    least = least_bodies(written, "p0")
    assert least <= made
    if all(isinstance(count, int) for copies in nested for _, count in copies):
        assert least == made


def test_copies_of_nothing(monkeypatch):
    monkeypatch.setattr(output, "MAX_VALUES", 20_000)
    said = told(doubling(12, {"bodies": []}, 10), {"id": "x", "place": "p0"})
    assert said == "the copies of prefabs have more than 20,000 values together, which is the limit"


def test_generators_in_copies_count_for_what_they_take(monkeypatch):
    """They are read anew in each of 400 copies, which takes longer than the one body that each makes."""
    monkeypatch.setattr(output, "MAX_VALUES", 20_000)
    one = {"params": {"n": 1}, "generate": [{"id": "g", "row": "q", "count": "=n", "step": [1, 0]}]}
    prefabs = {"q": BALL, "p": one}
    assert told(prefabs, {"id": "x", "place": "p", "count": 400}) == (
        "the copies of prefabs have more than 20,000 values together, which is the limit"
    )


def test_copies_of_nothing_are_counted_before_the_first():
    """A list of their names alone would take gigabytes."""
    said = told({"p": {"bodies": []}}, {"id": "x", "grid": "p", "columns": 3000, "rows": 100_000, "spacing": [1, 1]})
    assert said == "the copies of prefabs have more than 2,000,000 values together, which is the limit"


def test_joints_count_too(monkeypatch):
    monkeypatch.setattr(output, "MAX_JOINTS", 50)
    weld = {"id": "w", "type": "weld", "bodies": ["b"], "anchor": [0, 0]}
    said = told({"p": {"bodies": [{"id": "b", **BALL}], "joints": [weld]}}, {"id": "x", "place": "p", "count": 100})
    assert said == "the scene has more than 50 joints, which is the limit"


def test_differing_copies_of_a_large_body(monkeypatch):
    monkeypatch.setattr(output, "MAX_VALUES", 20_000)
    body = {"params": {"r": 1}, "shapes": [{"circle": "=r"}] * 200}
    said = told({"p": body}, {"id": "x", "place": "p", "count": 100, "params": {"r": "=i"}})
    assert said == "the copies of prefabs have more than 20,000 values together, which is the limit"


def test_prefabs_in_prefabs_end_somewhere():
    said = told(doubling(MAX_NESTING + 1, BALL, 1), {"id": "x", "place": "p0"})
    assert said == "prefabs in prefabs, deeper than 16 levels"
    said = told(doubling(1000, BALL, 1), {"id": "x", "place": "p0"})
    assert said == "prefabs in prefabs, deeper than 16 levels"
