"""A region as an entry of a file, with the settings and the schedule of now."""

from __future__ import annotations

from math import inf
from typing import Any

from sandbox.scene.regions import REGIONS, Region
from sandbox.world.export.numbers import pair
from sandbox.world.export.present import Present
from sandbox.world.export.schedule_words import write_schedule
from sandbox.world.region_area import box_of, corners_of, disc_of, level_of
from sandbox.world.region_columns import columns_of


def written_region(present: Present, index: int) -> Region:
    """The region of that row; it is the author's own object if nothing has changed."""
    author = _as_it_came(present, index)
    row, first = present.state.regions[index], present.start.regions[index]
    before = author.to_data()
    words = dict(before)
    for field, columns in columns_of(row).items():
        values = [row[column].item() for column in columns]
        if values != [first[column].item() for column in columns]:
            words[field] = pair(*values) if len(values) == 2 else values[0]
    if words.get("range") == inf:
        del words["range"]
    _write_area(present, words, index)
    if "water" in words:
        _write_water(present, words, index)
    write_schedule(present, words, row, first, author.id or "")
    return author if words == before else REGIONS[next(iter(columns_of(row)))](**words)


def _write_area(present: Present, words: dict[str, Any], index: int) -> None:
    """Where it is now, if that is elsewhere than at first."""
    state, start = present.state, present.start
    disc, corners, box = disc_of(state, index), corners_of(state, index), box_of(state, index)
    if disc != disc_of(start, index) and disc is not None:
        words["disc"] = list(disc)
    if corners != corners_of(start, index):
        words.pop("inside", None)
        words.pop("outline", None)
        words |= {"inside": list(box)} if box is not None else {"outline": [list(corner) for corner in corners]}


def _as_it_came(present: Present, index: int) -> Region:
    """The entry that a region came with: of the scene, or spawned."""
    ledger = present.state.census.regions
    serial = ledger.serials[index]
    if serial < len(present.scene.regions):
        return present.scene.regions[serial]
    words = ledger.words[serial]
    return REGIONS[next(kind for kind in REGIONS if kind in words)](**words)


def _write_water(present: Present, words: dict[str, Any], index: int) -> None:
    """What is not in a column of its own, or follows another one unless it is given."""
    row = present.state.regions[index]
    if "angular_drag" not in words and row.angular_drag != row.drag:
        words["angular_drag"] = float(row.angular_drag)
    if words.get("surface") is not None:
        words["surface"] = level_of(present.state, index)
