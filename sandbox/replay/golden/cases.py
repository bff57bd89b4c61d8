"""Which recordings and scenes are meant by paths: `x.replay.json` stands beside `x.scene.json`."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from sandbox._bounded_read import read_ahead, read_bytes
from sandbox._lent import is_lent
from sandbox.replay.recording.limits import MAX_BYTES, SUFFIX
from sandbox.resources import SCENE_SUFFIX, files_below, find_scene


@dataclass(frozen=True)
class Case:
    """A recording at `replay`; where that is missing, the `scene` it should be of."""

    replay: Path
    scene: Path | None = None


def find_cases(paths: Iterable[Path], only: str = "") -> list[Case]:
    """What is meant by files and folders, each once, in order; `only` keeps paths with that text in them.

    In a folder: every recording, and every scene that expects something and has no recording beside it; not in hidden
    folders and virtual environments.
    """
    found = (case for path in paths for case in _cases_of(path))
    return [case for case in dict.fromkeys(found) if only in case.replay.as_posix()]


def shard(cases: list[Case], number: int, count: int) -> list[Case]:
    """Part `number` (from 1) of `count`: every count-th case."""
    return cases[number - 1 :: count]


def replay_beside(scene: Path) -> Path:
    """Where the recording of a scene file stands."""
    return scene.with_name(scene.name.removesuffix(SCENE_SUFFIX).removesuffix(".json") + SUFFIX)


def _cases_of(path: Path) -> Iterator[Case]:
    if not os.path.isdir(path):
        read_ahead(path, MAX_BYTES)
        path = find_scene(path)
        yield _of_replay(path) if path.name.endswith(SUFFIX) or is_lent(path) else _of_scene(path)
        return
    replays = [Case(file) for file in files_below(path, SUFFIX)]
    scenes = (_of_scene(file) for file in files_below(path, SCENE_SUFFIX))
    missing = [case for case in scenes if case.scene is not None and expects(case.scene)]
    yield from sorted([*replays, *missing], key=lambda case: case.replay)


def _of_replay(replay: Path) -> Case:
    scene = replay.with_name(replay.name.removesuffix(SUFFIX) + SCENE_SUFFIX)
    return Case(replay, scene) if os.path.isfile(scene) and not os.path.exists(replay) else Case(replay)


def _of_scene(scene: Path) -> Case:
    replay = replay_beside(scene)
    return Case(replay) if os.path.exists(replay) else Case(replay, scene)


def expects(scene: Path) -> bool:
    """Whether a scene says what must hold; one that cannot be read counts, so that its mistakes come to light."""
    try:
        data = json.loads(read_bytes(scene, MAX_BYTES))
    except (OSError, ValueError, RecursionError):
        return True
    return not isinstance(data, dict) or bool(data.get("expect"))
