"""Whole tiles side by side as few boxes: fewer shapes, and no seams."""

from __future__ import annotations

from collections.abc import Iterable

Box = tuple[int, int, int, int]
"""First column and row, and how many of each."""


def merged(cells: Iterable[tuple[int, int]]) -> list[Box]:
    """Boxes that cover exactly these (column, row) cells: runs along rows, joined where they are alike below."""
    rows: dict[int, list[int]] = {}
    for column, row in cells:
        rows.setdefault(row, []).append(column)
    growing: dict[tuple[int, int], Box] = {}
    done: list[Box] = []
    for row in sorted(rows):
        runs = _runs(sorted(set(rows[row])))
        kept: dict[tuple[int, int], Box] = {}
        for column, width in runs:
            above = growing.pop((column, width), None)
            extends = above is not None and above[1] + above[3] == row
            top = above[1] if above is not None and extends else row
            if above is not None and not extends:
                done.append(above)
            kept[column, width] = (column, top, width, row - top + 1)
        done += growing.values()
        growing = kept
    return sorted([*done, *growing.values()], key=lambda box: (box[1], box[0]))


def _runs(columns: list[int]) -> list[tuple[int, int]]:
    found: list[tuple[int, int]] = []
    for column in columns:
        if found and found[-1][0] + found[-1][1] == column:
            found[-1] = (found[-1][0], found[-1][1] + 1)
        else:
            found.append((column, 1))
    return found
