"""How an expectation names bodies: by id, by a list of ids, by patterns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fnmatch import translate
from typing import Annotated

from pydantic import Field, Tag

from sandbox.scene.constraints import Listed
from sandbox.scene.limits import MAX_NAME
from sandbox.scene.union import TAG, by_type

Pattern = Annotated[str, Field(min_length=1, max_length=MAX_NAME)]
"""A body's id, or a pattern for all matching ids: `*` is anything, `?` one character, `[...]` one of some."""

Ids = Annotated[
    Annotated[Pattern, Tag(TAG + "text")]
    | Annotated[Annotated[tuple[Pattern, ...], Listed('["id", ...]', 1, 100)], Tag(TAG + "list")],
    by_type('a body id, a list of ids, or a pattern such as "wall-*"'),
]
"""One id, a list of ids, or patterns: all bodies meant."""

Pair = Annotated[tuple[Pattern, Pattern], Listed('["id", "id"]', 2, 2)]

BODY_FIELDS = ("rests", "stands", "asleep", "touches", "apart", "senses", "of")
"""The fields of expectations that name bodies."""


def is_pattern(name: str) -> bool:
    """Whether `name` stands for all ids it matches rather than for one id."""
    return any(mark in name for mark in "*?[")


def matches_any(pattern: str, names: Iterable[str]) -> bool:
    """Whether a pattern means at least one of `names`."""
    match = re.compile(translate(pattern)).match
    return any(match(name) for name in names)


def matching_ids(ids: str | Sequence[str], names: Sequence[str]) -> list[str]:
    """Those of `names` that an `Ids` field means, in the order of `names`."""
    wanted = [ids] if isinstance(ids, str) else list(ids)
    exact = {name for name in wanted if not is_pattern(name)}
    patterns = [re.compile(translate(name)) for name in wanted if is_pattern(name)]
    return [name for name in names if name in exact or any(pattern.match(name) for pattern in patterns)]


def unmatched(ids: str | Sequence[str], names: Sequence[str]) -> list[str]:
    """Those ids and patterns that mean none of `names`."""
    wanted = [ids] if isinstance(ids, str) else list(ids)
    return [name for name in wanted if not (matches_any(name, names) if is_pattern(name) else name in names)]
