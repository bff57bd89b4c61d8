"""Rows side by side: four rows of a table become vectors, field by field, and vectors become rows again."""

from __future__ import annotations

from typing import TypeAlias

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, load_fields, store_fields, transpose
from sandbox.tables import Integers, Records

Rows: TypeAlias = tuple[int, int, int, int]
"""A row of a table for each lane."""


@inlined_kernel
def rows_from(rows: Integers, first: int) -> Rows:
    """Four of a list of rows, from the one at `first` on. Behind the last one it comes again: to whom all are read
    before any is written, it makes no difference."""
    last = rows.shape[0] - 1
    return (
        rows[first],
        rows[first + 1 if first + 1 < last else last],
        rows[first + 2 if first + 2 < last else last],
        rows[first + 3 if first + 3 < last else last],
    )


@inlined_kernel
def gather_fields(table: Records, rows: Rows, first: int) -> tuple[Vector, Vector, Vector, Vector]:
    """Four fields of four rows, from the one with number `first` on: a vector for each field."""
    return transpose(
        load_fields(table, rows[0], first),
        load_fields(table, rows[1], first),
        load_fields(table, rows[2], first),
        load_fields(table, rows[3], first),
    )


@inlined_kernel
def scatter_fields(
    table: Records,
    rows: Rows,
    first: int,
    fields: tuple[Vector, Vector, Vector, Vector],
    first_lane: int,
    end_lane: int,
) -> None:
    """The other way, for the lanes first_lane..end_lane-1."""
    of_row = transpose(fields[0], fields[1], fields[2], fields[3])
    if first_lane <= 0 < end_lane:
        store_fields(table, rows[0], first, of_row[0])
    if first_lane <= 1 < end_lane:
        store_fields(table, rows[1], first, of_row[1])
    if first_lane <= 2 < end_lane:
        store_fields(table, rows[2], first, of_row[2])
    if first_lane <= 3 < end_lane:
        store_fields(table, rows[3], first, of_row[3])
