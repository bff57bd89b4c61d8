"""Which events a rule is followed on: looked up by id, they are those that going through all of them finds."""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.rules.occasions import Happened, Pair, Waiting
from sandbox.scene.flat_rules import FlatRule, FlatTrigger

IDS = ("floor", "ball-1", "ball-2", "crate")
NAMES = st.lists(st.sampled_from((*IDS, "ball-*", "*", "nobody")), min_size=1, max_size=3, unique=True).map(tuple)
PAIRS = st.lists(
    st.tuples(st.sampled_from(IDS), st.sampled_from(IDS), st.floats(0.0, 9.0), st.floats(0.0, 9.0)), max_size=12
)


class Told(Happened):
    """Events that are given."""

    def __init__(self, pairs: list[Pair]) -> None:
        nothing: Any = None
        super().__init__(nothing, (nothing, nothing))
        self._known = dict.fromkeys(("hit", "enter"), pairs)


def _means(names: tuple[str, ...], name: str) -> bool:
    return any(fnmatchcase(name, each) for each in names)


@given(PAIRS, st.lists(st.tuples(NAMES, NAMES), min_size=1, max_size=4), st.sampled_from(("hit", "enter")))
def test_events_looked_up_by_id_are_those_found_by_going_through_all(
    pairs: list[Pair], sides: list[tuple[tuple[str, ...], tuple[str, ...]]], kind: str
) -> None:
    happened = Told(pairs)
    for first, second in sides:
        wanted = []
        for a, b, speed, _ in pairs:
            if kind == "hit" and speed < 2.0:
                continue
            if _means(first, a) and _means(second, b):
                wanted.append((a, b))
            elif kind == "hit" and _means(first, b) and _means(second, a):
                wanted.append((b, a))
        rule = FlatRule(FlatTrigger(kind, first=first, second=second, speed=2.0), ())
        found = Waiting(rule, 60.0).occasions(happened, 1)
        assert [(each.first, each.second) for each in found] == wanted
