"""Garbage collection waits while a scene is read, a world built, and bodies spawned, and goes on afterwards."""

from __future__ import annotations

import gc
import json
from collections.abc import Iterator

import pytest

from sandbox import CommandError, Scene, World
from sandbox._collecting import collection_postponed
from sandbox.scene.load import loads_scene

DISCS = [{"id": f"disc-{k}", "shapes": [{"circle": 0.4}], "position": [k, 0]} for k in range(3000)]


@pytest.fixture
def collections() -> Iterator[list[str]]:
    """A mark for each time that Python begins to look for garbage."""
    seen: list[str] = []

    def note(phase: str, _info: dict[str, int]) -> None:
        seen.append(phase)

    gc.callbacks.append(note)
    yield seen
    gc.callbacks.remove(note)


def test_none_is_collected_for_what_a_scene_brings(collections: list[str]) -> None:
    text = json.dumps({"bodies": DISCS})
    gc.collect()
    for make in (lambda: loads_scene(text), lambda: World(Scene()).spawn(DISCS)):
        collections.clear()
        make()
        assert len(collections) <= 4, "a start and a stop each time: after all, and perhaps before"
        assert gc.isenabled()


def test_it_goes_on_after_a_mistake() -> None:
    world = World(Scene())
    with pytest.raises(CommandError):
        world.spawn([{"id": "a", "shapes": [{"circle": -1}]}])
    assert gc.isenabled()


def test_who_has_it_off_keeps_it_off() -> None:
    gc.disable()
    try:
        with collection_postponed():
            assert not gc.isenabled()
        assert not gc.isenabled()
    finally:
        gc.enable()
