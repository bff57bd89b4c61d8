"""The shapes of a body as entries of a file, with the surfaces of now."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from sandbox.scene.flat_shapes import flat_shapes
from sandbox.scene.prefab import Prefab
from sandbox.world.export.present import Present
from sandbox.world.records import SURFACE

Words = dict[str, Any]


def shape_words(present: Present, row: int, words: Words, pattern: Mapping[str, Any]) -> list[Words]:
    """All shapes of a body; what has changed of their surfaces is written on them."""
    rows = slice(*np.searchsorted(present.state.shapes.body, (row, row + 1)).tolist())
    now, first = present.state.shapes[rows], present.start.shapes[rows]
    entries = [dict(entry) for entry in words.get("shapes", pattern["shapes"])]
    begin = 0
    for entry, shape in zip(entries, Prefab.model_validate({"shapes": entries}).shapes, strict=True):
        count = sum(1 for _ in flat_shapes(shape, None, present.scene.categories))
        part = slice(begin, begin + count)
        _write_surface(present, entry, now[part], first[part], words["id"])
        begin += count
    return entries


def _write_surface(present: Present, entry: Words, now: Any, first: Any, name: str) -> None:
    """The surface of a shape, which may be several in the world: parts of a polygon, links of a chain."""
    for field in SURFACE:
        changed = now[field] != first[field]
        if not changed.any():
            continue
        value = float(now[field][changed][0])
        if (now[field] != value).any():
            present.remarks.note(f"parts of one shape cannot differ: all of it has the new {field}", name)
        entry[field] = value
        if field == "restitution" and value > 1.0:
            entry["bumper"] = True
