"""Damaged scenes: a scene or a `SceneError`; a world of moderate size is made, and takes a few steps if it is small."""

from __future__ import annotations

from functools import cache
from random import Random
from typing import Any

import numpy as np

from sandbox.engine.world import World
from sandbox.errors import CapacityError, SceneError
from sandbox.scene import loads_scene
from tests.fuzz.mutations import damaged_text
from tests.shipped import FILES, shipped

MOST_BODIES, MOST_BYTES = 60, 6_000
"""Larger scenes take no steps, and are not read."""
MOST_BUILT = 4_000
"""Larger scenes are only read."""


@cache
def sources() -> dict[str, Any]:
    """The shipped scenes with short files, as plain data."""
    names = [name for name, file in FILES.items() if file.stat().st_size <= MOST_BYTES]
    return {name: shipped(name).to_data() for name in names}


def warm() -> None:
    """Compile and load what cases need."""
    for name in sources():
        if len(shipped(name).flatten().bodies) <= MOST_BODIES:
            World(shipped(name)).step(2)


def make(random: Random) -> dict[str, Any]:
    """The text of a scene, and how many steps it takes."""
    name = random.choice(list(sources()))
    return {"text": damaged_text(random, sources()[name]), "steps": 3 if random.random() < 0.1 else 0}


def run(case: dict[str, Any]) -> int:
    """Load it and step; returns how many bodies and joints there are."""
    try:
        scene = loads_scene(case["text"])
    except SceneError as error:
        check_message(error)
        return 0
    flat = scene.flatten()
    rows = len(flat.bodies) + len(flat.joints)
    if case["steps"] and rows <= MOST_BUILT:
        try:
            world = World(scene)
            world.step(case["steps"] if rows <= MOST_BODIES else 0)
        except CapacityError:
            return rows
        check_finite(world)
    return rows


def check_message(error: SceneError) -> None:
    """One error that a person can read, on any terminal."""
    text = str(error)
    assert error.problems
    assert len(text) < 60_000, f"a message of {len(text)} characters"
    text.encode("utf-8")
    assert "Traceback" not in text
    assert not any(noise in text for noise in ("Input should", "Extra inputs", "Value error", "pydantic"))


def check_finite(world: World) -> None:
    """Every number of what moves is one."""
    for table in (world.state.bodies, world.contacts, world.state.drags):
        for name in table.dtype.names or ():
            assert np.isfinite(table[name]).all(), f"{name} is not finite"
