"""Where cards lie in the list of scenes, and which one an arrow key leads to. Pure: knows no window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby


@dataclass(frozen=True)
class Row:
    """Cards beside each other, by number; `headings` are those of themes that begin here, by column."""

    cards: tuple[int, ...]
    headings: tuple[tuple[int, str], ...]


def card_rows(themes: Sequence[str], columns: int) -> list[Row]:
    """Rows of at most `columns` cards; neighbours with the same theme stand under one heading.

    A theme begins in the row of the one before where all of it has room there, else in a new row. The theme "" has no
    heading.
    """
    rows: list[Row] = []
    for theme, group in groupby(range(len(themes)), key=lambda number: themes[number]):
        numbers = tuple(group)
        taken = len(rows[-1].cards) if rows else columns
        if taken + len(numbers) <= columns:
            last = rows.pop()
            rows.append(Row(last.cards + numbers, (*last.headings, (taken, theme)) if theme else last.headings))
            continue
        for start in range(0, len(numbers), columns):
            rows.append(Row(numbers[start : start + columns], () if start or not theme else ((0, theme),)))
    return rows


def move(rows: Sequence[Row], card: int, right: int, down: int) -> int:
    """The card `right` places on in reading order or `down` rows below; stops at the ends."""
    at = next(i for i, row in enumerate(rows) if card in row.cards)
    column = rows[at].cards.index(card)
    row = rows[min(max(at + down, 0), len(rows) - 1)]
    landed = row.cards[min(column, len(row.cards) - 1)]
    last = rows[-1].cards[-1]
    return min(max(landed + right, 0), last)
