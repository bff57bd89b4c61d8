"""The contact tables of a step: the contacts found, those of the step before, and which of them are solved."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

SLEEPING_RUN = Table(
    "sleeping_run",
    (
        Field("first", "-", "row of its first contact", "i4"),
        Field("end", "-", "row after its last one", "i4"),
        Field("number", "-", "of its first contact; those of the others follow", "i4"),
    ),
)
"""Contacts among sleeping bodies, one after the other in a table of contacts."""

SLEEPING_CURSOR = Table(
    "sleeping_cursor",
    (
        Field("turn", "-", "0 or 1: which of the two tables of contacts is written", "i8"),
        Field("generation0", "-", "of the active set when table 0 was written; 0 if never", "i8"),
        Field("generation1", "-", "of the active set when table 1 was written", "i8"),
        Field("era0", "-", "era of the active set then; 0 if the runs do not hold", "i8"),
        Field("era1", "-", "", "i8"),
        Field("runs0", "-", "runs in table 0", "i8"),
        Field("runs1", "-", "runs in table 1", "i8"),
        Field("written", "-", "runs in the table under way", "i8"),
        Field("seams", "-", "those that follow another one, but not in number", "i8"),
        Field("next", "-", "number of the next contact that is first kept", "i8"),
        Field("known", "-", "runs of the old table, if they hold", "i8"),
        Field("old", "-", "next run of the old table", "i8"),
        Field("here", "-", "next run that is in the table under way from two steps ago", "i8"),
        Field("quiet", "-", "1 when nobody has woken or fallen asleep since the old table was written", "i8"),
        Field("same", "-", "1 when the runs of both tables hold", "i8"),
    ),
)
"""One row: how far the contacts among sleepers have been kept."""

KEPT = Table("kept", (Field("body_a", "-", "", "i4"), Field("body_b", "-", "", "i4")))
"""Whose contact has a number among those that are kept of sleepers."""

KEPT_LINK = Table(
    "kept_link",
    (
        Field("next_a", "-", "number of the contact that body a had before; -1 if none", "i4"),
        Field("next_b", "-", "the same of body b", "i4"),
        Field("shape_a", "-", "", "i4"),
        Field("shape_b", "-", "", "i4"),
    ),
)
"""The other contacts of those two bodies: each body has a list of all that were ever given a number."""

SLOT = Table(
    "slot",
    (
        Field("contact", "-", "row in the contact table", "i4"),
        Field("body_a", "-", "", "i4"),
        Field("body_b", "-", "", "i4"),
    ),
)
"""A contact in a list: most who go through one ask for no more than its bodies, and rows of contacts are large."""

REPORT = Table(
    "report",
    (
        Field("total_impulse", "N s", "normal impulse over the whole step, impacts included, both points"),
        Field("hit_speed", "m/s", "at which points that did not push before closed in during the step; 0 if none"),
    ),
)
"""What a contact did during the step; same row as the contact."""


class Contacts(NamedTuple):
    """Contacts `now` and those of the step `before`, both sorted by (shape_a, shape_b).

    `active[1:]` are the contacts with an active body, `impact_candidates[1:]` the rows of those of them that may have
    an impact; how many they are is `active[0].contact` and `impact_candidates[0]`. `cursor` (one row) and `runs` are of
    `sleeping_contacts`: the runs of the two tables and those of the walk, in thirds; `kept` and `links` have a row for
    each number, `first_kept` for each body the last number that a contact of it was given, -1 if none was.
    `calls` [worker, row, CODE or BLOCK] are the addresses of the machine code that the parts of a step call as each
    worker (`calls.py`) and of its arguments, zeros where the world does not need it, or where it is not compiled yet.
    """

    now: Records
    before: Records
    active: Records
    impact_candidates: Integers
    cursor: Records
    runs: Records
    kept: Records
    links: Records
    first_kept: Integers
    reports: Records
    calls: Integers
