"""Damaged recordings and lists of commands: read, or one `RecordingError`."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any

import sandbox
from sandbox.errors import SceneError
from sandbox.replay.recording.read import loads_recording
from tests.fuzz.mutations import damaged_text
from tests.fuzz.scenes import check_message
from tests.shipped import shipped


@cache
def _sources() -> list[Any]:
    """Recordings with their scenes inside, as plain data: with commands of most kinds."""
    plans: dict[str, list[Any]] = {
        "gears-and-pulley": [(1, sandbox.SetGravity((0.0, -5.0)))],
        "harbour": [(0, sandbox.Explode((0.0, 1.0), 3.0, 5.0)), (2, sandbox.SetGravity((1.0, -5.0)))],
        "three-to-one": [(1, sandbox.Spawn([{"id": "late", "shapes": [{"circle": 0.5}], "position": [0, 30]}]))],
        "zigzag": [],
    }
    found = []
    with TemporaryDirectory() as folder:
        for name, commands in plans.items():
            path = Path(folder) / f"{name}.replay.json"
            sandbox.record(shipped(name), 4, commands).save(path, embed=True)
            found.append(json.loads(path.read_text(encoding="utf-8")))
    return found


def warm() -> None:
    """Compile and load what cases need."""
    for source in _sources():
        run({"text": json.dumps(source)})


def make(random: Random) -> dict[str, Any]:
    """The text of a recording."""
    return {"text": damaged_text(random, random.choice(_sources()))}


def run(case: dict[str, Any]) -> int:
    """Read it; returns how many bodies its scene has."""
    try:
        found = loads_recording(case["text"], Path("some.replay.json"))
    except SceneError as error:
        check_message(error)
        return 0
    return len(found.final)
