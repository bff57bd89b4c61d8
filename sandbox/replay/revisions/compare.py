"""Two traces laid side by side: the first step after which they differ, and there the first number."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from types import SimpleNamespace
from typing import Any

import numpy as np

from sandbox.replay.golden.differences import INDICES, differences, first_group
from sandbox.replay.golden.divergence import Divergence, Growth
from sandbox.replay.golden.side_by_side import COUNTED, farthest
from sandbox.replay.recording.fingerprint import GROUPS, group_of
from sandbox.replay.revisions.trace import TABLES, Trace

Tracer = Callable[[Collection[int]], Trace]
"""Runs again, and dumps the tables after some steps."""

_CONTACT_INDICES = ("contacts.body_a", "contacts.body_b", "contacts.shape_a", "contacts.shape_b")


@dataclass(frozen=True)
class Frozen:
    """A dumped state that looks like a world to who compares."""

    trace: Trace
    step: int
    shared: frozenset[str]

    @property
    def names(self) -> tuple[str, ...]:
        """The ids of the bodies."""
        return self.trace.names(self.step)

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The ids of the joints."""
        return self.trace.names(self.step, "joint_names")

    @cached_property
    def state(self) -> Any:
        """The tables, with nothing in columns that only one of the two has."""
        return SimpleNamespace(**{name: self.trace.rows(self.step, name, self.shared) for name in TABLES})

    @property
    def contacts(self) -> Any:
        """The contacts in use."""
        return self.state.contacts


@dataclass(frozen=True)
class Parting:
    """The first step after which two traces differ, the group, and the checksums of the first column that does."""

    step: int
    group: str
    expected: str
    got: str


def first_parting(expected: Trace, got: Trace) -> Parting | None:
    """Where two traces part, by the columns that both have; None if they do not."""
    shared = sorted((name for name in _shared(expected, got) if _counts(name)), key=_rank)
    if not shared:
        return Parting(0, "rest", "tables", "none in common")
    one, two = (trace.codes[:, [trace.columns.index(name) for name in shared]] for trace in (expected, got))
    places = np.argwhere(one != two)
    if not len(places):
        return None
    step, column = (int(value) for value in places[0])
    return Parting(step, _group(shared[column]), f"{one[step, column]:08x}", f"{two[step, column]:08x}")


def lay_side_by_side(
    expected: Trace, got: Trace, steps: int, rate: float, again: tuple[Tracer, Tracer]
) -> Divergence | None:
    """Where and how two traces part; `again` runs each once more to dump the tables that are needed."""
    found = first_parting(expected, got)
    if found is None:
        return None
    ahead = [found.step + 2**k for k in range(steps.bit_length()) if found.step + 2**k < steps]
    wanted = list(dict.fromkeys([found.step, *ahead, steps]))
    shared = frozenset(_shared(expected, got))
    one, two = (run(wanted) for run in again)
    return _divergence(found, rate, [(Frozen(one, k, shared), Frozen(two, k, shared)) for k in wanted])


def _divergence(parting: Parting, rate: float, pairs: list[tuple[Any, Any]]) -> Divergence:
    one, two = pairs[0]
    group = first_group(one, two) or parting.group
    found = list(islice(differences(group, one, two), COUNTED))
    detail = found[0] if found else None
    growth = tuple(Growth(a.step, *farthest(a, b)) for a, b in pairs)
    step, others = parting.step, max(0, len(found) - 1)
    return Divergence(step, step / rate, group, parting.expected, parting.got, detail, others, growth)


def _shared(a: Trace, b: Trace) -> list[str]:
    known = [f"{name}.{field}" for name, table in TABLES.items() for field in table.hashed_fields]
    return [name for name in known if name in a.columns and name in b.columns]


def _counts(column: str) -> bool:
    """Row numbers do not: a body more would change them all. Those of contacts say which pairs there are."""
    return column.partition(".")[2] not in INDICES or column in _CONTACT_INDICES


def _group(column: str) -> str:
    table, _, field = column.partition(".")
    return group_of(TABLES[table], field)


def _rank(column: str) -> int:
    return (*GROUPS, "rest").index(_group(column))
