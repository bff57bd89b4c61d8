"""The path of a driven body as a file holds it, with the time to which it has come: place and motion follow from it."""

from __future__ import annotations

from typing import Any

from sandbox.scene.flat_body import FlatPath
from sandbox.world.export.present import Present
from sandbox.world.export.schedule_words import LAST

Words = dict[str, Any]


def path_words(present: Present, index: int, entry: Words) -> Words:
    """The path in that row of the path table, which came with such an entry."""
    row, first = present.state.paths[index], present.start.paths[index]
    body, path = int(row.body), present.state.census.bodies.items[int(row.body)].path
    assert path is not None
    found = dict(entry)
    if row.steps != first.steps:
        found["time"] = _time(path, int(row.steps) / present.step_rate)
    if row.enabled != first.enabled:
        found["enabled"] = bool(row.enabled)
    _note_strays(present, body, row, path)
    return found


def _time(path: FlatPath, seconds: float) -> float:
    """Of a longer time than a scene may say, what is left after whole rounds, or all of a path that has an end."""
    return seconds if seconds <= LAST else seconds % path.times[-1] if path.loops else LAST


def _note_strays(present: Present, body: int, row: Any, path: FlatPath) -> None:
    """A body that was put elsewhere is back on its path after a step."""
    seconds = float(present.state.settings[0].step_seconds)
    x, y, angle = path.after(int(row.steps) * seconds)
    due = row.origin_x + x, row.origin_y + y, row.origin_angle + angle
    here = present.state.bodies[body]
    if (here.position_x, here.position_y, here.angle) != due:
        present.remarks.note("bodies that were put beside their paths begin on them", present.state.names[body])
