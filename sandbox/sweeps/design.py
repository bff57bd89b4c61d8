"""Which values each run of a sweep has: every combination, or a random sample."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from sandbox.errors import ArgumentError
from sandbox.scene.splitmix import SplitMix64
from sandbox.sweeps.levels import Levels, Value, levels_of

MOST_RUNS = 1_000_000
"""Runs of one sweep."""
Values: TypeAlias = tuple[Value, ...]


@dataclass(frozen=True)
class Design:
    """The parameters of a sweep, `paths`, and the values that each run gives them."""

    paths: tuple[str, ...]
    runs: tuple[Values, ...]


def grid(vary: Mapping[str, Any]) -> Design:
    """Every combination; the last parameter varies fastest. Raises `ArgumentError`."""
    levels = [levels_of(path, given) for path, given in vary.items()]
    count = math.prod(map(len, levels))
    if count > MOST_RUNS:
        shape = " x ".join(f"{len(each):,}" for each in levels)
        mend = "--sample N takes N of them at random"
        raise ArgumentError(f"{shape} values are {count:,} runs; at most {MOST_RUNS:,} are made: {mend}")
    return Design(tuple(vary), tuple(_combination(levels, number) for number in range(count)))


def _combination(levels: list[Levels], number: int) -> Values:
    values: list[Value] = []
    for each in reversed(levels):
        number, index = divmod(number, len(each))
        values.append(each.at(index))
    return tuple(reversed(values))


def sample(vary: Mapping[str, Any], count: int, seed: int) -> Design:
    """`count` runs, each parameter drawn at random from its range or list, by SplitMix64 from `seed`.

    A longer sample begins with the runs of a shorter one. Raises `ArgumentError`.
    """
    if count > MOST_RUNS:
        raise ArgumentError(f"a sample of {count:,} runs; at most {MOST_RUNS:,} are made")
    levels = [levels_of(path, given, drawn=True) for path, given in vary.items()]
    random = SplitMix64(seed)
    return Design(tuple(vary), tuple(tuple(each.drawn(random) for each in levels) for _ in range(count)))
