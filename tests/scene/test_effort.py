"""Small files that would take all time or all memory: refused at once, in words that are no longer than needed."""

from __future__ import annotations

import json
import math
import time
import tracemalloc
from typing import Any

import pytest

from sandbox.errors import SandboxError, SceneError, UnknownBodyError
from sandbox.scene import Scene, loads_scene
from sandbox.scene.limits import MAX_ALIKE
from sandbox.world.build import build_state
from sandbox.world.directory import Directory
from tests.flat import body, circle, scene

SECONDS = 4.0
"""Processor time; each of these takes a few tenths, and took 8 seconds to minutes."""
BYTES = 200_000_000
PREFABS = {"link": {"shapes": [{"box": [1, 0.2]}]}}
BALL = [{"circle": 1}]


def bodies(count: int, name: str = "body-number-{}") -> list[dict[str, Any]]:
    return [{"id": name.format(k), "shapes": BALL, "position": [3 * k, 0]} for k in range(count)]


def crossing(turn: int) -> list[list[float]]:
    """A polygon that crosses itself hundreds of times."""
    return [[(1 + k % 3) * math.cos(7.1 * k + turn), (1 + k % 3) * math.sin(7.1 * k + turn)] for k in range(1000)]


CASES: dict[str, Any] = {
    "a pattern of brackets": {"bodies": bodies(5), "expect": [{"at": 1, "rests": "[" * 20_000}]},
    "an id as long as a book": {
        "prefabs": PREFABS, "generate": [{"id": "x" * 100_000, "chain": "link", "count": 100_000}]
    },
    "many chains": {
        "prefabs": PREFABS, "generate": [{"id": f"g{k}", "chain": "link", "count": 100_000} for k in range(300)]
    },
    "wrong bodies of joints": {
        "bodies": bodies(1000),
        "joints": [{"id": f"j{k}", "type": "weld", "bodies": [f"bodi-numbre-{k}"]} for k in range(1000)],
    },
    "wrong prefabs": {
        "prefabs": {f"prefab-{k}": {"shapes": BALL} for k in range(1000)},
        "bodies": [{"id": f"b{k}", "prefab": f"perfab-{k}"} for k in range(1000)],
    },
    "patterns for many bodies": {
        "prefabs": PREFABS, "generate": [{"id": "r", "row": "link", "count": 20_000}],
        "expect": [{"at": 1, "rests": [f"*{k}-{n}*" for n in range(100)]} for k in range(300)],
    },
    "no room": {
        "prefabs": PREFABS, "generate": [{"id": "s", "scatter": "link", "count": 100_000, "inside": [0, 0, 9, 9]}]
    },
    "no room in many places": {
        "prefabs": PREFABS,
        "generate": [{"id": f"s{k}", "scatter": "link", "count": 90, "inside": [0, 0, 2, 2]} for k in range(500)],
    },
    "generators that cannot be read": {
        "prefabs": PREFABS, "generate": [{"id": f"g{k}", "row": "link", "count": 0} for k in range(3000)],
        "joints": [{"id": f"j{k}", "type": "weld", "bodies": [f"x{k}", f"y{k}"]} for k in range(10_000)],
    },
    "polygons that cross themselves": {
        "bodies": [{"id": f"b{k}", "shapes": [{"polygon": crossing(k)}]} for k in range(40)]
    },
}  # fmt: skip


@pytest.mark.parametrize("data", CASES.values(), ids=CASES)
def test_it_is_refused_in_time(data: dict[str, Any]) -> None:
    text = json.dumps(data)
    began = time.process_time()
    with pytest.raises(SceneError) as caught:
        loads_scene(text)
    assert time.process_time() - began < SECONDS
    assert len(str(caught.value)) < 10_000


@pytest.mark.parametrize("name", ["an id as long as a book", "many chains"])
def test_it_is_refused_before_memory_is_taken(name: str) -> None:
    text = json.dumps(CASES[name])
    tracemalloc.start()
    try:
        with pytest.raises(SceneError):
            loads_scene(text)
        assert tracemalloc.get_traced_memory()[1] < BYTES
    finally:
        tracemalloc.stop()


def test_equal_mistakes_are_counted() -> None:
    data = {"bodies": [{"id": f"b{k}", "shapes": [{"circle": -k}]} for k in range(1, 1501)]}
    for build in (lambda: loads_scene(json.dumps(data)), lambda: Scene(**data)):
        with pytest.raises(SandboxError) as caught:
            build()
        assert str(caught.value).count("must not be below") == MAX_ALIKE + 1
        assert "and at least 1490 more like this" in str(caught.value)


def test_the_first_wrong_names_still_get_a_hint() -> None:
    with pytest.raises(SceneError) as caught:
        loads_scene(json.dumps(CASES["wrong bodies of joints"]))
    assert 'did you mean "body-number-0"?' in str(caught.value)


def test_one_wrong_name_in_a_large_world_is_told_in_time() -> None:
    ball = (circle(0.5),)
    directory = Directory(
        build_state(scene(*(body(f"body-{k}", *ball, position=(2.0 * k, 0.0)) for k in range(20_000))))
    )
    began = time.process_time()
    with pytest.raises(UnknownBodyError, match="did you mean 'body-7'"):
        directory.body("bodi-7")
    with pytest.raises(UnknownBodyError):
        directory.body("x" * 1_000_000)
    assert time.process_time() - began < SECONDS / 10
